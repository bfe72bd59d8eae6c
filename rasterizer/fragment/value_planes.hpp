// The linear functions behind the values of one triangle, line or point, and their evaluation over a region.
//
// A perspective value is v = N / D with N = Σ bᵢ fᵢ / wᵢ and D = Σ bᵢ / wᵢ, both linear on the screen (lecture
// "Perspective-correct interpolation"; [vk:primsrast-polygon-barycentrics]); noperspective and depth are linear themselves.
#pragma once

#include <array>
#include <utility>

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

/// `f` over `region`: its nominal value, and the interval of legal float32 results.
[[nodiscard]] inline Interval linearOver(const LinearFunction& f, const EvaluationRegion& region) {
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
  Denominator(const LinearFunction& f, const EvaluationRegion& region)
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
template <size_t kCorners>
[[nodiscard]] inline Interval quotientOver(const LinearFunction& numerator, const Denominator<kCorners>& denominator,
                                           const EvaluationRegion& region) {
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

/// linearOver and quotientOver, with the same bits, where a region is a pixel around its centre: the planes of a triangle
/// give many values there. Spot 0 is the centre; the others are the corners, if the whole pixel is legal.
template <size_t kSpots>
class PixelValues {
  static_assert(kSpots == 1 || kSpots == 5);

 public:
  PixelValues(double x, double y) : x_(x), y_(y) {}

  void setDenominator(const LinearFunction& f) {
    weights_ = at(f);
    weightRadius_ = f.radius(x_, y_);
    smallest_ = std::fabs(weights_[0]);
    determined_ = smallest_ > weightRadius_;
    for (size_t i = 1; i < kSpots; ++i) {
      determined_ = determined_ && (weights_[i] > 0) == (weights_[0] > 0) && std::fabs(weights_[i]) > weightRadius_;
      smallest_ = std::min(smallest_, std::fabs(weights_[i]));
    }
  }

  [[nodiscard]] Interval linear(const LinearFunction& f) const {
    const std::array<double, kSpots> values = at(f);
    const auto [lo, hi] = extremes(values);
    const double radius = f.radius(x_, y_) + kHalfUlp * std::max(std::fabs(lo), std::fabs(hi));
    return {values[0], lo - radius, hi + radius};
  }

  [[nodiscard]] Interval quotient(const LinearFunction& numerator) const {
    std::array<double, kSpots> values = at(numerator);
    for (size_t i = 0; i < kSpots; ++i) values[i] /= weights_[i];
    if (!determined_) return {values[0], -kUnbounded, kUnbounded};
    const auto [lo, hi] = extremes(values);
    const double magnitude = std::max(std::fabs(lo), std::fabs(hi));
    const double radius = (numerator.radius(x_, y_) + magnitude * weightRadius_) / (smallest_ - weightRadius_) + 4 * kHalfUlp * magnitude;
    return {values[0], lo - radius, hi + radius};
  }

 private:
  [[nodiscard]] std::array<double, kSpots> at(const LinearFunction& f) const {
    std::array<double, kSpots> values;
    values[0] = f.at(x_, y_);
    if constexpr (kSpots == 5) {
      const double left = f.value + f.dx * (x_ - 0.5 - f.x0), right = f.value + f.dx * (x_ + 0.5 - f.x0);
      const double top = f.dy * (y_ - 0.5 - f.y0), bottom = f.dy * (y_ + 0.5 - f.y0);
      values[1] = left + top;
      values[2] = right + top;
      values[3] = left + bottom;
      values[4] = right + bottom;
    }
    return values;
  }
  [[nodiscard]] static std::pair<double, double> extremes(const std::array<double, kSpots>& values) {
    double lo = values[0], hi = values[0];
    for (size_t i = 1; i < kSpots; ++i) {
      lo = std::min(lo, values[i]);
      hi = std::max(hi, values[i]);
    }
    return {lo, hi};
  }

  const double x_, y_;
  std::array<double, kSpots> weights_{};
  double weightRadius_ = 0, smallest_ = 0;
  bool determined_ = false;
};

/// The nominal value of `a` in bounds that hold both.
[[nodiscard]] inline Interval hullOf(const Interval& a, const Interval& b) {
  if (std::isnan(b.lo) || std::isnan(b.hi)) return {a.value, -kUnbounded, kUnbounded};
  return {a.value, std::min(a.lo, b.lo), std::max(a.hi, b.hi)};
}

}  // namespace rasterdiff::rasterizer
