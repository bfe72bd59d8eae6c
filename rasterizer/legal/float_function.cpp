#include "rasterizer/legal/float_function.hpp"

#include <cmath>

namespace rasterdiff::rasterizer {
namespace {

float cross(FloatSpot a, FloatSpot b, FloatSpot p) { return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x); }

}  // namespace

FloatFunction::FloatFunction(Variation::Arithmetic arithmetic, const std::array<FloatSpot, 3>& corners,
                             const std::array<float, 3>& values)
    : arithmetic_(arithmetic), corners_(corners), values_(values), area_(cross(corners[0], corners[1], corners[2])) {
  const float e1x = corners[1].x - corners[0].x, e1y = corners[1].y - corners[0].y;
  const float e2x = corners[2].x - corners[0].x, e2y = corners[2].y - corners[0].y;
  const float d1 = values[1] - values[0], d2 = values[2] - values[0];
  const float inverse = 1 / area_;
  dx_ = (d1 * e2y - d2 * e1y) * inverse;
  dy_ = (d2 * e1x - d1 * e2x) * inverse;
  anchor_ = values[0];
  if (arithmetic == Variation::Arithmetic::PlaneAtOrigin) anchor_ = values[0] - (dx_ * corners[0].x + dy_ * corners[0].y);
}

FloatFunction::FloatFunction(FloatSpot a, FloatSpot b, bool majorAxis, const std::array<float, 2>& values)
    : corners_{a, b, b}, anchor_(values[0]) {
  const float dx = b.x - a.x, dy = b.y - a.y, rise = values[1] - values[0];
  if (majorAxis) {
    (std::fabs(dx) >= std::fabs(dy) ? dx_ : dy_) = rise / (std::fabs(dx) >= std::fabs(dy) ? dx : dy);
    return;
  }
  const float squared = dx * dx + dy * dy;
  dx_ = rise * (dx / squared);
  dy_ = rise * (dy / squared);
}

bool FloatFunction::hasArea(const std::array<FloatSpot, 3>& corners) { return cross(corners[0], corners[1], corners[2]) != 0; }

float FloatFunction::at(FloatSpot p) const {
  switch (arithmetic_) {
    case Variation::Arithmetic::PlaneAtOrigin: return anchor_ + dx_ * p.x + dy_ * p.y;
    case Variation::Arithmetic::PlaneAtVertex: return anchor_ + dx_ * (p.x - corners_[0].x) + dy_ * (p.y - corners_[0].y);
    case Variation::Arithmetic::Barycentric: {
      const float beta = cross(corners_[2], corners_[0], p) / area_, gamma = cross(corners_[0], corners_[1], p) / area_;
      return (1 - beta - gamma) * values_[0] + beta * values_[1] + gamma * values_[2];
    }
  }
  return anchor_;
}

}  // namespace rasterdiff::rasterizer
