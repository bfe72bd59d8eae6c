// Triangles of hundreds of pixels under a depth test: blocks of 8 × 8 pixels that are hidden as a whole are left out. First all
// blocks of a triangle are tested, several at a time, then those that may be seen are drawn, from one list.
//
// For each block `farthest` is at least as far as any depth stored in it: drawing a block finds the farthest that it leaves
// behind, and whatever others draw only comes nearer. A triangle is hidden in a block if neither its plane at the block's
// corners nor its nearest vertex is nearer than that, by the margin of value_large-inl.h: conservative, the planes are bit for
// bit those without blocks. Stored depths that are not numbers are passed by nothing and count for nothing.
#if defined(RASTERDIFF_VALUE_MEDIUM_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RASTERDIFF_VALUE_MEDIUM_INL_H
#undef RASTERDIFF_VALUE_MEDIUM_INL_H
#else
#define RASTERDIFF_VALUE_MEDIUM_INL_H
#endif

#include <algorithm>
#include <limits>
#include <vector>

#include "rasterizer/kernels/value_large-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rasterdiff::rasterizer {
namespace HWY_NAMESPACE {

inline constexpr size_t kBlock = 8;  // pixels a side

/// Farthest depths of the blocks of a view; nothing until the first triangle that asks for them.
class Farthest {
 public:
  explicit Farthest(const ValueView& view) : view_(view), columns_((static_cast<size_t>(view.width) + kBlock - 1) / kBlock + kLanes) {}

  float* Row(size_t blockRow, size_t s) {
    const size_t first = static_cast<size_t>(view_.firstRow) / kBlock;
    if (HWY_UNLIKELY(depths_.empty())) {
      const size_t rows = (static_cast<size_t>(view_.endRow) + kBlock - 1) / kBlock - first;
      depths_.assign(rows * view_.samples * columns_, std::numeric_limits<float>::infinity());
    }
    return depths_.data() + ((blockRow - first) * view_.samples + s) * columns_;
  }

