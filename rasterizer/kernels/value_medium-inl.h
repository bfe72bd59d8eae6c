// Triangles of hundreds of pixels under a depth test: all of a triangle's blocks are tested, then those that may be seen drawn.
#if defined(RASTERDIFF_VALUE_MEDIUM_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RASTERDIFF_VALUE_MEDIUM_INL_H
#undef RASTERDIFF_VALUE_MEDIUM_INL_H
#else
#define RASTERDIFF_VALUE_MEDIUM_INL_H
#endif

#include "rasterizer/kernels/value_blocks-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rasterdiff::rasterizer {
namespace HWY_NAMESPACE {

/// Draws place `i` of the batch.
template <class P>
HWY_NOINLINE void DrawMedium(const ValueView& view, const ValueBatch& b, size_t i, Farthest& farthest, uint32_t number) {
  const size_t firstBlockRow = static_cast<size_t>(b.firstRow[i]) / kBlock, endBlockRow = (static_cast<size_t>(b.endRow[i]) + kBlock - 1) / kBlock;
  SeenBlocks seen;
  for (size_t s = 0; s < view.samples; ++s) {
    const DepthPlane plane = PlaneOf(view, b, i, s);
    for (size_t group = firstBlockRow; group < endBlockRow; group += SeenBlocks::kRows) {
      for (size_t blockRow = group; blockRow < std::min(endBlockRow, group + SeenBlocks::kRows); ++blockRow) {
        const double y = static_cast<double>(kBlock * blockRow);
        const Extent extent = FindRows(b, i, s, y, blockRow - group, seen);
        if (!(extent.from < extent.to)) continue;
        const double row = plane.a0 + plane.gy * (y + plane.fromY);
        const float* HWY_RESTRICT far = farthest.Row(blockRow, s);
        for (size_t block = static_cast<size_t>(extent.from) / kBlock; static_cast<double>(kBlock * block) < extent.to; block += kLanes) {
          AppendSeen<P>(plane, row, block, extent, far, blockRow - group, seen);
          if (HWY_UNLIKELY(seen.size > SeenBlocks::kSize - kLanes)) DrawSeen<P, false>(view, plane, s, group, farthest, number, seen);
        }
      }
      DrawSeen<P, false>(view, plane, s, group, farthest, number, seen);
    }
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace rasterdiff::rasterizer
HWY_AFTER_NAMESPACE();
#endif
