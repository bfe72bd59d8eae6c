// Perspective-correct interpolation: f/w and 1/w are linear on the screen, their quotient is f. In float32.
#include "rasterizer/methods/interpolation_float.hpp"

namespace rasterdiff::rasterizer {
namespace {

struct Divided {
  std::array<float, 3> value, one;  ///< f/w and 1/w at the vertices
};

Divided divided(const InterpolatedTriangle& triangle) {
  Divided result{};
  for (size_t i = 0; i < 3; ++i) {
    result.one[i] = 1.0f / triangle.w[i];
    result.value[i] = triangle.value[i] * result.one[i];
  }
  return result;
}

}  // namespace

float interpolatePerspective(const InterpolatedTriangle& triangle, SubpixelPosition p) {
  const std::array<float, 3> weights = weightsByDifferences(triangle, p);
  const Divided at = divided(triangle);
  float value = 0, one = 0;
  for (size_t i = 0; i < 3; ++i) {
    value += weights[i] * at.value[i];
    one += weights[i] * at.one[i];
  }
  return value / one;
}

float interpolatePerspectivePlane(const InterpolatedTriangle& triangle, SubpixelPosition p) {
  const std::array<FloatPoint, 3> corner = inPixels(triangle.position);
  const Divided at = divided(triangle);
  const FloatPoint point = inPixels(p);
  return planeAt(corner, at.value, point) / planeAt(corner, at.one, point);
}

}  // namespace rasterdiff::rasterizer
