#include "harness/cli/metered.hpp"

#include "scene/stopwatch.hpp"

namespace rasterdiff::harness::cli {

Result<Frame> MeteredSubject::render(const Scene& scene) {
  Stopwatch watch;
  Result<Frame> frame = subject_.render(scene);
  Seconds one;
  one.driver = watch.lap();
  one.parts.drawing = one.driver;
  const std::optional<DriverSeconds> parts = subject_.driverSeconds();
  if (frame && parts) one.parts = *parts;
  seconds_ += one;
  return frame;
}

}  // namespace rasterdiff::harness::cli
