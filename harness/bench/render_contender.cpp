// The reference's exact path, as `check` uses it, as a contender.
#include <fmt/format.h>

#include <memory>

#include "harness/bench/contender.hpp"
#include "harness/bench/machine.hpp"
#include "rasterizer/render.hpp"

namespace rasterdiff::harness::bench {
namespace {

Result<Frame> rendered(const Scene& scene) {
  const Result<rasterizer::Rules> rules = rasterizer::Rules::profile("reference", Limits{});
  if (!rules) return tl::unexpected(rules.error());
  return rasterizer::render(scene, *rules);
}

const char* planesOf(Task task) {
  switch (task) {
    case Task::Coverage: return "the reference as check runs it: index and count";
    case Task::Depth: return "the reference as check runs it: index, count, depth with bounds";
    case Task::Varyings: return "the reference as check runs it: index, count, depth and inputs with bounds";
  }
  return "";
}

}  // namespace

Result<Contender> renderContender(const Load& load, Task task, const Truth& truth, const Settings& settings, Frame& expected) {
  Result<Frame> frame = rendered(sceneOf(load, task, truth.triangles()));
  if (!frame) return tl::unexpected(frame.error());
  const bool judged = !expected.primitive.data.empty();
  Contender contender;
  contender.mostSeconds = settings.frameSeconds;
  contender.fixedParts = settings.fixedParts;
  contender.wholeSeconds = settings.frameWhole;
  contender.whole = load.scene.has_value();
  Row row;
  row.task = task;
  row.method = "render";
  row.what = planesOf(task);
  row.exact = true;
  if (judged) {
    row.error = difference(expected, *frame);
    row.error->triangles = truth.triangles();
    if (task == Task::Coverage && row.error->wrong > 0)
      row.refused = fmt::format("{} wrong samples in an exact method", row.error->wrong);
  } else {
    expected = std::move(*frame);
  }
  contender.rows.push_back(std::move(row));
  struct Kept {
    Scene scene;
    size_t triangles = 0;
  };
  const auto kept = std::make_shared<Kept>();
  contender.draw = [&load, task, kept](size_t triangles) -> Result<std::vector<double>> {
    if (kept->triangles != triangles) *kept = {sceneOf(load, task, triangles), triangles};
    Result<Frame> drawn;
    const double seconds = secondsOf([&] { drawn = rendered(kept->scene); });
    if (!drawn) return tl::unexpected(drawn.error());
    return std::vector<double>{seconds};
  };
  contender.peak = [&load, task](size_t triangles) {
    const Scene scene = sceneOf(load, task, triangles);
    const PeakMeter meter;
    (void)rendered(scene);
    return meter.growth();
  };
  return contender;
}

}  // namespace rasterdiff::harness::bench