 private:
  const ValueView& view_;
  size_t columns_;  // with room for a vector more
  std::vector<float> depths_;
};

/// Some block rows of a triangle, and their blocks that may be seen.
struct SeenBlocks {
  static constexpr size_t kRows = 16, kSize = 512;
  alignas(64) double begin[kRows][kBlock], end[kRows][kBlock];  // covered pixels of each row; none: begin >= end
  size_t size = 0;
  uint64_t codes[kSize + 8];  // block | block row, from the first of them << 16
};

template <class P>
HWY_INLINE void DrawSeen(const ValueView& view, const DepthPlane& plane, const SeenBlocks& seen, size_t s, size_t firstBlockRow, Farthest& farthest,
                         uint32_t number) {
  const D d;
  const DU du;
  const ChunkF f;
  constexpr size_t kAhead = 3;
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
  if (seen.size == 0) return;
  for (size_t n = 0; n < kAhead; ++n) prefetch(n);
  for (size_t n = 0; n < seen.size; ++n) {
    prefetch(n + kAhead);
    const size_t block = seen.codes[n] & 0xFFFF, k = seen.codes[n] >> 16, blockRow = firstBlockRow + k;
    const auto x = static_cast<double>(kBlock * block), y = static_cast<double>(kBlock * blockRow);
    alignas(64) double start[kBlock];
    alignas(64) uint64_t bits[kBlock];
    for (size_t row = 0; row < kBlock; row += kLanes) {
      const V left = hn::Set(d, x), r = hn::Iota(d, y + static_cast<double>(row)) + hn::Set(d, plane.fromY);
      hn::Store(BitsBetween(hn::Load(d, seen.begin[k] + row) - left, hn::Load(d, seen.end[k] + row) - left), du, bits + row);
      hn::Store((hn::Set(d, plane.a0) + hn::Set(d, plane.gy) * r) + hn::Set(d, plane.gx * (plane.fromX + x)), d, start + row);
    }
    const size_t rows = std::min(kBlock, static_cast<size_t>(view.endRow) - kBlock * blockRow);
    size_t element = elementOf(seen.codes[n]);
    auto most = hn::Set(f, -std::numeric_limits<float>::infinity());
    for (size_t row = 0; row < rows; ++row, element += rowElements)
      for (size_t first = 0; first < kBlock; first += kChunkLanes)
        most = hn::Max(WriteChunk<P>(view, element + first, ChunkMask(static_cast<uint32_t>(bits[row]) >> first),
                                     ChunkDepth(start[row], plane.gx, first), number), most);
    farthest.Row(blockRow, s)[block] = hn::GetLane(hn::MaxOfLanes(f, most));
  }
}

/// Draws place `i` of the batch.
template <class P>
HWY_NOINLINE void DrawMedium(const ValueView& view, const ValueBatch& b, size_t i, Farthest& farthest, uint32_t number) {
  const D d;
  const hn::Rebind<float, D> df;
  const DU du;
  const V infinity = hn::Set(d, std::numeric_limits<double>::infinity()), lane = hn::Iota(d, 0);
  const double eighth = 1.0 / kBlock;
  const size_t firstBlockRow = static_cast<size_t>(b.firstRow[i]) / kBlock, endBlockRow = (static_cast<size_t>(b.endRow[i]) + kBlock - 1) / kBlock;
  SeenBlocks seen;
  for (size_t s = 0; s < view.samples; ++s) {
    const DepthPlane plane = PlaneOf<kBlock, kBlock>(view, b, i, s);
    const V nearestVertex = hn::Set(d, b.nearest[i] - plane.margin);
    for (size_t group = firstBlockRow; group < endBlockRow; group += SeenBlocks::kRows) {
      seen.size = 0;
      for (size_t blockRow = group; blockRow < std::min(endBlockRow, group + SeenBlocks::kRows); ++blockRow) {
        const double y = static_cast<double>(kBlock * blockRow);
        V least = infinity, most = hn::Neg(infinity);
        for (size_t row = 0; row < kBlock; row += kLanes) {
          const V r = hn::Iota(d, y + static_cast<double>(row));
          V begin, end;
          RowBounds(b, i, s, r, begin, end);
          const M inside = hn::And(hn::Lt(begin, end), hn::And(hn::Ge(r, hn::Set(d, b.firstRow[i])), hn::Lt(r, hn::Set(d, b.endRow[i]))));
          begin = hn::IfThenElse(inside, begin, infinity), end = hn::IfThenElse(inside, end, hn::Neg(infinity));
          hn::Store(begin, d, seen.begin[blockRow - group] + row);
          hn::Store(end, d, seen.end[blockRow - group] + row);
          least = hn::Min(least, begin), most = hn::Max(most, end);
        }
        const double from = hn::GetLane(hn::MinOfLanes(d, least)), to = hn::GetLane(hn::MaxOfLanes(d, most));
        if (!(from < to)) continue;
        const auto firstBlock = static_cast<size_t>(from * eighth);
        const double blockEnd = to * eighth;  // blocks that begin before
        const float* HWY_RESTRICT far = farthest.Row(blockRow, s);
        const V row = hn::Set(d, plane.a0 + plane.gy * (y + plane.fromY));
        for (size_t block = firstBlock; static_cast<double>(block) < blockEnd; block += kLanes) {
          const V column = lane + hn::Set(d, static_cast<double>(block));
          const V corner = row + hn::Set(d, plane.gx) * (column * hn::Set(d, kBlock) + hn::Set(d, plane.fromX));
          const auto nearest = hn::DemoteTo(df, hn::Max(corner + hn::Set(d, plane.low), nearestVertex));
          const M hidden = hn::Ge(hn::PromoteTo(d, nearest), hn::PromoteTo(d, hn::LoadU(df, far + block)));
          Append(hn::Iota(du, block | (blockRow - group) << 16), hn::AndNot(hidden, hn::Lt(column, hn::Set(d, blockEnd))), seen.codes, seen.size);
          if (HWY_UNLIKELY(seen.size > SeenBlocks::kSize - kLanes)) {
            DrawSeen<P>(view, plane, seen, s, group, farthest, number);
            seen.size = 0;
          }
        }
      }
      DrawSeen<P>(view, plane, seen, s, group, farthest, number);
    }
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace rasterdiff::rasterizer
HWY_AFTER_NAMESPACE();
#endif
