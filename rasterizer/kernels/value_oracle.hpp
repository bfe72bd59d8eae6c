// The slow definition of what the value kernels draw: integer edge functions at every sample, values correctly rounded.
#pragma once

#include <array>

#include "rasterizer/kernels/value_target.hpp"

namespace rasterdiff::rasterizer {

/// A value at point `p` (1/256 pixel): Σ bᵢ aᵢ, or with 1 / w at the vertices Σ bᵢ aᵢ rᵢ / Σ bᵢ rᵢ, in arithmetic of 113 bits
/// and rounded once to double precision. The numerators are exact for |coordinates| < 2^22 where vertex values are within
/// 2^28 of one another, so that a result rounded on to float32 is the nearest but for quotients within 2^-52 of a tie.
/// The triangle must have an area. [vk:primsrast-polygon-barycentrics]
[[nodiscard]] double exactValue(const SnappedTriangle& triangle, SubpixelPosition p, const std::array<float, 3>& vertexValues);
[[nodiscard]] double exactPerspectiveValue(const SnappedTriangle& triangle, SubpixelPosition p,
                                           const std::array<float, 3>& vertexValues, const std::array<float, 3>& reciprocalW);

/// Draws all triangles in order, sample by sample; |coordinates| < 2^29.
void drawValuesOracle(const ValueTriangles& triangles, ValueTarget& target);

}  // namespace rasterdiff::rasterizer
