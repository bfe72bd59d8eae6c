// Inputs on which the methods are measured: friendly ones, and hard ones that hit borders, lose digits or cross
// themselves. The same seed gives the same inputs everywhere.
#pragma once

#include "rasterizer/kernels/snapped_triangle.hpp"
#include "rasterizer/methods/interpolation_methods.hpp"
#include "rasterizer/methods/polygon.hpp"
#include "scene/generators/prng.hpp"

namespace rasterdiff::rasterizer {

/// Polygons lie within this many pixels a side.
inline constexpr int32_t kInputExtent = 32;

/// The convex hull of a few points on the 1/256 grid.
[[nodiscard]] Polygon convexPolygon(Prng& prng);
/// Simple, star-shaped, with notches; vertices on the ½ grid, so that many edges and vertices meet pixel centres.
[[nodiscard]] Polygon concavePolygon(Prng& prng);
/// Five to nine arbitrary vertices on the ½ grid.
[[nodiscard]] Polygon crossingPolygon(Prng& prng);

struct LineEnds {
  SubpixelPosition a, b;
};
/// Both ends on pixel centres.
[[nodiscard]] LineEnds centredLine(Prng& prng);
/// Ends on the 1/256 grid, or on the ¼ grid, where ends meet edges and corners of diamonds.
[[nodiscard]] LineEnds hardLine(Prng& prng);

/// Nonzero area, 8 to 40 pixels, near the origin of the target.
[[nodiscard]] SnappedTriangle mediumTriangle(Prng& prng);
/// Long and about a pixel wide or less.
[[nodiscard]] SnappedTriangle sliverTriangle(Prng& prng);
/// As the medium one, at 16,000 pixels from the origin.
[[nodiscard]] SnappedTriangle farTriangle(Prng& prng);
/// One to two pixels a side.
[[nodiscard]] SnappedTriangle tinyTriangle(Prng& prng);

/// Values in [¼, 1]; w in [1, ratio], spread evenly over the logarithm (ratio 1: all w = 1).
[[nodiscard]] InterpolatedTriangle withValues(const SnappedTriangle& triangle, double ratio, Prng& prng);
/// A point of the 1/256 grid in the closed triangle.
[[nodiscard]] SubpixelPosition pointInside(const SnappedTriangle& triangle, Prng& prng);

}  // namespace rasterdiff::rasterizer
