// What the float32 interpolation methods share: vertices in pixels, and one linear quantity over the triangle.
#pragma once

#include <array>

#include "rasterizer/methods/interpolation_methods.hpp"

namespace rasterdiff::rasterizer {

struct FloatPoint {
  float x = 0, y = 0;
};

/// Exact for |coordinate| < 2^16 pixels.
[[nodiscard]] inline FloatPoint inPixels(SubpixelPosition p) {
  constexpr float kUnit = 1.0f / kSubpixelOne;
  return {static_cast<float>(p.x) * kUnit, static_cast<float>(p.y) * kUnit};
}

[[nodiscard]] inline std::array<FloatPoint, 3> inPixels(const std::array<SubpixelPosition, 3>& p) {
  return {inPixels(p[0]), inPixels(p[1]), inPixels(p[2])};
}

/// Barycentric weights α, β, γ of p by edge functions of differences; α = 1 - β - γ as in the lecture.
[[nodiscard]] std::array<float, 3> weightsByDifferences(const InterpolatedTriangle& triangle, SubpixelPosition p);

/// The plane through (xᵢ, yᵢ, valueᵢ), anchored at the target's origin, at p.
[[nodiscard]] float planeAt(const std::array<FloatPoint, 3>& corner, const std::array<float, 3>& value, FloatPoint p);

}  // namespace rasterdiff::rasterizer
