// What the depth test may leave out: blocks of 8 × 8 pixels that hide a triangle as a whole, how they are found, several at a
// time, and how the others are drawn, from one list. Which of them are looked at: value_medium-inl.h, value_large-inl.h.
//
// For each block `Farthest` is at least as far as any depth stored in it: drawing a block finds the farthest that it leaves
// behind, and whatever others draw only comes nearer. A triangle is hidden in a block if neither its plane at the block's
// corners nor its nearest vertex is nearer than that. What decides is conservative, so that the planes are bit for bit those
// without blocks: pixels and corners are evaluated from the same a0, gx, gy in doubles, in any order with at most 12 u S between them
// and the real plane, S = |a0| + |gx| (|x0| + width) + |gy| (|y0| + height), u = 2^-53; the margin is 2^-48 S = 32 u S; and rounding to
// float32 is monotone. Depths that are not numbers hide nothing, are passed by nothing and count for nothing.
#if defined(RASTERDIFF_VALUE_BLOCKS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RASTERDIFF_VALUE_BLOCKS_INL_H
#undef RASTERDIFF_VALUE_BLOCKS_INL_H
#else
#define RASTERDIFF_VALUE_BLOCKS_INL_H
#endif

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "rasterizer/kernels/value_rows-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rasterdiff::rasterizer {
namespace HWY_NAMESPACE {

inline constexpr size_t kBlock = 8;          // pixels a side
inline constexpr size_t kBlocksOfLong = 8;  // a long block is so many beside one another

/// Farthest depths of the blocks of a view; nothing until the first triangle that asks for them.
class Farthest {
 public:
  explicit Farthest(const ValueView& view)
      : view_(view), longColumns_((static_cast<size_t>(view.width) + kBlock * kBlocksOfLong - 1) / (kBlock * kBlocksOfLong) + kLanes) {}

  /// Of a block row at sample s, with a vector more than the blocks.
  float* Row(size_t blockRow, size_t s) {
    if (HWY_UNLIKELY(depths_.empty())) Create();
    return depths_.data() + Place(blockRow, s) * kBlocksOfLong;
  }
  float* LongRow(size_t blockRow, size_t s) {
    if (HWY_UNLIKELY(depths_.empty())) Create();
    return longDepths_.data() + Place(blockRow, s);
  }

 private:
  [[nodiscard]] size_t Place(size_t blockRow, size_t s) const {
    return ((blockRow - static_cast<size_t>(view_.firstRow) / kBlock) * view_.samples + s) * longColumns_;
  }

  void Create() {
    const size_t end = (static_cast<size_t>(view_.endRow) + kBlock - 1) / kBlock, size = Place(end, 0);
    depths_.assign(size * kBlocksOfLong, std::numeric_limits<float>::infinity());
    longDepths_.assign(size, std::numeric_limits<float>::infinity());
  }

