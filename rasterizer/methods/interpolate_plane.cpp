// Interpolation by a plane equation, in float32, anchored at the target's origin or at a vertex.
#include "rasterizer/methods/interpolation_float.hpp"

namespace rasterdiff::rasterizer {
namespace {

/// N = (P2 - P1) × (P3 - P1) of the points (x, y, value).
struct Normal {
  float a, b, c;
};

Normal normalOf(const std::array<FloatPoint, 3>& corner, const std::array<float, 3>& value) {
  const float ux = corner[1].x - corner[0].x, uy = corner[1].y - corner[0].y, uv = value[1] - value[0];
  const float wx = corner[2].x - corner[0].x, wy = corner[2].y - corner[0].y, wv = value[2] - value[0];
  return {uy * wv - uv * wy, uv * wx - ux * wv, ux * wy - uy * wx};
}

}  // namespace

float planeAt(const std::array<FloatPoint, 3>& corner, const std::array<float, 3>& value, FloatPoint p) {
  const Normal n = normalOf(corner, value);
  const float d = -(n.a * corner[0].x + n.b * corner[0].y + n.c * value[0]);
  return -(n.a / n.c) * p.x - n.b / n.c * p.y - d / n.c;
}

float interpolatePlane(const InterpolatedTriangle& triangle, SubpixelPosition p) {
  return planeAt(inPixels(triangle.position), triangle.value, inPixels(p));
}

float interpolatePlaneAtVertex(const InterpolatedTriangle& triangle, SubpixelPosition p) {
  const std::array<FloatPoint, 3> corner = inPixels(triangle.position);
  const FloatPoint at = inPixels(p);
  const Normal n = normalOf(corner, triangle.value);
  return triangle.value[0] - n.a / n.c * (at.x - corner[0].x) - n.b / n.c * (at.y - corner[0].y);
}

}  // namespace rasterdiff::rasterizer
