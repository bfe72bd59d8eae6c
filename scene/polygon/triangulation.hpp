// Polygon to triangles with the tessellator of the GL utility library (it needs no GL context), the one that the
// lecture names. It also turns crossings of the contour into vertices; these need not lie on the grid.
#pragma once

#include <array>
#include <vector>

#include "scene/polygon/polygon.hpp"

namespace rasterdiff {

struct Triangulation {
  std::vector<std::array<SubpixelPosition, 3>> triangles;  ///< disjoint, in either winding, without zero areas
  /// Crossings that were rounded to the grid: with none the triangles cover exactly what the polygon covers.
  uint32_t roundedVertices = 0;
};

/// Triangles that fill the polygon under `rule`; none if it has no area. Error: BadInput as in checkPolygon, or if the
/// library gives up on the polygon.
[[nodiscard]] Result<Triangulation> triangulate(const Polygon& polygon, FillRule rule);

}  // namespace rasterdiff
