#include <algorithm>
#include <cmath>
#include <span>

#include "harness/compare/compare.hpp"
#include "harness/stability/measure.hpp"
#include "rasterizer/render.hpp"

namespace rasterdiff::harness::stability {
namespace {

uint64_t notFinite(const Frame& frame) {
  uint64_t count = 0;
  const auto add = [&count](std::span<const float> values) {
    count += static_cast<uint64_t>(std::ranges::count_if(values, [](float v) { return !std::isfinite(v); }));
  };
  if (frame.depth) add(frame.depth->data);
  for (const VaryingPlane& plane : frame.varyings) add(plane.values.data);
  return count;
}

}  // namespace

bool isBroken(const Series& series, const Point& point) {
  return point.wrong > 0 || point.notFinite > 0 || (series.values && !series.judged && point.maxUlp > kLostUlp);
}

std::optional<double> breaksAt(const Series& series) {
  const auto first = std::ranges::find_if(series.points, [&](const Point& point) { return isBroken(series, point); });
  return first == series.points.end() ? std::nullopt : std::optional(first->dial);
}

Result<std::vector<Series>> measureDriver(const Family& family, Subject& subject, const rasterizer::Rules& rules) {
  Series coverage{family.name, subject.name(), false, true}, values{family.name, subject.name(), true, true};
  for (const double dial : family.values) {
    const Scene scene = family.make(dial);
    const Result<Frame> actual = subject.render(scene);
    if (!actual && actual.error().code == ErrorCode::NotOffered) {
      for (Series* series : {&coverage, &values}) series->points.push_back({.dial = dial, .offered = false});
      continue;
    }
    if (!actual) return tl::unexpected(actual.error());
    const Result<Frame> expected = rasterizer::render(scene, rules);
    if (!expected) return tl::unexpected(expected.error());
    const Result<SceneResult> result = compare(scene, rules, *expected, *actual);
    if (!result) return tl::unexpected(result.error());
    coverage.points.push_back({dial, result->coveredSamples, result->differing, 0, 0});
    Point point{dial, 0, 0, 0, notFinite(*actual)};
    for (const ValueStats& stats : result->values) {
      point.cases += stats.compared;
      point.wrong += stats.differing;
      point.maxUlp = std::max(point.maxUlp, stats.maxUlp);
    }
    values.points.push_back(point);
  }
  return std::vector<Series>{std::move(coverage), std::move(values)};
}

}  // namespace rasterdiff::harness::stability
