// Wide triangles under a depth test: long blocks of 64 × 8 pixels are tested first, and only in those that may be seen their
// blocks of 8 × 8.
#if defined(RASTERDIFF_VALUE_LARGE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RASTERDIFF_VALUE_LARGE_INL_H
#undef RASTERDIFF_VALUE_LARGE_INL_H
#else
#define RASTERDIFF_VALUE_LARGE_INL_H
#endif

#include <bit>

#include "rasterizer/kernels/value_blocks-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rasterdiff::rasterizer {
namespace HWY_NAMESPACE {

/// Draws place `i` of the batch.
template <class P>
HWY_NOINLINE void DrawLarge(const ValueView& view, const ValueBatch& b, size_t i, Farthest& farthest, uint32_t number) {
  const D d;
  constexpr size_t kLong = kBlock * kBlocksOfLong;
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
        const float* HWY_RESTRICT longFar = farthest.LongRow(blockRow, s);
        for (size_t block = static_cast<size_t>(extent.from) / kLong; static_cast<double>(kLong * block) < extent.to; block += kLanes) {
          uint8_t bits[8] = {};
          hn::StoreMaskBits(d, Seen<P>(plane, row, plane.longLow, block, kLong, extent, longFar), bits);
          for (uint32_t rest = bits[0] & ((1u << kLanes) - 1); rest != 0; rest &= rest - 1) {
            const size_t first = (block + static_cast<size_t>(std::countr_zero(rest))) * kBlocksOfLong;
            for (size_t part = 0; part < kBlocksOfLong; part += kLanes) AppendSeen<P>(plane, row, first + part, extent, far, blockRow - group, seen);
            if (HWY_UNLIKELY(seen.size > SeenBlocks::kSize - kBlocksOfLong)) DrawSeen<P, true>(view, plane, s, group, farthest, number, seen);
          }
        }
      }
      DrawSeen<P, true>(view, plane, s, group, farthest, number, seen);
    }
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace rasterdiff::rasterizer
HWY_AFTER_NAMESPACE();
#endif
