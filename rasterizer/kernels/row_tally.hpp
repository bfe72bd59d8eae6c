// How the samples of triangles lie, counted without drawing them: inside, on edges, at ends of rows. For statistics of rules;
// the planes are value_kernel.hpp's.
#pragma once

#include <cstdint>
#include <span>

#include "rasterizer/kernels/snapped_triangle.hpp"

namespace rasterdiff::rasterizer {

struct RowTally {
  uint64_t inside = 0;      ///< samples covered, once for each triangle
  uint64_t ties = 0;        ///< samples exactly on an edge of the closed triangle
  uint64_t cutQuads = 0;    ///< ends of covered runs inside of a pair of pixels
  uint64_t partlyCovered = 0;  ///< rows in which not every sample has the same pixels
  RowTally& operator+=(const RowTally& other);
};

/// Where to count: pixels [0, width) of rows [firstRow, endRow); `pattern`: sample offsets in 1/256 pixel.
struct TallyArea {
  int32_t width = 0, firstRow = 0, endRow = 0;
  std::span<const SubpixelPosition> pattern;
};

/// Of triangles that are wound clockwise to the eye, with positions within ±2^29; ties are owned by top and left edges. Exact, and
/// the same for every instruction set.
[[nodiscard]] RowTally tallyRows(std::span<const SnappedTriangle> triangles, const TallyArea& area);

/// The definition, in integers, of one triangle.
[[nodiscard]] RowTally tallyRowsExactly(const SnappedTriangle& triangle, const TallyArea& area);

}  // namespace rasterdiff::rasterizer
