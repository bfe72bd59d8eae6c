// The definition of what a polygon covers: the winding number of a point. How to find the covered pixels faster than by
// asking for each of them is left to the polygon methods.
#pragma once

#include "rasterizer/methods/pixel_mask.hpp"
#include "scene/polygon/polygon.hpp"

namespace rasterdiff::rasterizer {

/// Largest mask, pixels a side.
inline constexpr int32_t kMaxMaskExtent = 1 << 14;

/// The polygon as rasterdiff::checkPolygon has it, and a mask of 1..kMaxMaskExtent pixels a side. Error: BadInput.
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
