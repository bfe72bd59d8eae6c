#include "rasterizer/depth/resolve_depth.hpp"

#include <algorithm>
#include <numeric>

#include "rasterizer/depth/format.hpp"
#include "rasterizer/fragment/resolve.hpp"

namespace rasterdiff::rasterizer {

Interpolated resolvedDepth(std::span<const float> depths, std::span<const Bounds> bounds, ResolveMode mode,
                           DepthFormat format) {
  const auto lowest = [](Bounds a, Bounds b) { return Bounds{std::min(a.lo, b.lo), std::min(a.hi, b.hi)}; };
  const auto highest = [](Bounds a, Bounds b) { return Bounds{std::max(a.lo, b.lo), std::max(a.hi, b.hi)}; };
  switch (mode) {
    case ResolveMode::SAMPLE_ZERO: return {depths[0], bounds[0]};
    case ResolveMode::MIN: return {*std::ranges::min_element(depths), std::accumulate(bounds.begin(), bounds.end(), bounds[0], lowest)};
    case ResolveMode::MAX: return {*std::ranges::max_element(depths), std::accumulate(bounds.begin(), bounds.end(), bounds[0], highest)};
    case ResolveMode::AVERAGE: break;
  }
  const Interpolated mean = meanOf(depths, bounds, 1);
  if (unormBits(format) == 0) return mean;
  return stored({mean.value, mean.bounds.lo, mean.bounds.hi}, format);
}

VaryingPlane resolvedDepth(const Plane<float>& depths, const Plane<Bounds>& bounds, ResolveMode mode, DepthFormat format,
                           DeliberateError error, RuleCounts& counts) {
  VaryingPlane result{"depth", Plane<float>(depths.width, depths.height, 1), std::nullopt};
  result.bounds.emplace(depths.width, depths.height, 1);
  const size_t samples = depths.samples;
  if (error == DeliberateError::ResolveSampleZero) mode = ResolveMode::SAMPLE_ZERO;
  for (size_t pixel = 0; pixel < result.values.data.size(); ++pixel) {
    const std::span<const float> own = std::span(depths.data).subspan(pixel * samples, samples);
    const Interpolated one = resolvedDepth(own, std::span(bounds.data).subspan(pixel * samples, samples), mode, format);
    result.values.data[pixel] = one.value;
    result.bounds->data[pixel] = one.bounds;
    if (std::ranges::any_of(own, [&](float depth) { return depth != own[0]; })) ++counts[Rule::Resolve];
  }
  return result;
}

}  // namespace rasterdiff::rasterizer
