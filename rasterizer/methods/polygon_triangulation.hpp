// Polygon to triangles with the tessellator of the GL utility library (it needs no GL context), the one that the
// lecture names. It also turns crossings of the contour into vertices; these need not lie on the grid.
#pragma once

#include <vector>

#include "rasterizer/kernels/snapped_triangle.hpp"
#include "rasterizer/methods/polygon.hpp"

namespace rasterdiff::rasterizer {

struct Triangulation {
  std::vector<SnappedTriangle> triangles;  ///< disjoint, in either winding, without zero areas
  /// Crossings that were rounded to the grid: with none the triangles cover exactly what the polygon covers.
  uint32_t roundedVertices = 0;
};

/// Triangles that fill the polygon under `rule`; none if it has no area. Error: BadInput as in checkPolygon, or if the
/// library gives up on the polygon.
[[nodiscard]] Result<Triangulation> triangulate(const Polygon& polygon, FillRule rule);

}  // namespace rasterdiff::rasterizer
