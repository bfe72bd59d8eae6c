#include "rasterizer/depth/format.hpp"

namespace rasterdiff::rasterizer {

Interpolated stored(const Interval& z, DepthFormat format) {
  const uint32_t bits = unormBits(format);
  if (bits == 0) return toFloat(z);
  const auto steps = static_cast<double>((uint64_t{1} << bits) - 1);
  const auto scaled = [steps](double value, double ifNone) {
    return std::isnan(value) ? ifNone : std::clamp(value, 0.0, 1.0) * steps;
  };
  return {fromUnorm(std::nearbyint(scaled(z.value, 0)), bits),
          {fromUnorm(std::floor(scaled(z.lo, 0)), bits), fromUnorm(std::ceil(scaled(z.hi, steps)), bits)}};
}

Interpolated clearedDepth(float clearValue, DepthFormat format) {
  return stored({clearValue, clearValue, clearValue}, format);
}

}  // namespace rasterdiff::rasterizer
