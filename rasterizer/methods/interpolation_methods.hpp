// Ways to interpolate a value over a triangle in float32, by name, and the answer they are measured against.
// [vk:primsrast-polygon-barycentrics] Which samples are covered is left to coverage.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

#include "scene/spaces.hpp"

namespace rasterdiff::rasterizer {

/// Vertices of nonzero area in 1/256 pixel, |coordinate| < 2^23 (exact in float32); w > 0; one value a vertex.
struct InterpolatedTriangle {
  std::array<SubpixelPosition, 3> position;
  std::array<float, 3> w = {1, 1, 1};
  std::array<float, 3> value;
};

/// Value at a point (1/256 pixel, on the row of some point of the triangle).
using Interpolate = float (*)(const InterpolatedTriangle& triangle, SubpixelPosition p);

/// Along the two edges that the row of p meets, then along the row. Lecture "Bilinear Interpolation".
[[nodiscard]] float interpolateBilinear(const InterpolatedTriangle& triangle, SubpixelPosition p);
/// v = -(A/C) x - (B/C) y - D/C with N = (P2 - P1) × (P3 - P1): anchored at the target's origin. Lecture.
[[nodiscard]] float interpolatePlane(const InterpolatedTriangle& triangle, SubpixelPosition p);
/// The same plane anchored at the first vertex: v1 + gx (x - x1) + gy (y - y1).
[[nodiscard]] float interpolatePlaneAtVertex(const InterpolatedTriangle& triangle, SubpixelPosition p);
/// γ = f(x, y) / f(xc, yc) with the expanded line equations f = (ya - yb) x + (xb - xa) y + xa yb - xb ya. Lecture.
[[nodiscard]] float interpolateBarycentric(const InterpolatedTriangle& triangle, SubpixelPosition p);
/// Weights from edge functions of differences, (b - a) × (p - a).
[[nodiscard]] float interpolateBarycentricDifferences(const InterpolatedTriangle& triangle, SubpixelPosition p);
/// (f/w) / (1/w), both by barycentric weights from differences. Lecture "Perspective-correct interpolation".
[[nodiscard]] float interpolatePerspective(const InterpolatedTriangle& triangle, SubpixelPosition p);
/// (f/w) / (1/w), both by planes anchored at the target's origin.
[[nodiscard]] float interpolatePerspectivePlane(const InterpolatedTriangle& triangle, SubpixelPosition p);

struct InterpolationMethod {
  std::string_view name, what;
  bool perspective = false;  ///< which of the two exact answers it aims at
  Interpolate at;
};

/// "bilinear", "plane", "plane-at-vertex", "barycentric", "barycentric-differences", "perspective",
/// "perspective-plane", and "affine": screen-linear weights where perspective is wanted.
[[nodiscard]] std::span<const InterpolationMethod> interpolationMethods();

/// The value in extended precision: integer edge functions Eᵢ, then Σ Eᵢ fᵢ / Σ Eᵢ, or Σ Eᵢ fᵢ/wᵢ / Σ Eᵢ/wᵢ.
/// Relative error below 2^-58 for values and weights of one sign, so below 2^-33 ULP of float32.
[[nodiscard]] long double interpolateExactly(const InterpolatedTriangle& triangle, SubpixelPosition p,
                                             bool perspective);

/// |value - exact| in units of the last place of float32 at `exact`.
[[nodiscard]] double ulpsFrom(long double exact, float value);

}  // namespace rasterdiff::rasterizer