  const ValueView& view_;
  size_t longColumns_;
  std::vector<float> depths_, longDepths_;
};

/// The depth plane of one triangle at one sample.
struct DepthPlane {
  double a0, gx, gy, fromX, fromY;  // value = (a0 + gy (y + fromY)) + gx (x + fromX)
  double nearest;                   // no pixel is nearer
  double low, longLow;              // added to the value at the first pixel of a block, a long one: no pixel is nearer
  double x0, y0, offsetX, offsetY;  // of the anchor and of the sample in its pixel: through corners
};

HWY_INLINE DepthPlane PlaneOf(const ValueView& view, const ValueBatch& b, size_t i, size_t s) {
  DepthPlane p{b.a0[i], b.gx[i], b.gy[i], view.x[s] / 256 - b.x0[i], view.y[s] / 256 - b.y0[i], 0, 0, 0,
               b.x0[i], b.y0[i], view.x[s] / 256, view.y[s] / 256};
  const double sum = std::fabs(p.a0) + std::fabs(p.gx) * (std::fabs(b.x0[i]) + view.width + kBlock * kBlocksOfLong) +
                     std::fabs(p.gy) * (std::fabs(b.y0[i]) + view.endRow + kBlock);
  const double margin = 0x1p-48 * sum, down = std::min(p.gy * (kBlock - 1), 0.0) - margin;
  p.nearest = b.nearest[i] - margin;
  p.low = std::min(p.gx * (kBlock - 1), 0.0) + down;
  p.longLow = std::min(p.gx * (kBlock * kBlocksOfLong - 1), 0.0) + down;
  return p;
}

/// Some block rows of a triangle, and their blocks that may be seen.
struct SeenBlocks {
  static constexpr size_t kRows = 16, kSize = 512;
  alignas(64) double begin[kRows][kBlock], end[kRows][kBlock];  // covered pixels of each row; none: begin > end
  size_t size = 0;
  uint64_t codes[kSize + 8];  // block | block row, from the first of them << 16
};

/// Pixels [from, to) that some row of a block row covers; from > to if none does.
struct Extent {
  double from, to;
};

/// Fills the rows of block row k, which begins at pixel row y.
HWY_INLINE Extent FindRows(const ValueBatch& b, size_t i, size_t s, double y, size_t k, SeenBlocks& seen) {
  const D d;
  const V infinity = hn::Set(d, std::numeric_limits<double>::infinity());
  V least = infinity, most = hn::Neg(infinity);
  for (size_t row = 0; row < kBlock; row += kLanes) {
    const V r = NumbersFrom(d, y + static_cast<double>(row));
    V begin, end;
    RowBounds(LinesOf(b, i), OffsetsOf(b, i, s), r, begin, end);
    const M inside = hn::And(hn::Lt(begin, end), hn::And(hn::Ge(r, hn::Set(d, b.firstRow[i])), hn::Lt(r, hn::Set(d, b.endRow[i]))));
    begin = hn::IfThenElse(inside, begin, infinity), end = hn::IfThenElse(inside, end, hn::Neg(infinity));
    hn::Store(begin, d, seen.begin[k] + row);
    hn::Store(end, d, seen.end[k] + row);
    least = hn::Min(least, begin), most = hn::Max(most, end);
  }
  return {hn::GetLane(hn::MinOfLanes(d, least)), hn::GetLane(hn::MaxOfLanes(d, most))};
}

/// Which of kLanes blocks of `width` pixels from `block` on may be seen: `row` is the plane's value at x = -fromX. Where meetings
/// are counted, a depth that is met has to be seen.
template <class P>
HWY_INLINE M Seen(const DepthPlane& plane, double row, double low, size_t block, double width, const Extent& extent, const float* HWY_RESTRICT far) {
  const D d;
  const hn::Rebind<float, D> f;
  const V x = (hn::Iota(d, 0) + hn::Set(d, static_cast<double>(block))) * hn::Set(d, width);
  const V corner = hn::Set(d, row) + hn::Set(d, plane.gx) * (x + hn::Set(d, plane.fromX));
  const auto nearest = hn::DemoteTo(f, hn::Max(corner + hn::Set(d, low), hn::Set(d, plane.nearest)));
  const V here = hn::PromoteTo(d, nearest), there = hn::PromoteTo(d, hn::LoadU(f, far + block));
  const M hidden = P::kCorners ? hn::Gt(here, there) : hn::Ge(here, there);
  const M touched = hn::And(hn::Lt(x, hn::Set(d, extent.to)), hn::Gt(x, hn::Set(d, extent.from - width)));
  return hn::AndNot(hidden, touched);
}

/// Draws the blocks of the list and empties it; kLong: long blocks are wanted.
template <class P, bool kLong>
HWY_INLINE void DrawSeen(const ValueView& target, const DepthPlane& plane, size_t s, size_t firstBlockRow, Farthest& farthest, uint32_t number,
                         SeenBlocks& seen) {
  if (seen.size == 0) return;
  const ValueView view = target;  // which no store can change
  const D d;
  const DU du;
  const ChunkF f;
  constexpr size_t kAhead = 6;
  const size_t rowElements = view.samples * view.stride;
  const auto elementOf = [&](uint64_t code) { return (kBlock * (firstBlockRow + (code >> 16)) * view.samples + s) * view.stride + kBlock * (code & 0xFFFF); };
  const auto prefetch = [&](size_t n) {
    size_t element = elementOf(seen.codes[std::min(n, seen.size - 1)]);
    for (size_t row = 0; row < kBlock; ++row, element += rowElements) {
      __builtin_prefetch(view.depth + element, 1);
      if (P::kPrimitive) __builtin_prefetch(view.primitive + element, 1);
      if (P::kCount) __builtin_prefetch(view.count + element, 1);
    }
  };
  for (size_t n = 0; n < kAhead; ++n) prefetch(n);
  for (size_t n = 0; n < seen.size; ++n) {
    prefetch(n + kAhead);
    const size_t block = seen.codes[n] & 0xFFFF, k = seen.codes[n] >> 16, blockRow = firstBlockRow + k;
    const auto x = static_cast<double>(kBlock * block), y = static_cast<double>(kBlock * blockRow);
    alignas(64) double start[kBlock];
    alignas(64) uint64_t bits[kBlock];
    for (size_t row = 0; row < kBlock; row += kLanes) {
      const V left = hn::Set(d, x), pixelRow = NumbersFrom(d, y + static_cast<double>(row)), r = pixelRow + hn::Set(d, plane.fromY);
      hn::Store(BitsBetween(hn::Load(d, seen.begin[k] + row) - left, hn::Load(d, seen.end[k] + row) - left), du, bits + row);
      const V rise = hn::Set(d, plane.gy) * ((pixelRow + hn::Set(d, plane.offsetY)) - hn::Set(d, plane.y0));
      const V chunk = (hn::Set(d, plane.a0) + hn::Set(d, plane.gy) * r) + hn::Set(d, plane.gx * (plane.fromX + x));
      hn::Store(P::kCorners ? rise : chunk, d, start + row);
    }
    const size_t rows = std::min(kBlock, static_cast<size_t>(view.endRow) - kBlock * blockRow);
    size_t element = elementOf(seen.codes[n]);
    auto most = hn::Set(f, -std::numeric_limits<float>::infinity());
    for (size_t row = 0; row < rows; ++row, element += rowElements)
      for (size_t first = 0; first < kBlock; first += kChunkLanes)
        most = hn::Max(WriteChunk<P>(view, element + first, ChunkMask(static_cast<uint32_t>(bits[row]) >> first),
                                     ChunkDepth<P>({start[row], plane.gx, plane.a0, plane.x0, plane.offsetX + x}, first), number), most);
    float* HWY_RESTRICT far = farthest.Row(blockRow, s);
    const auto here = hn::MaxOfLanes(f, most);
    if (kLong) {
      // The block itself is not loaded: that would wait until it is stored.
      auto all = here;
      for (size_t first = 0, from = block / kBlocksOfLong * kBlocksOfLong; first < kBlocksOfLong; first += kChunkLanes) {
        const hn::Mask<ChunkF> itself = hn::Eq(hn::Iota(f, static_cast<float>(first)), hn::Set(f, static_cast<float>(block - from)));
        all = hn::Max(all, hn::IfThenElse(itself, here, hn::LoadU(f, far + from + first)));
      }
      farthest.LongRow(blockRow, s)[block / kBlocksOfLong] = hn::GetLane(hn::MaxOfLanes(f, all));
    }
    far[block] = hn::GetLane(here);
  }
  seen.size = 0;
}

/// Appends those of kLanes blocks that may be seen.
template <class P>
HWY_INLINE void AppendSeen(const DepthPlane& plane, double row, size_t block, const Extent& extent, const float* HWY_RESTRICT far, size_t k, SeenBlocks& seen) {
  Append(NumbersFrom(DU(), block | k << 16), Seen<P>(plane, row, plane.low, block, kBlock, extent, far), seen.codes, seen.size);
}

}  // namespace HWY_NAMESPACE
}  // namespace rasterdiff::rasterizer
HWY_AFTER_NAMESPACE();
#endif
