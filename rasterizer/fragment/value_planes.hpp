// The linear functions behind the values of one triangle, line or point, and their evaluation over a region.
//
// A perspective value is v = N / D with N = Σ bᵢ fᵢ / wᵢ and D = Σ bᵢ / wᵢ, both linear on the screen (lecture
// "Perspective-correct interpolation"; [vk:primsrast-polygon-barycentrics]); noperspective and depth are linear themselves.
#pragma once

#include <array>

#include "rasterizer/fragment/linear_function.hpp"
#include "rasterizer/fragment/place.hpp"
#include "rasterizer/legal/float_function.hpp"

namespace rasterdiff::rasterizer {

struct ValuePlanes {
  LinearFunction depth, reciprocalW;
  std::vector<LinearFunction> inputs;  ///< of each component of the varyings; f / w for perspective ones
};

/// The same as a legal renderer evaluates them (Rules::variation).
struct FloatPlanes {
  FloatFunction depth, reciprocalW;
  std::vector<FloatFunction> inputs;
};

/// `f` over `region`, an EvaluationRegion or a PixelRegion: its nominal value, and the interval of legal float32 results.
template <class Region>
[[nodiscard]] Interval linearOver(const LinearFunction& f, const Region& region) {
  const Spot& spot = region.nominal;
  const double value = f.at(spot.x, spot.y);
  double lo = value, hi = value;
  for (const Spot& corner : region.corners) {
    const double at = f.at(corner.x, corner.y);
    lo = std::min(lo, at);
    hi = std::max(hi, at);
  }
  const double radius = f.radius(spot.x, spot.y) + kHalfUlp * std::max(std::fabs(lo), std::fabs(hi));
  return {value, lo - radius, hi + radius};
}

/// The denominator of all perspective values over a region of at most kCorners corners, evaluated once.
template <size_t kCorners>
struct Denominator {
  template <class Region>
  Denominator(const LinearFunction& f, const Region& region)
      : weight(f.at(region.nominal.x, region.nominal.y)), radius(f.radius(region.nominal.x, region.nominal.y)),
        smallest(std::fabs(weight)), determined(smallest > radius && region.corners.size() <= kCorners) {
    for (size_t i = 0; determined && i < region.corners.size(); ++i) {
      const double d = corners[i] = f.at(region.corners[i].x, region.corners[i].y);
      determined = (d > 0) == (weight > 0) && std::fabs(d) > radius;
      smallest = std::min(smallest, std::fabs(d));
    }
  }
  double weight, radius;
  double smallest;  // magnitude
  bool determined;  // nowhere may it be zero
  std::array<double, kCorners> corners;
};

/// numerator / denominator over `region`; unbounded where the denominator may be zero.
template <size_t kCorners, class Region>
[[nodiscard]] Interval quotientOver(const LinearFunction& numerator, const Denominator<kCorners>& denominator, const Region& region) {
  const Spot& spot = region.nominal;
  const double value = numerator.at(spot.x, spot.y) / denominator.weight;
  if (!denominator.determined) return {value, -kUnbounded, kUnbounded};
  double lo = value, hi = value;
  for (size_t i = 0; i < region.corners.size(); ++i) {
    const double v = numerator.at(region.corners[i].x, region.corners[i].y) / denominator.corners[i];
    lo = std::min(lo, v);
    hi = std::max(hi, v);
  }
  const double magnitude = std::max(std::fabs(lo), std::fabs(hi));
  // The quotient's first-order bound, and a reciprocal, a product and its roundings.
  const double radius = (numerator.radius(spot.x, spot.y) + magnitude * denominator.radius) /
                            (denominator.smallest - denominator.radius) +
                        4 * kHalfUlp * magnitude;
  return {value, lo - radius, hi + radius};
}

/// The nominal value of `a` in bounds that hold both.
[[nodiscard]] inline Interval hullOf(const Interval& a, const Interval& b) {
  if (std::isnan(b.lo) || std::isnan(b.hi)) return {a.value, -kUnbounded, kUnbounded};
  return {a.value, std::min(a.lo, b.lo), std::max(a.hi, b.hi)};
}

}  // namespace rasterdiff::rasterizer
