// Blocks of 8 × 8 pixels that may be seen, as one flat list over many triangles, and the loops over that list that draw them and keep
// the farthest depth of each.
#if defined(RASTERDIFF_VALUE_SEEN_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RASTERDIFF_VALUE_SEEN_INL_H
#undef RASTERDIFF_VALUE_SEEN_INL_H
#else
#define RASTERDIFF_VALUE_SEEN_INL_H
#endif

#include <algorithm>
#include <bit>
#include <limits>
#include <vector>

#include "rasterizer/kernels/value_rows-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rasterdiff::rasterizer {
namespace HWY_NAMESPACE {

inline constexpr size_t kBlock = 8;         // pixels a side
inline constexpr size_t kBlocksOfLong = 8;  // a long block is so many beside one another

/// Farthest depths of the blocks of a view. They are made when the first triangle asks for them.
class Farthest {
 public:
  explicit Farthest(const ValueView& view)
      : firstBlockRow_(static_cast<size_t>(view.firstRow) / kBlock),
        endBlockRow_((static_cast<size_t>(view.endRow) + kBlock - 1) / kBlock),
        samples_(view.samples),
        longColumns_((static_cast<size_t>(view.width) + kBlock * kBlocksOfLong - 1) / (kBlock * kBlocksOfLong) + kBlocksOfLong) {}

  void Create() {
    if (HWY_LIKELY(!depths_.empty())) return;
    const size_t size = Place(endBlockRow_, 0);
    depths_.assign(size * kBlocksOfLong, std::numeric_limits<float>::infinity());
    longDepths_.assign(size, std::numeric_limits<float>::infinity());
  }

  /// Of a block row at sample s; both with a vector more than the blocks.
  HWY_INLINE float* Row(size_t blockRow, size_t s) { return depths_.data() + Place(blockRow, s) * kBlocksOfLong; }
  HWY_INLINE float* LongRow(size_t blockRow, size_t s) { return longDepths_.data() + Place(blockRow, s); }
  [[nodiscard]] size_t FirstBlockRow() const { return firstBlockRow_; }
  /// From a sample to the next one, and from a block row to the next one of the same sample.
  [[nodiscard]] size_t SampleSize() const { return longColumns_ * kBlocksOfLong; }
  [[nodiscard]] size_t RowSize() const { return samples_ * SampleSize(); }

 private:
  [[nodiscard]] HWY_INLINE size_t Place(size_t blockRow, size_t s) const { return ((blockRow - firstBlockRow_) * samples_ + s) * longColumns_; }

  size_t firstBlockRow_, endBlockRow_, samples_, longColumns_;
  std::vector<float> depths_, longDepths_;
};

/// Blocks that may be seen, triangle by triangle.
struct SeenBlocks {
  static constexpr size_t kSize = 256, kRoom = kSize - 16;
  uint64_t codes[kSize];  // block | block row << 11 | sample << 22 | place << 26 | the nearest depth there, a float32, << 32
  size_t size = 0;
};
static_assert(ValueBatch::kSize <= 64 && ValueBatch::kSamples <= 16);

struct BlockPlace {
  size_t block, blockRow, sample, place;
  float nearest;

