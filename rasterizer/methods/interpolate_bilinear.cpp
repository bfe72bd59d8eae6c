// Bilinear interpolation along edges, in float32.
#include <utility>

#include "rasterizer/methods/interpolation_float.hpp"

namespace rasterdiff::rasterizer {
namespace {

struct Corner {
  FloatPoint at;
  float value;
};

/// Where the edge from `upper` to `lower` meets the row y.
Corner onEdge(const Corner& upper, const Corner& lower, float y) {
  const float t = (y - upper.at.y) / (lower.at.y - upper.at.y);
  return {{upper.at.x + t * (lower.at.x - upper.at.x), y}, upper.value + t * (lower.value - upper.value)};
}

}  // namespace

float interpolateBilinear(const InterpolatedTriangle& triangle, SubpixelPosition p) {
  const std::array<FloatPoint, 3> corner = inPixels(triangle.position);
  Corner top{corner[0], triangle.value[0]}, middle{corner[1], triangle.value[1]}, bottom{corner[2], triangle.value[2]};
  if (middle.at.y < top.at.y) std::swap(top, middle);
  if (bottom.at.y < middle.at.y) std::swap(middle, bottom);
  if (middle.at.y < top.at.y) std::swap(top, middle);
  const FloatPoint at = inPixels(p);
  const bool upper = at.y < middle.at.y || middle.at.y == bottom.at.y;
  const Corner on = onEdge(top, bottom, at.y);
  const Corner other = upper ? onEdge(top, middle, at.y) : onEdge(middle, bottom, at.y);
  const float width = other.at.x - on.at.x;
  if (width == 0) return on.value;
  return on.value + (at.x - on.at.x) / width * (other.value - on.value);
}

}  // namespace rasterdiff::rasterizer
