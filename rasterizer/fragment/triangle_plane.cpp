#include "rasterizer/fragment/triangle_plane.hpp"

namespace rasterdiff::rasterizer {
namespace {

std::array<double, 3> each(const std::array<FramebufferPosition, 3>& corners, double FramebufferPosition::*axis) {
  return {corners[0].*axis, corners[1].*axis, corners[2].*axis};
}

}  // namespace

TrianglePlane::TrianglePlane(const std::array<FramebufferPosition, 3>& corners, double deviation)
    : t_(each(corners, &FramebufferPosition::x), each(corners, &FramebufferPosition::y), deviation) {}

void TrianglePlane::reachTo(std::span<const RasterVertex> polygon) {
  for (const RasterVertex& vertex : polygon) {
    const double x = vertex.position.x - t_.x[0], y = vertex.position.y - t_.y[0];
    const double b1 = (x * t_.e2y - y * t_.e2x) / t_.determinant, b2 = (y * t_.e1x - x * t_.e1y) / t_.determinant;
    reach_ = std::max(reach_, std::fabs(1 - b1 - b2) + std::fabs(b1) + std::fabs(b2));
  }
}

LinearFunction TrianglePlane::through(const std::array<double, 3>& values, double inputError, double outside) const {
  const PlaneOf<double> p = planeThrough(t_, values, inputError, outside, reach_);
  return {p.value, p.dx, p.dy, p.x0, p.y0, p.constantRadius, p.radiusPerX, p.radiusPerY, p.farX, p.farY};
}

Gradient TrianglePlane::gradient(const std::array<double, 3>& a, double inputError) const {
  const double d1 = a[1] - a[0], d2 = a[2] - a[0];
  Gradient result;
  if (t_.determinant != 0) {
    result.dx = (d1 * t_.e2y - d2 * t_.e1y) / t_.determinant;
    result.dy = (d2 * t_.e1x - d1 * t_.e2x) / t_.determinant;
  }
  if (t_.undetermined()) {
    result.radius = d1 == 0 && d2 == 0 && inputError == 0 ? 0 : kUnbounded;
    return result;
  }
  const double area = std::fabs(t_.determinant);
  const double terms = std::max(std::fabs(d1 * t_.e2y) + std::fabs(d2 * t_.e1y), std::fabs(d2 * t_.e1x) + std::fabs(d1 * t_.e2x)) / area;
  // As in through(): the roundings of a gradient; corners that move; values that are not what they should be.
  const double rounded = kHalfUlp * (6 + 3 * t_.condition) * terms;
  const double longest = std::max(std::fabs(t_.e1x) + std::fabs(t_.e2x), std::fabs(t_.e1y) + std::fabs(t_.e2y));
  const double moved = (2 * t_.deviation * (std::fabs(d1) + std::fabs(d2)) + 2 * inputError * longest) / area +
                       std::max(std::fabs(result.dx), std::fabs(result.dy)) * t_.sensitivity;
  result.radius = rounded + moved / (1 - t_.sensitivity);
  return result;
}

}  // namespace rasterdiff::rasterizer
