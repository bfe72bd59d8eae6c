// The fast kernel for primitive index, overdraw count, depth and varyings: exact coverage, values within a stated bound.
//
// Coverage equals coverage_oracle.hpp for all int32 vertices. A depth is a plane through the three vertex values, anchored at
// vertex 0, evaluated in double precision and rounded once to float32; a varying is a weighted mean of the vertex values, from exact
// edge functions at the first of neighbouring pixels of one triangle, and linear from there. How far from the exact value that can be
// is proved in value_setup-inl.h (depth) and value_run_sums-inl.h (varyings) and computed by the bounds below: half a unit in the last
// place of float32 and next to nothing.
#pragma once

#include <array>

#include "rasterizer/kernels/value_target.hpp"

namespace rasterdiff::rasterizer {

/// Draws all triangles in order into the planes that the target has. The same planes, bit for bit, for every instruction
/// set and thread count (1 = on the calling thread; 0 = one for each core; threads share the target by bands of rows).
/// Varyings are evaluated once a sample, after the last triangle, and of equally deep triangles the one with the lowest number is
/// kept: the planes of numbers and varyings must be clear, or hold what earlier calls with the same triangles drew.
void drawValues(const ValueTriangles& triangles, ValueTarget& target, unsigned threads = 1);

/// Draws rows [firstRow, endRow) of all triangles, in order, into a target that begins there and is at least so high, without
/// varyings; firstRow is a multiple of 8. Triangles may have `corners`: then the target has all three planes, with depths that equal the reference's bit
/// for bit, and the number of fragments is returned that met exactly the depth of an earlier one (otherwise 0). `before`: how many
/// triangles earlier calls drew; numbers go on from there.
uint64_t drawBand(const ValueTriangles& triangles, ValueTarget& target, uint32_t firstRow, uint32_t endRow, uint32_t before);

/// Bound on |double - exact| of a depth at point `p` (1/256 pixel), before it is rounded to float32: 2^-49 times the
/// sum of the magnitudes that cancel in it. For |coordinates| <= 2^22; infinite where the triangle has no area.
[[nodiscard]] double linearValueBound(const SnappedTriangle& triangle, SubpixelPosition p, const std::array<double, 3>& values);
/// The same of a varying (1 / w all 1: of one without perspective), for any int32 coordinates: some 2^-48 of the values' magnitude, times
/// the ratio of the largest 1 / w to the smallest, times how much the triangle's area grows if its edges move outwards by half a pixel
/// (only centres outside of it need that: several samples); infinite where the denominator may be zero.
[[nodiscard]] double varyingBound(const SnappedTriangle& triangle, SubpixelPosition p, const std::array<float, 3>& values,
                                  const std::array<float, 3>& reciprocalW);

}  // namespace rasterdiff::rasterizer
