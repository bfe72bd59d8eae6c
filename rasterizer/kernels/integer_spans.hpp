// The fallback of the fast kernel for far vertices: exact spans by integer division, for every int32 coordinate.
#pragma once

#include "rasterizer/kernels/coverage_mask.hpp"
#include "rasterizer/kernels/snapped_triangle.hpp"

namespace rasterdiff::rasterizer {

/// Pixels [begin, end) whose sample a triangle covers in one row; empty when begin >= end.
struct IntegerSpan {
  int64_t begin = 0, end = 0;
};

/// The span of sample `at` in pixel row `y`, clipped to [0, width). Exact: 128-bit numerators.
[[nodiscard]] IntegerSpan integerSpan(const SnappedTriangle& triangle, int64_t y, SampleLocation at, int64_t width);

/// Adds one triangle to the mask.
void drawIntegerSpans(const SnappedTriangle& triangle, CoverageMask& mask);

}  // namespace rasterdiff::rasterizer
