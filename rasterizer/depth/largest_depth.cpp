#include "rasterizer/depth/largest_depth.hpp"

#include <algorithm>
#include <cmath>

namespace rasterdiff::rasterizer {

Interval largestDepth(std::span<const RasterVertex* const> vertices) {
  Interval largest;
  for (const RasterVertex* vertex : vertices) {
    const double z = std::fabs(vertex->position.z), error = vertex->depthError;
    largest = {std::max(largest.value, z), std::max(largest.lo, z - error), std::max(largest.hi, z + error)};
  }
  return largest;
}

std::array<size_t, 3> farthestFirst(const std::array<ClipPosition, 3>& clip) {
  std::array<size_t, 3> order{0, 1, 2};
  const auto bring = [&order](const std::array<bool, 3>& wanted) {
    if (wanted[1]) std::rotate(order.begin(), order.begin() + 1, order.end());
    if (wanted[2]) std::rotate(order.begin(), order.begin() + 2, order.end());
  };
  const float top = std::min({clip[0].y, clip[1].y, clip[2].y});
  bring({false, clip[1].y == top, clip[2].y == top});
  const auto w = [&](size_t i) { return clip[order[i]].w; };
  const float farthest = std::max({w(0), w(1), w(2)});
  bring({false, w(1) == farthest, w(2) == farthest});
  return order;
}

Interval largestByFirstDifferences(const Primitive& primitive) {
  const auto& clip = primitive.clip;
  const std::array<size_t, 3> order = farthestFirst(clip);
  const auto scale = static_cast<float>(primitive.viewport.z.scale), offset = static_cast<float>(primitive.viewport.z.offset());
  const auto depth = [&](size_t i) { return clip[order[i]].z * (1.0F / clip[order[i]].w); };
  const float first = depth(0);
  float largest = std::fabs(first * scale + offset);
  for (size_t i = 1; i < 3; ++i) largest = std::max(largest, std::fabs((depth(i) - first) * scale + offset));
  return {largest, largest, largest};
}

}  // namespace rasterdiff::rasterizer
