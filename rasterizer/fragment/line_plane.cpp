#include "rasterizer/fragment/line_plane.hpp"

namespace rasterdiff::rasterizer {

LinePlane::LinePlane(const RasterVertex& a, const RasterVertex& b, float width, LineParameter parameter)
    : ax_(a.position.x), ay_(a.position.y),
      farX_(std::max(std::fabs(a.position.x), std::fabs(b.position.x))),
      farY_(std::max(std::fabs(a.position.y), std::fabs(b.position.y))) {
  const double dx = b.position.x - ax_, dy = b.position.y - ay_;
  const double squared = dx * dx + dy * dy, length = std::sqrt(squared);
  if (squared == 0) return;
  // Equal differences: x is major.
  const bool xMajor = std::fabs(dx) >= std::fabs(dy);
  const double major = xMajor ? dx : dy, minor = xMajor ? dy : dx;
  // A fragment's place of evaluation is at most this far from the segment: half the width and a pixel's diagonal.
  const double reach = width / 2.0 + 1.5;
  const double deviation = std::max(a.deviation, b.deviation);
  spread_ = 1 + 2 * (reach + deviation) / length;

  if (parameter == LineParameter::Projection) {
    tx_ = dx / squared;
    ty_ = dy / squared;
    // t = n / L²: moving both ends by δ changes n by δ (L + 2δ) + 2δ |p - a|, and L² by 4δL + 4δ².
    const double delta = std::sqrt(2.0) * deviation, shrink = 1 - 2 * delta / length;
    if (shrink <= 0.5) return;
    const double farthest = length * spread_;
    parameterRadius_ = (delta * (length + 2 * delta) + 2 * delta * farthest + spread_ * (4 * delta * length + 4 * delta * delta)) /
                       (squared * shrink * shrink);
    return;
  }
  (xMajor ? tx_ : ty_) = 1 / major;
  // The corners of a parallelogram go through the same roundings as the ends, and their own.
  const double delta = 2 * deviation;
  if (std::fabs(major) <= 4 * delta) return;
  parameterRadius_ = delta * (1 + 2 * spread_) / (std::fabs(major) - 2 * delta);
  if (parameter == LineParameter::Replicated) {
    // The lowest fragment's centre is within half a pixel of the moved line, and one more under the rules that other
    // algorithms may follow; the projection of that offset onto the line is what t may differ by.
    parameterRadius_ += 1.5 * std::fabs(minor) / squared;
  }
}

LinearFunction LinePlane::through(double fa, double fb, double inputError) const {
  LinearFunction f;
  const double rise = fb - fa, largest = std::max(std::fabs(fa), std::fabs(fb));
  f.value = fa;
  f.dx = rise * tx_;
  f.dy = rise * ty_;
  f.x0 = ax_;
  f.y0 = ay_;
  // Roundings of float32: differences 2, squares and their sum 6, reciprocal 1, products 3; anchored at the origin and
  // summed up 6.
  f.radiusPerX = 18 * kHalfUlp * std::fabs(f.dx);
  f.radiusPerY = 18 * kHalfUlp * std::fabs(f.dy);
  f.constantRadius = spread_ * (3 * kHalfUlp * largest + inputError) + (rise != 0 ? std::fabs(rise) * parameterRadius_ : 0);
  f.farX = farX_;
  f.farY = farY_;
  return f;
}

}  // namespace rasterdiff::rasterizer
