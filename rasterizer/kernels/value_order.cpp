// Nearest first, by counting.
#include "rasterizer/kernels/value_order.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "rasterizer/kernels/value_bins.hpp"

namespace rasterdiff::rasterizer {

namespace {

constexpr size_t kSteps = 1024;

/// Of the sums of triangles' depths, from the least to the most of some of them, evenly spread; what is beyond is in the first or last one, what
/// is not a number in any.
class Steps {
 public:
  explicit Steps(std::span<const float> depth) {
    constexpr size_t kLooked = 1024;
    float least = std::numeric_limits<float>::max(), most = -least;
    for (size_t i = 0; i + 3 <= depth.size(); i += 3 * std::max(depth.size() / 3 / kLooked, size_t{1})) {
      const float sum = sumOf(&depth[i]);
      if (!std::isfinite(sum)) continue;
      least = std::min(least, sum), most = std::max(most, sum);
    }
    if (!(least < most)) return;
    first_ = least, scale_ = static_cast<float>(std::min(kSteps / (double{most} - least), double{std::numeric_limits<float>::max()}));
  }

  /// Of the triangle with depths z[0] to z[2].
  [[nodiscard]] uint16_t of(const float* z) const {
    const float step = (sumOf(z) - first_) * scale_;
    return static_cast<uint16_t>(step > 0 ? (step < kSteps ? step : kSteps - 1) : 0);
  }

 private:
  static float sumOf(const float* z) { return z[0] + z[1] + z[2]; }
  float first_ = 0, scale_ = 0;
};

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
  const Steps steps(triangles.depth);
  std::vector<uint16_t> stepOf(size);
  for (size_t i = 0; i < size; ++i) stepOf[i] = steps.of(&triangles.depth[3 * i]);
  std::vector<uint32_t> starts(kSteps + 1), order(size);
  for (const uint16_t step : stepOf) ++starts[step + 1];
  for (size_t k = 0; k < kSteps; ++k) starts[k + 1] += starts[k];
  for (size_t i = 0; i < size; ++i) order[starts[stepOf[i]]++] = static_cast<uint32_t>(i);
  return order;
}

}  // namespace rasterdiff::rasterizer
