// Nearest first, by counting.
#include "rasterizer/kernels/value_order.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "rasterizer/kernels/value_bins.hpp"

namespace rasterdiff::rasterizer {

namespace {

constexpr size_t kSteps = 1024;  // of the sums of a triangle's depths

/// Whether triangles of hundreds of pixels lie many upon one another: only of them it is known where they are hidden.
bool areLayered(const ValueTriangles& triangles, const ValueTarget& target) {
  constexpr double kLeastArea = 256, kLeastLayers = 3;
  const double pixels = static_cast<double>(target.width()) * target.height(), area = meanShape(triangles.positions).area;
  return area >= kLeastArea && area * static_cast<double>(triangles.positions.size()) >= kLeastLayers * pixels;
}

}  // namespace

std::vector<uint32_t> nearestFirst(const ValueTriangles& triangles, const ValueTarget& target) {
  const ValueNeeds& needs = target.needs();
  if (!needs.depth || needs.count || !areLayered(triangles, target)) return {};
  const size_t size = triangles.positions.size();
  std::vector<float> sums(size);
  for (size_t i = 0; i < size; ++i) {
    const float* z = &triangles.depth[3 * i];
    sums[i] = z[0] + z[1] + z[2];
    if (!std::isfinite(sums[i])) return {};
  }
  const auto [least, most] = std::ranges::minmax(sums);
  const double scale = (kSteps - 1) / std::max<double>(double{most} - least, std::numeric_limits<float>::min());
  const auto stepOf = [first = least, scale](float sum) { return static_cast<size_t>((double{sum} - first) * scale); };
  std::vector<uint32_t> starts(kSteps + 1), order(size);
  for (const float sum : sums) ++starts[stepOf(sum) + 1];
  for (size_t k = 0; k < kSteps; ++k) starts[k + 1] += starts[k];
  for (size_t i = 0; i < size; ++i) order[starts[stepOf(sums[i])]++] = static_cast<uint32_t>(i);
  return order;
}

}  // namespace rasterdiff::rasterizer