  HWY_INLINE explicit BlockPlace(uint64_t code)
      : block(code & 0x7FF), blockRow(code >> 11 & 0x7FF), sample(code >> 22 & 15), place(code >> 26 & 63),
        nearest(std::bit_cast<float>(static_cast<uint32_t>(code >> 32))) {}
};

/// Part of the list, ready to be drawn: made first, so that no block waits for the long chain that leads to its masks.
struct BlockWork {
  static constexpr size_t kSize = 32;
  alignas(64) double start[kSize][kBlock];   // depth at the first pixel of each row; through corners: gy (y - y0)
  alignas(64) uint64_t bits[kSize][kBlock];  // covered pixels of each row
  uint64_t codes[kSize];
  size_t elements[kSize];
  float* far[kSize];
  size_t size = 0;
};

/// Makes `work` of `size` codes, and fetches what will be drawn on.
template <class P>
HWY_INLINE void PrepareBlocks(const ValueView& view, const ValueBatch& b, Farthest& farthest, const uint64_t* HWY_RESTRICT codes, size_t size,
                              BlockWork& work) {
  const D d;
  const DU du;
  size_t k = 0;
  for (size_t n = 0; n < size; ++n) {
    const BlockPlace at(codes[n]);
    const size_t i = at.place, s = at.sample;
    const size_t element = (kBlock * at.blockRow * view.samples + s) * view.stride + kBlock * at.block;
    for (size_t row = 0; row < kBlock; ++row) PrefetchPlanes<P>(view, element + row * view.samples * view.stride);
    const auto x = static_cast<double>(kBlock * at.block), y = static_cast<double>(kBlock * at.blockRow);
    const RowLines lines = LinesOf(b, i);
    const RowOffsets offsets = OffsetsOf(b, i, s);
    for (size_t row = 0; row < kBlock; row += kLanes) {
      const V left = hn::Set(d, x), r = hn::Iota(d, static_cast<double>(row)) + hn::Set(d, y);
      V begin, end;
      RowBounds(lines, offsets, r, begin, end);
      const M inside = hn::And(hn::Ge(r, hn::Set(d, b.firstRow[i])), hn::Lt(r, hn::Set(d, b.endRow[i])));
      hn::Store(hn::IfThenElseZero(hn::RebindMask(du, inside), BitsBetween(begin - left, end - left)), du, work.bits[k] + row);
      if (P::kCorners) {
        hn::Store(hn::Set(d, b.gy[i]) * ((r + hn::Set(d, view.y[s] / 256)) - hn::Set(d, b.y0[i])), d, work.start[k] + row);
      } else {
        const V rowDepth = hn::Set(d, b.a0[i]) + hn::Set(d, b.gy[i]) * (r + hn::Set(d, view.y[s] / 256 - b.y0[i]));
        hn::Store(rowDepth + hn::Set(d, b.gx[i] * ((view.x[s] / 256 - b.x0[i]) + x)), d, work.start[k] + row);
      }
    }
    work.codes[k] = codes[n], work.elements[k] = element, work.far[k] = farthest.Row(at.blockRow, s) + at.block;
    // What was drawn since the block came into the list may hide it.
    k += (P::kMeets ? at.nearest > *work.far[k] : at.nearest >= *work.far[k]) ? 0 : 1;
  }
  work.size = k;
}

/// Calls f(element, mask, depth) for the chunks of the first `rows` rows of the n-th block.
template <class P, class F>
HWY_INLINE void ForRows(const ValueView& view, const BlockWork& work, size_t n, ChunkPlane plane, size_t rows, const F& f) {
  size_t element = work.elements[n];
  for (size_t row = 0; row < rows; ++row, element += view.samples * view.stride) {
    plane.chunk = work.start[n][row];
    for (size_t first = 0; first < kBlock; first += kChunkLanes)
      f(element + first, ChunkMask(static_cast<uint32_t>(work.bits[n][row]) >> first), ChunkDepth<P>(plane, first));
  }
}

/// Draws the first `rows` rows of the n-th block; returns the depths of all of them that are farthest now.
template <class P>
HWY_INLINE hn::Vec<ChunkF> DrawRows(const ValueView& view, const BlockWork& work, size_t n, ChunkPlane plane, size_t rows, uint32_t number) {
  using Mask = hn::Mask<ChunkF>;
  using Depths = hn::Vec<ChunkF>;
  Depths most = hn::Set(ChunkF(), -std::numeric_limits<float>::infinity());
  Mask apart = ChunkMask(0xFF);
  ForRows<P>(view, work, n, plane, rows, [&](size_t element, Mask mask, Depths depth) __attribute__((always_inline)) {
    most = hn::Max(WriteChunk<P>(view, element, mask, depth, number, apart), most);
  });
  if (P::kNumbersDecide && HWY_UNLIKELY(!hn::AllTrue(ChunkF(), apart)))
    ForRows<P>(view, work, n, plane, rows, [&](size_t element, Mask mask, Depths depth) { KeepFirst(view, element, mask, depth, number); });
  return most;
}

/// kLong: long blocks are wanted; kListed: as the batch is.
template <class P, bool kLong, bool kListed>
HWY_INLINE void DrawBlocks(const ValueView& view, const ValueBatch& b, Farthest& farthest, const BlockWork& work) {
  const ChunkF f;
  const uint32_t firstNumber = view.before + 1 + (kListed ? 0 : b.triangles[0]);
  const auto endRow = static_cast<size_t>(view.endRow);
  for (size_t n = 0, size = work.size; n < size; ++n) {
    const BlockPlace at(work.codes[n]);
    const size_t i = at.place, rows = endRow - kBlock * at.blockRow;
    const uint32_t number = firstNumber + (kListed ? b.triangles[i] : static_cast<uint32_t>(i));
    ChunkPlane plane{0, b.gx[i], 0, 0, 0};
    if (P::kCorners) plane.a0 = b.a0[i], plane.x0 = b.x0[i], plane.column = view.x[at.sample] / 256 + static_cast<double>(kBlock * at.block);
    const auto here = hn::MaxOfLanes(f, HWY_LIKELY(rows >= kBlock) ? DrawRows<P>(view, work, n, plane, kBlock, number)
                                                                   : DrawRows<P>(view, work, n, plane, rows, number));
    float* HWY_RESTRICT far = work.far[n];
    if (kLong) {
      // The block itself is not loaded: that would wait until it is stored.
      const size_t place = at.block % kBlocksOfLong;
      auto all = here;
      for (size_t first = 0; first < kBlocksOfLong; first += kChunkLanes) {
        const hn::Mask<ChunkF> itself = hn::Eq(hn::Iota(f, static_cast<float>(first)), hn::Set(f, static_cast<float>(place)));
        all = hn::Max(all, hn::IfThenElse(itself, here, hn::LoadU(f, far - place + first)));
      }
      farthest.LongRow(at.blockRow, at.sample)[at.block / kBlocksOfLong] = hn::GetLane(hn::MaxOfLanes(f, all));
    }
    *far = hn::GetLane(here);
  }
}

/// Draws the blocks of the list and empties it.
template <class P, bool kLong>
HWY_NOINLINE void DrawSeen(const ValueView& target, const ValueBatch& b, Farthest& farthest, SeenBlocks& seen) {
  const ValueView view = target;  // which no store can change
  BlockWork work;
  for (size_t n = 0; n < seen.size; n += BlockWork::kSize) {
    PrepareBlocks<P>(view, b, farthest, seen.codes + n, std::min(BlockWork::kSize, seen.size - n), work);
    if (HWY_UNLIKELY(b.listed)) {
      DrawBlocks<P, kLong, true>(view, b, farthest, work);
    } else {
      DrawBlocks<P, kLong, false>(view, b, farthest, work);
    }
  }
  seen.size = 0;
}

}  // namespace HWY_NAMESPACE
}  // namespace rasterdiff::rasterizer
HWY_AFTER_NAMESPACE();
#endif
