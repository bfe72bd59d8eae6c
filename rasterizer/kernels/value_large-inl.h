// Wide triangles under a depth test: blocks of 64 pixels × 8 rows that are hidden as a whole are left out, several at a time.
//
// For each block the view keeps `farthest`, at least as far as any depth stored in it. It falls only where a triangle fills a
// block: then each pixel holds the nearer of what it held and the triangle's depth. A triangle is hidden in a block if even the
// nearest of its plane at the block's corners is not nearer than that. What decides is conservative, so that the planes are bit
// for bit those without blocks: pixels and corners are evaluated from the same a0, gx, gy in doubles, with at most 12 u S
// between them and the real plane, S = |a0| + |gx| (|x0| + width) + |gy| (|y0| + height), u = 2^-53; the margin is 2^-48 S = 32 u S;
// and rounding to float32 is monotone. A depth that is not a number hides nothing.
#if defined(RASTERDIFF_VALUE_LARGE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RASTERDIFF_VALUE_LARGE_INL_H
#undef RASTERDIFF_VALUE_LARGE_INL_H
#else
#define RASTERDIFF_VALUE_LARGE_INL_H
#endif

#include <algorithm>
#include <bit>
#include <cmath>

#include "rasterizer/kernels/value_rows-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rasterdiff::rasterizer {
namespace HWY_NAMESPACE {

inline constexpr int32_t kBlockWidth = 64, kBlockHeight = 8;  // pixels

/// Covered pixels [begin, end) of the eight rows of a block row, and the blocks they touch and fill.
struct BlockRow {
  alignas(64) int32_t begin[kBlockHeight], end[kBlockHeight];
  int32_t firstBlock, endBlock, firstFull, endFull;
};

HWY_INLINE void FindBlockRow(const ValueBatch& b, size_t i, size_t s, double y, BlockRow& rows) {
  const D d;
  const DI di;
  V leastBegin = hn::Set(d, 65536), mostBegin = hn::Zero(d), leastEnd = leastBegin, mostEnd = mostBegin;
  for (size_t k = 0; k < kBlockHeight; k += kLanes) {
    const V r = hn::Iota(d, y + static_cast<double>(k));
    V begin, end;
    RowBounds(b, i, s, r, begin, end);
    const M inside = hn::And(hn::Lt(begin, end), hn::And(hn::Ge(r, hn::Set(d, b.firstRow[i])), hn::Lt(r, hn::Set(d, b.endRow[i]))));
    begin = hn::IfThenElse(inside, begin, hn::Set(d, 65536)), end = hn::IfThenElseZero(inside, end);
    leastBegin = hn::Min(leastBegin, begin), mostBegin = hn::Max(mostBegin, begin);
    leastEnd = hn::Min(leastEnd, end), mostEnd = hn::Max(mostEnd, end);
    hn::Store(hn::DemoteTo(di, begin), di, rows.begin + k);
    hn::Store(hn::DemoteTo(di, end), di, rows.end + k);
  }
  const auto least = [&](V v) { return static_cast<int32_t>(hn::GetLane(hn::MinOfLanes(d, v))); };
  const auto most = [&](V v) { return static_cast<int32_t>(hn::GetLane(hn::MaxOfLanes(d, v))); };
  rows.firstBlock = least(leastBegin) / kBlockWidth;
  rows.endBlock = (most(mostEnd) + kBlockWidth - 1) / kBlockWidth;
  rows.firstFull = (most(mostBegin) + kBlockWidth - 1) / kBlockWidth;
  rows.endFull = least(leastEnd) / kBlockWidth;
}

/// The depth plane of one triangle at one sample.
struct DepthPlane {
  double a0, gx, gy, fromX, fromY;  // value = (a0 + gy (y + fromY)) + gx (x + fromX)
  double margin;                    // more than all roundings of a pixel and of a block's corner
  double low, high;                 // added to the value at a block's first pixel: no pixel is nearer or farther
};

/// For blocks of kWidth × kHeight pixels.
template <int kWidth, int kHeight>
HWY_INLINE DepthPlane PlaneOf(const ValueView& view, const ValueBatch& b, size_t i, size_t s) {
  DepthPlane p{b.a0[i], b.gx[i], b.gy[i], view.x[s] / 256 - b.x0[i], view.y[s] / 256 - b.y0[i], 0, 0, 0};
  const double across = p.gx * (kWidth - 1), down = p.gy * (kHeight - 1);
  const double sum = std::fabs(p.a0) + std::fabs(p.gx) * (std::fabs(b.x0[i]) + view.width + kBlockWidth) +
                     std::fabs(p.gy) * (std::fabs(b.y0[i]) + view.endRow + kBlockHeight);
  p.margin = 0x1p-48 * sum;
  p.low = std::min(across, 0.0) + std::min(down, 0.0) - p.margin;
  p.high = std::max(across, 0.0) + std::max(down, 0.0) + p.margin;
  return p;
}

template <class P>
HWY_INLINE void DrawBlock(const ValueView& view, const DepthPlane& plane, const BlockRow& rows, int32_t block, size_t s, double y,
                          uint32_t number) {
  for (int32_t k = 0; k < kBlockHeight; ++k) {
    const int32_t begin = std::max(rows.begin[k], block * kBlockWidth), end = std::min(rows.end[k], (block + 1) * kBlockWidth);
    const double row = plane.a0 + plane.gy * (y + k + plane.fromY);
    const size_t element = (static_cast<size_t>(y) + static_cast<size_t>(k)) * view.samples * view.stride + s * view.stride;
    for (int32_t x = begin & ~static_cast<int32_t>(kChunk - 1); x < end; x += static_cast<int32_t>(kChunk)) {
      const double chunk = row + plane.gx * (plane.fromX + x);
      const uint32_t from = 0xFFu << std::max(begin - x, 0), to = 0xFFu << std::min(end - x, 8);
      for (size_t first = 0; first < kChunk; first += kChunkLanes)
        WriteChunk<P>(view, element + static_cast<size_t>(x) + first, ChunkMask((from & ~to) >> first), ChunkDepth(chunk, plane.gx, first), number);
    }
  }
}

/// Draws place `i` of the batch, of any size.
template <class P>
HWY_NOINLINE void DrawLarge(const ValueView& view, const ValueBatch& b, size_t i, uint32_t number) {
  const D d;
  const hn::Rebind<float, D> df;
  BlockRow rows;
  const auto firstBlockRow = static_cast<int32_t>(b.firstRow[i]) / kBlockHeight;
  for (size_t s = 0; s < view.samples; ++s) {
    const DepthPlane plane = PlaneOf<kBlockWidth, kBlockHeight>(view, b, i, s);
    for (int32_t blockRow = firstBlockRow; blockRow * kBlockHeight < b.endRow[i]; ++blockRow) {
      const double y = blockRow * kBlockHeight;
      FindBlockRow(b, i, s, y, rows);
      float* HWY_RESTRICT farthest = view.farthest + (static_cast<size_t>(blockRow) * view.samples + s) * view.blockColumns;
      const V row = hn::Set(d, plane.a0 + plane.gy * (y + plane.fromY));
      for (int32_t block = rows.firstBlock; block < rows.endBlock; block += static_cast<int32_t>(kLanes)) {
        const V x = hn::Iota(d, block) * hn::Set(d, kBlockWidth);
        const V corner = row + hn::Set(d, plane.gx) * (x + hn::Set(d, plane.fromX));
        const auto nearest = hn::DemoteTo(df, corner + hn::Set(d, plane.low));
        alignas(64) float far[kLanes];
        hn::Store(hn::DemoteTo(df, corner + hn::Set(d, plane.high)), df, far);
        const auto hidden = hn::Ge(nearest, hn::LoadU(df, farthest + block));
        uint8_t bits[8] = {};
        hn::StoreMaskBits(df, hn::Not(hidden), bits);
        uint32_t seen = bits[0] & ((1u << kLanes) - 1);
        const int32_t left = rows.endBlock - block;
        if (left < static_cast<int32_t>(kLanes)) seen &= (1u << left) - 1;
        for (; seen != 0; seen &= seen - 1) {
          const int32_t k = std::countr_zero(seen), at = block + k;
          DrawBlock<P>(view, plane, rows, at, s, y, number);
          if (at >= rows.firstFull && at < rows.endFull) farthest[at] = std::min(farthest[at], far[k]);
        }
      }
    }
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace rasterdiff::rasterizer
HWY_AFTER_NAMESPACE();
#endif
