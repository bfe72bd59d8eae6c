// Interpolation by barycentric weights, in float32, from expanded line equations or from differences.
#include "rasterizer/methods/interpolation_float.hpp"

namespace rasterdiff::rasterizer {
namespace {

float weigh(const std::array<float, 3>& weights, const std::array<float, 3>& value) {
  return weights[0] * value[0] + weights[1] * value[1] + weights[2] * value[2];
}

/// f(x, y) of the line through a and b, all products written out.
float expandedLine(FloatPoint a, FloatPoint b, FloatPoint p) {
  return (a.y - b.y) * p.x + (b.x - a.x) * p.y + a.x * b.y - b.x * a.y;
}

float cross(FloatPoint a, FloatPoint b, FloatPoint p) { return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x); }

}  // namespace

float interpolateBarycentric(const InterpolatedTriangle& triangle, SubpixelPosition p) {
  const auto [a, b, c] = inPixels(triangle.position);
  const FloatPoint at = inPixels(p);
  const float beta = expandedLine(a, c, at) / expandedLine(a, c, b);
  const float gamma = expandedLine(a, b, at) / expandedLine(a, b, c);
  return weigh({1 - beta - gamma, beta, gamma}, triangle.value);
}

std::array<float, 3> weightsByDifferences(const InterpolatedTriangle& triangle, SubpixelPosition p) {
  const auto [a, b, c] = inPixels(triangle.position);
  const FloatPoint at = inPixels(p);
  const float area = cross(a, b, c);
  const float beta = cross(c, a, at) / area, gamma = cross(a, b, at) / area;
  return {1 - beta - gamma, beta, gamma};
}

float interpolateBarycentricDifferences(const InterpolatedTriangle& triangle, SubpixelPosition p) {
  return weigh(weightsByDifferences(triangle, p), triangle.value);
}

}  // namespace rasterdiff::rasterizer
