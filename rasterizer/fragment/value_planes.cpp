#include "rasterizer/fragment/value_planes.hpp"

namespace rasterdiff::rasterizer {

Interval linearOver(const LinearFunction& f, const EvaluationRegion& region) {
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

Interval quotientOver(const LinearFunction& numerator, const LinearFunction& denominator, const EvaluationRegion& region) {
  const Spot& spot = region.nominal;
  const double weight = denominator.at(spot.x, spot.y);
  const double value = numerator.at(spot.x, spot.y) / weight;
  const double radiusN = numerator.radius(spot.x, spot.y), radiusD = denominator.radius(spot.x, spot.y);
  const Interval unbounded{value, -kUnbounded, kUnbounded};
  double lo = value, hi = value, smallestWeight = std::fabs(weight);
  if (!(smallestWeight > radiusD)) return unbounded;
  for (const Spot& corner : region.corners) {
    const double d = denominator.at(corner.x, corner.y);
    if ((d > 0) != (weight > 0) || !(std::fabs(d) > radiusD)) return unbounded;
    const double v = numerator.at(corner.x, corner.y) / d;
    lo = std::min(lo, v);
    hi = std::max(hi, v);
    smallestWeight = std::min(smallestWeight, std::fabs(d));
  }
  const double magnitude = std::max(std::fabs(lo), std::fabs(hi));
  // The quotient's first-order bound, and a reciprocal, a product and its roundings.
  const double radius = (radiusN + magnitude * radiusD) / (smallestWeight - radiusD) + 4 * kHalfUlp * magnitude;
  return {value, lo - radius, hi + radius};
}

}  // namespace rasterdiff::rasterizer
