// The slow, obviously right definition of coverage: three integer edge functions at every sample of a triangle's box.
#pragma once

#include <span>

#include "rasterizer/kernels/coverage_mask.hpp"
#include "rasterizer/kernels/snapped_triangle.hpp"

namespace rasterdiff::rasterizer {

/// Does the triangle cover the point `p` (1/256 pixel)? Inside, or on a top or left edge. [choice:tie-owner]
/// A top edge is horizontal with the interior below; a left edge has the interior to its right.
/// |coordinates| < 2^29.  // Q23.8: differences < 2^30, products < 2^60, edge functions < 2^61
[[nodiscard]] bool covers(const SnappedTriangle& triangle, SubpixelPosition p);

/// Adds the coverage of all triangles to the mask, sample by sample. Same |coordinates| as `covers`.
void drawCoverageOracle(std::span<const SnappedTriangle> triangles, CoverageMask& mask);

}  // namespace rasterdiff::rasterizer
