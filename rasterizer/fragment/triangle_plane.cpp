#include "rasterizer/fragment/triangle_plane.hpp"

namespace rasterdiff::rasterizer {
namespace {

/// Of a term of a sum of weighted vertices: 1 / det, times the edge, times the value, two sums.
constexpr double kWeightRoundings = 5;

}  // namespace

TrianglePlane::TrianglePlane(const std::array<FramebufferPosition, 3>& corners, double deviation) : deviation_(deviation) {
  for (size_t i = 0; i < 3; ++i) {
    x_[i] = corners[i].x;
    y_[i] = corners[i].y;
  }
  e1x_ = x_[1] - x_[0];
  e1y_ = y_[1] - y_[0];
  e2x_ = x_[2] - x_[0];
  e2y_ = y_[2] - y_[0];
  determinant_ = e1x_ * e2y_ - e1y_ * e2x_;
  const double area = std::fabs(determinant_);
  width_ = (std::fabs(e1x_) + std::fabs(e2x_) + std::fabs(e2x_ - e1x_)) / 2;
  height_ = (std::fabs(e1y_) + std::fabs(e2y_) + std::fabs(e2y_ - e1y_)) / 2;
  perimeter_ = 2 * (width_ + height_);
  condition_ = 1 + (std::fabs(e1x_ * e2y_) + std::fabs(e1y_ * e2x_)) / area;
  sensitivity_ = (deviation_ * perimeter_ + 6 * deviation_ * deviation_) / area;
}

void TrianglePlane::reachTo(std::span<const RasterVertex> polygon) {
  for (const RasterVertex& vertex : polygon) {
    const double x = vertex.position.x - x_[0], y = vertex.position.y - y_[0];
    const double b1 = (x * e2y_ - y * e2x_) / determinant_, b2 = (y * e1x_ - x * e1y_) / determinant_;
    reach_ = std::max(reach_, std::fabs(1 - b1 - b2) + std::fabs(b1) + std::fabs(b2));
  }
}

LinearFunction TrianglePlane::through(const std::array<double, 3>& a, double inputError, double outside) const {
  LinearFunction result;
  const double d1 = a[1] - a[0], d2 = a[2] - a[0];
  const double largest = std::max({std::fabs(a[0]), std::fabs(a[1]), std::fabs(a[2])});
  result.value = a[0];
  result.x0 = x_[0];
  result.y0 = y_[0];
  if (determinant_ != 0) {
    result.dx = (d1 * e2y_ - d2 * e1y_) / determinant_;
    result.dy = (d2 * e1x_ - d1 * e2x_) / determinant_;
  }
  if (undetermined()) {
    // A sliver whose area a legal placement can halve or lose: its plane is not determined.
    result.constantRadius = d1 == 0 && d2 == 0 ? kHalfUlp * largest * std::max(4 * condition_, kWeightRoundings * 4 * width_ * height_ / std::fabs(determinant_)) : kUnbounded;
    return result;
  }
  const double area = std::fabs(determinant_);
  // Roundings of float32, each 2^-24 relative. Gradient: differences 2, product 1, sum 1, 1/det 1, product 1, and the
  // determinant's own 3 amplified by its condition. Anchor at the origin and final sum: 3 products and sums each.
  const double gradientX = (std::fabs(d1 * e2y_) + std::fabs(d2 * e1y_)) / area;
  const double gradientY = (std::fabs(d2 * e1x_) + std::fabs(d1 * e2x_)) / area;
  const double roundings = 6 + 3 * condition_ + 6;
  result.radiusPerX = kHalfUlp * roundings * gradientX;
  result.radiusPerY = kHalfUlp * roundings * gradientY;
  // Placement: the value at a point moves by Σ |bᵢ| δ |gradient|; the gradient itself may change with the determinant.
  const double change = 2 * deviation_ * (std::fabs(d1) + std::fabs(d2)) / area;
  const double steepest = (std::fabs(result.dx) + std::fabs(result.dy) + 2 * change) / (1 - sensitivity_);
  const double spread = reach_ + 2 * (deviation_ + 0x1p-7 + outside) * perimeter_ / area;  // bound on Σ |bᵢ|
  result.farX = std::max({std::fabs(x_[0]), std::fabs(x_[1]), std::fabs(x_[2])});
  result.farY = std::max({std::fabs(y_[0]), std::fabs(y_[1]), std::fabs(y_[2])});
  // Instead of differences of values, weights may be summed: gx = Σ vᵢ (edge i in y / det), gy likewise. Each term is rounded by itself,
  // also where they cancel, as those of a constant do: gx errs by kWeightRoundings · 2^-24 · max |v| · Σ |edge in y| / |det|, where the
  // edges in y sum up to twice the height; over a way of Σ |bᵢ| widths, and what is outside. The determinant, which all terms share, errs as
  // above. An evaluation is one or the other, so that the larger bound is that of both.
  const double wayX = reach_ * width_ + outside, wayY = reach_ * height_ + outside;
  const double weights = kHalfUlp * (kWeightRoundings * largest * 2 * (height_ * wayX + width_ * wayY) / (area * (1 - sensitivity_)) +
                                     3 * condition_ * (gradientX * wayX + gradientY * wayY));
  const double differences = result.radiusPerX * (result.farX + 1) + result.radiusPerY * (result.farY + 1);
  result.constantRadius = std::max(spread * 3 * kHalfUlp * largest, weights - differences) + spread * (inputError + deviation_ * steepest);
  return result;
}

Gradient TrianglePlane::gradient(const std::array<double, 3>& a, double inputError) const {
  const double d1 = a[1] - a[0], d2 = a[2] - a[0];
  Gradient result;
  if (determinant_ != 0) {
    result.dx = (d1 * e2y_ - d2 * e1y_) / determinant_;
    result.dy = (d2 * e1x_ - d1 * e2x_) / determinant_;
  }
  if (undetermined()) {
    result.radius = d1 == 0 && d2 == 0 && inputError == 0 ? 0 : kUnbounded;
    return result;
  }
  const double area = std::fabs(determinant_);
  const double terms = std::max(std::fabs(d1 * e2y_) + std::fabs(d2 * e1y_), std::fabs(d2 * e1x_) + std::fabs(d1 * e2x_)) / area;
  // As in through(): the roundings of a gradient; corners that move; values that are not what they should be.
  const double rounded = kHalfUlp * (6 + 3 * condition_) * terms;
  const double longest = std::max(std::fabs(e1x_) + std::fabs(e2x_), std::fabs(e1y_) + std::fabs(e2y_));
  const double moved = (2 * deviation_ * (std::fabs(d1) + std::fabs(d2)) + 2 * inputError * longest) / area +
                       std::max(std::fabs(result.dx), std::fabs(result.dy)) * sensitivity_;
  result.radius = rounded + moved / (1 - sensitivity_);
  return result;
}

}  // namespace rasterdiff::rasterizer
