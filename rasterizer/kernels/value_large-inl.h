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

/// TouchedBlocks, one by one.
struct WideRows {
  alignas(64) int32_t first[kLanes];
  alignas(64) float size[kLanes], least[kLanes];

  HWY_INLINE explicit WideRows(const TouchedBlocks& touched) {
    const hn::Rebind<float, D> f;
    StoreInt(touched.first, first);
    hn::Store(hn::DemoteTo(f, touched.size), f, size);
    hn::Store(touched.least, f, least);
  }
};

/// Draws place `i` of the batch; the list is empty before and after.
template <class P>
HWY_NOINLINE void DrawLarge(const ValueView& view, const ValueBatch& b, size_t i, Farthest& farthest, SeenBlocks& seen) {
  const D d;
  const BlockF f;
  farthest.Create();
  const double firstRow = b.firstRow[i], endRow = b.endRow[i];
  const size_t firstBlockRow = static_cast<size_t>(firstRow) / kBlock, endBlockRow = (static_cast<size_t>(endRow) + kBlock - 1) / kBlock;
  const RowLines lines = LinesOf(b, i);
  for (size_t s = 0; s < view.samples; ++s) {
    const BlockPlane plane = PlaneOf(view, b, i, s), longPlane = LongPlaneOf(plane);
    const RowOffsets offsets = OffsetsOf(b, i, s);
    for (size_t group = firstBlockRow; group < endBlockRow; group += kLanes) {
      const V y = NumbersFrom(d, static_cast<double>(group)) * hn::Set(d, kBlock);
      const WideRows rows(FindTouched(lines, offsets, firstRow, endRow, y, plane));
      const WideRows longRows(FindTouched(lines, offsets, firstRow, endRow, y, longPlane));
      for (size_t k = 0; k < std::min(kLanes, endBlockRow - group); ++k) {
        const float* HWY_RESTRICT far = farthest.Row(group + k, s);
        const float* HWY_RESTRICT longFar = farthest.LongRow(group + k, s);
        const uint64_t code = (group + k) << 11 | s << 22 | i << 26;
        const auto first = static_cast<size_t>(rows.first[k]), firstLong = static_cast<size_t>(longRows.first[k]);
        const size_t end = first + static_cast<size_t>(rows.size[k]);
        for (size_t n = 0; static_cast<float>(n) < longRows.size[k]; n += kBlockLanes) {
          uint8_t bits[8] = {};
          const auto longNearest = NearestOf(longPlane.step, plane.nearest, longRows.least[k], static_cast<float>(n));
          hn::StoreMaskBits(f, Seen<P>(longNearest, longRows.size[k] - static_cast<float>(n), longFar + firstLong + n), bits);
          for (uint32_t rest = bits[0]; rest != 0; rest &= rest - 1) {
            const size_t from = (firstLong + n + static_cast<size_t>(std::countr_zero(rest))) * kBlocksOfLong;
            const size_t block = std::max(from, first), size = std::min(from + kBlocksOfLong, end) - block;
            for (size_t part = 0; part < size; part += kBlockLanes) {
              const auto nearest = NearestOf(plane.step, plane.nearest, rows.least[k], static_cast<float>(block + part - first));
              const auto which = Seen<P>(nearest, static_cast<float>(size - part), far + block + part);
              AppendBlocks(nearest, which, code + block + part, seen.codes, seen.size);
            }
            if (HWY_UNLIKELY(seen.size > SeenBlocks::kRoom)) DrawSeen<P, true>(view, b, farthest, seen);
          }
        }
      }
    }
  }
  DrawSeen<P, true>(view, b, farthest, seen);
}

}  // namespace HWY_NAMESPACE
}  // namespace rasterdiff::rasterizer
HWY_AFTER_NAMESPACE();
#endif
