// Triangles of hundreds of pixels under a depth test: from triangles to block rows, from those to blocks that may be seen, one flat list
// after the other, so that no loop a triangle or a row mispredicts its end.
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

/// Block rows, triangle by triangle, and the blocks that are touched there.
struct BlockRows {
  static constexpr size_t kSize = 256, kRoom = kSize - kLanes;
  uint32_t codes[kSize];  // the first one's in SeenBlocks, without its depth
  int32_t far[kSize];     // where its farthest depth is
  float sizes[kSize];     // how many they are
  float least[kSize];     // no pixel of the first one is nearer
  size_t size = 0;
};

/// Appends the blocks of the list that may be seen to `seen`, drawing what does not fit, and empties it.
template <class P>
HWY_NOINLINE void FindSeen(const ValueView& view, const ValueBatch& b, Farthest& farthest, BlockRows& rows, SeenBlocks& seen) {
  const float* depths = farthest.Row(farthest.FirstBlockRow(), 0);
  size_t size = seen.size;
  for (size_t k = 0; k < rows.size; ++k) {
    const uint64_t code = rows.codes[k];
    const size_t i = code >> 26;
    const float* HWY_RESTRICT far = depths + rows.far[k];
    const auto append = [&](size_t n) __attribute__((always_inline)) {
      const auto nearest = NearestOf(b.step[i], b.nearestSeen[i], rows.least[k], static_cast<float>(n));
      AppendBlocks(nearest, Seen<P>(nearest, rows.sizes[k] - static_cast<float>(n), far + n), code + n, seen.codes, size);
      if (HWY_LIKELY(size <= SeenBlocks::kRoom)) return;
      seen.size = size;
      DrawSeen<P, false>(view, b, farthest, seen);
      size = 0;
    };
    append(0);
    for (size_t n = kBlockLanes; static_cast<float>(n) < rows.sizes[k]; n += kBlockLanes) append(n);
  }
  seen.size = size;
  rows.size = 0;
}

/// Draws the triangles of b.places [begin, end).
template <class P>
HWY_NOINLINE void DrawMedium(const ValueView& view, const ValueBatch& b, size_t begin, size_t end, Farthest& farthest, SeenBlocks& seen) {
  const D d;
  const hn::Rebind<float, D> f;
  const hn::Rebind<uint32_t, D> u;
  farthest.Create();
  const V perBlock = hn::Set(d, 1.0 / kBlock), rowSize = hn::Set(d, static_cast<double>(farthest.RowSize()));
  const V firstBlockRow = hn::Set(d, static_cast<double>(farthest.FirstBlockRow()));
  BlockRows rows;
  for (size_t n = begin; n < end; ++n) {
    const size_t i = b.places[n];
    const double firstRow = b.firstRow[i], endRow = b.endRow[i];
    const RowLines lines = LinesOf(b, i);
    for (size_t s = 0; s < view.samples; ++s) {
      const BlockPlane plane = PlaneOf(view, b, i, s);
      const RowOffsets offsets = OffsetsOf(b, i, s);
      auto top = static_cast<double>(static_cast<size_t>(firstRow) / kBlock * kBlock);
      for (; top < endRow; top += static_cast<double>(kBlock * kLanes)) {
        if (HWY_UNLIKELY(rows.size > BlockRows::kRoom)) FindSeen<P>(view, b, farthest, rows, seen);
        const V y = hn::Iota(d, 0) * hn::Set(d, kBlock) + hn::Set(d, top), blockRow = y * perBlock;
        const TouchedBlocks touched = FindTouched(lines, offsets, firstRow, endRow, y, plane);
        const V far = hn::MulAdd(blockRow - firstBlockRow, rowSize, touched.first + hn::Set(d, static_cast<double>(s * farthest.SampleSize())));
        const V code = hn::MulAdd(blockRow, hn::Set(d, 1 << 11), touched.first + hn::Set(d, static_cast<double>(s << 22)));
        hn::StoreU(hn::BitCast(u, hn::DemoteTo(DI(), code)) + hn::Set(u, static_cast<uint32_t>(i << 26)), u, rows.codes + rows.size);
        hn::StoreU(hn::DemoteTo(DI(), far), DI(), rows.far + rows.size);
        hn::StoreU(hn::DemoteTo(f, touched.size), f, rows.sizes + rows.size);
        hn::StoreU(touched.least, f, rows.least + rows.size);
        rows.size += std::min(kLanes, (static_cast<size_t>(endRow - top) + kBlock - 1) / kBlock);
      }
    }
  }
  FindSeen<P>(view, b, farthest, rows, seen);
  DrawSeen<P, false>(view, b, farthest, seen);
}

}  // namespace HWY_NAMESPACE
}  // namespace rasterdiff::rasterizer
HWY_AFTER_NAMESPACE();
#endif
