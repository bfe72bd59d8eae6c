// A polygon on the subpixel grid, and the definition of what it covers: the winding number of a point. How to find the
// covered pixels faster than by asking for each of them is left to the polygon methods.
#pragma once

#include <vector>

#include "rasterizer/methods/pixel_mask.hpp"
#include "scene/result.hpp"
#include "scene/spaces.hpp"

namespace rasterdiff::rasterizer {

/// One closed contour (the last vertex is joined to the first), in any winding; it may be concave and cross itself.
struct Polygon {
  std::vector<SubpixelPosition> vertices;
  friend bool operator==(const Polygon&, const Polygon&) = default;
};

enum class FillRule : uint8_t {
  EvenOdd,  ///< inside where the winding number is odd (parity)
  NonZero,  ///< inside where it is not zero
};

inline constexpr size_t kMaxPolygonVertices = size_t{1} << 20;
/// Largest |coordinate|, 1/256 pixel, that keeps all products of the polygon methods within 64 bits.
inline constexpr int32_t kMaxPolygonCoordinate = 1 << 28;
/// Largest mask, pixels a side.
inline constexpr int32_t kMaxMaskExtent = 1 << 14;

/// At least three vertices, at most kMaxPolygonVertices, all coordinates in range, mask of 1..kMaxMaskExtent pixels.
/// Error: BadInput.
[[nodiscard]] Result<void> checkPolygon(const Polygon& polygon, int32_t width, int32_t height);

[[nodiscard]] constexpr bool isInside(int32_t windingNumber, FillRule rule) {
  return rule == FillRule::EvenOdd ? windingNumber % 2 != 0 : windingNumber != 0;
}

/// How often the contour runs around `p` (1/256 pixel), clockwise to the eye counted positive. A point on an edge
/// counts as the point (ε, ε²) further right and down, so that left and top edges own their points and a triangle
/// covers what edge functions with top-left ties say. [choice:tie-owner]
[[nodiscard]] int32_t windingNumber(const Polygon& polygon, SubpixelPosition p);

/// Asks for every pixel centre: the exact answer that the other methods are measured against.
[[nodiscard]] PixelMask drawPolygonByWinding(const Polygon& polygon, FillRule rule, int32_t width, int32_t height);

}  // namespace rasterdiff::rasterizer
