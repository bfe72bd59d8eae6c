// High triangles, slivers above all, most of whose rows cover no pixel: first the rows that cover one are listed, then vectors of those
// become chunks.
#if defined(RASTERDIFF_VALUE_HIGH_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RASTERDIFF_VALUE_HIGH_INL_H
#undef RASTERDIFF_VALUE_HIGH_INL_H
#else
#define RASTERDIFF_VALUE_HIGH_INL_H
#endif

#include "rasterizer/kernels/value_rows-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rasterdiff::rasterizer {
namespace HWY_NAMESPACE {

/// Rows that cover a pixel: as a double from 2^52 on, whose low bits are first pixel | end << 16 | row << 32.
struct CoveredRows {
  static constexpr size_t kSize = 1024;
  uint64_t codes[kSize + 8];
  size_t size = 0;
};

/// Appends the chunks of rows of place `i` at sample s, and empties the list.
template <class P>
HWY_INLINE void AppendCovered(const ValueView& view, const ValueBatch& b, size_t i, size_t s, CoveredRows& rows, Chunks& chunks) {
  const D d;
  const DU du;
  const V two52 = hn::Set(d, kTwo52);
  const auto exponent = hn::Set(du, uint64_t{0x433} << 52), half = hn::Set(du, 0xFFFF);
  const auto number = [&](hn::Vec<DU> v) { return hn::BitCast(d, hn::Or(hn::And(v, half), exponent)) - two52; };
  const ChunkSource<P> source(view, b, i);
  size_t size = chunks.size;
  for (size_t k = 0; k < rows.size; k += kLanes) {
    const auto code = hn::LoadU(du, rows.codes + k);
    const M more = hn::Lt(hn::Iota(d, 0), hn::Set(d, static_cast<double>(rows.size - k)));
    AppendChunks<P>(view, b, source, s, number(hn::ShiftRight<32>(code)), number(code), number(hn::ShiftRight<16>(code)), more, chunks, size);
  }
  chunks.size = size;
  rows.size = 0;
}

/// Appends the chunks of place `i`.
template <class P>
HWY_NOINLINE void FindChunksOfHigh(const ValueView& view, const ValueBatch& b, size_t i, Chunks& chunks) {
  // At several samples the order of lines counts more, if no depth is waited for: sample rows that lie beside one another.
  if (!P::kDepth && view.samples > 1) return FindChunks<P>(view, b, i, chunks);
  const D d;
  const RowLines lines = LinesOf(b, i);
  const V two52 = hn::Set(d, kTwo52), two16 = hn::Set(d, 65536), endRow = hn::Set(d, b.endRow[i]);
  constexpr auto kRows = static_cast<double>(CoveredRows::kSize);
  CoveredRows rows;
  for (double piece = b.firstRow[i]; piece < b.endRow[i]; piece += kRows) {
    const double end = std::min(piece + kRows, b.endRow[i]);
    for (size_t s = 0; s < view.samples; ++s) {
      const RowOffsets offsets = OffsetsOf(b, i, s);
      size_t size = 0;
      for (double row = piece; row < end; row += static_cast<double>(kLanes)) {
        const V r = NumbersFrom(d, row);
        V from, to;
        RowBounds(lines, offsets, r, from, to);
        const V code = hn::MulAdd(hn::MulAdd(r, two16, to), two16, from) + two52;
        Append(hn::BitCast(DU(), code), hn::And(hn::Lt(from, to), hn::Lt(r, endRow)), rows.codes, size);
      }
      rows.size = size;
      AppendCovered<P>(view, b, i, s, rows, chunks);
    }
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace rasterdiff::rasterizer
HWY_AFTER_NAMESPACE();
#endif
