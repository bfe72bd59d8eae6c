// Bresenham's line in four cases of the slope, in the float32 of the lecture's pseudocode.
#include <cmath>
#include <utility>

#include "rasterizer/methods/line_methods.hpp"

namespace rasterdiff::rasterizer {
namespace {

PixelIndex pixelOf(float x, float y) {
  return {static_cast<int32_t>(std::floor(x)), static_cast<int32_t>(std::floor(y))};
}

}  // namespace

std::vector<PixelIndex> drawLineFourOctants(SubpixelPosition a, SubpixelPosition b) {
  constexpr float kUnit = 1.0f / kSubpixelOne;
  float x1 = static_cast<float>(a.x) * kUnit, y1 = static_cast<float>(a.y) * kUnit;
  float x2 = static_cast<float>(b.x) * kUnit, y2 = static_cast<float>(b.y) * kUnit;
  const bool alongX = std::fabs(x2 - x1) >= std::fabs(y2 - y1);  // |m| ≤ 1
  if (alongX ? x1 > x2 : y1 > y2) {
    std::swap(x1, x2);
    std::swap(y1, y2);
  }
  // `u` runs, `v` steps by `side` where the error says so; `slope` is m or 1 / m.
  const float u1 = alongX ? x1 : y1, u2 = alongX ? x2 : y2;
  float v = alongX ? y1 : x1;
  const float extent = u2 - u1;
  const float slope = extent == 0 ? 0 : ((alongX ? y2 : x2) - v) / extent;
  const float side = slope < 0 ? -1.0f : 1.0f;
  float error = 0;
  std::vector<PixelIndex> pixels;
  for (float u = u1; u <= u2; u += 1) {
    pixels.push_back(alongX ? pixelOf(u, v) : pixelOf(v, u));
    error += slope;
    if (std::fabs(error) > 0.5f) {
      error -= side;
      v += side;
    }
  }
  return pixels;
}

}  // namespace rasterdiff::rasterizer
