// The linear functions behind the values of one triangle, line or point, and their evaluation over a region.
//
// A perspective value is v = N / D with N = Σ bᵢ fᵢ / wᵢ and D = Σ bᵢ / wᵢ, both linear on the screen (lecture
// "Perspective-correct interpolation"; [vk:primsrast-polygon-barycentrics]); noperspective and depth are linear themselves.
#pragma once

#include "rasterizer/fragment/linear_function.hpp"
#include "rasterizer/fragment/place.hpp"

namespace rasterdiff::rasterizer {

struct ValuePlanes {
  LinearFunction depth, reciprocalW;
  std::vector<LinearFunction> inputs;  ///< of each component of the varyings; f / w for perspective ones
};

/// `f` over `region`: its nominal value, and the interval of legal float32 results.
[[nodiscard]] Interval linearOver(const LinearFunction& f, const EvaluationRegion& region);

/// numerator / denominator over `region`; unbounded where the denominator may be zero.
[[nodiscard]] Interval quotientOver(const LinearFunction& numerator, const LinearFunction& denominator,
                                    const EvaluationRegion& region);

/// The nominal value of `a` in bounds that hold both.
[[nodiscard]] inline Interval hullOf(const Interval& a, const Interval& b) {
  if (std::isnan(b.lo) || std::isnan(b.hi)) return {a.value, -kUnbounded, kUnbounded};
  return {a.value, std::min(a.lo, b.lo), std::max(a.hi, b.hi)};
}

}  // namespace rasterdiff::rasterizer
