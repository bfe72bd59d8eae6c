#include "harness/cli/metered.hpp"

#include <algorithm>

#include "scene/stopwatch.hpp"

namespace rasterdiff::harness::cli {

Result<Frame> MeteredSubject::render(const Scene& scene) {
  Stopwatch watch;
  Result<Frame> frame = subject_.render(scene);
  add(watch.lap(), frame.has_value());
  return frame;
}

std::vector<Result<Frame>> MeteredSubject::renderTogether(std::span<const Scene> scenes) {
  Stopwatch watch;
  std::vector<Result<Frame>> frames = subject_.renderTogether(scenes);
  add(watch.lap(), std::ranges::any_of(frames, [](const Result<Frame>& frame) { return frame.has_value(); }));
  return frames;
}

void MeteredSubject::add(double seconds, bool drew) {
  Seconds one;
  one.driver = one.parts.drawing = seconds;
  const std::optional<DriverSeconds> parts = subject_.driverSeconds();
  if (drew && parts) one.parts = *parts;
  seconds_ += one;
}

}  // namespace rasterdiff::harness::cli
