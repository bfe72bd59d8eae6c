// Tiny triangles, a vector of them at a time: rows of all of them at once become chunks, which are then put into the order of the
// triangles. Where there are no permutations of two vectors they are drawn like all small ones.
#if defined(RASTERDIFF_VALUE_TINY_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RASTERDIFF_VALUE_TINY_INL_H
#undef RASTERDIFF_VALUE_TINY_INL_H
#else
#define RASTERDIFF_VALUE_TINY_INL_H
#endif

#include "rasterizer/kernels/value_rows-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rasterdiff::rasterizer {
namespace HWY_NAMESPACE {

#if HWY_TARGET <= HWY_AVX3
inline constexpr size_t kTinySteps = 4;
static_assert(kTinyRows == kTinySteps);

/// Four rows of eight lanes become lanes of four rows, two a vector.
HWY_INLINE void RowsOfLanes(const hn::Vec<DU> rows[kTinySteps], __m512i lanes[kTinySteps]) {
  const __m512i even01 = _mm512_unpacklo_epi64(rows[0].raw, rows[1].raw), odd01 = _mm512_unpackhi_epi64(rows[0].raw, rows[1].raw);
  const __m512i even23 = _mm512_unpacklo_epi64(rows[2].raw, rows[3].raw), odd23 = _mm512_unpackhi_epi64(rows[2].raw, rows[3].raw);
  const __m512i first = _mm512_setr_epi64(0, 1, 8, 9, 2, 3, 10, 11), last = _mm512_setr_epi64(4, 5, 12, 13, 6, 7, 14, 15);
  const __m512i even[2] = {_mm512_permutex2var_epi64(even01, first, even23), _mm512_permutex2var_epi64(even01, last, even23)};
  const __m512i odd[2] = {_mm512_permutex2var_epi64(odd01, first, odd23), _mm512_permutex2var_epi64(odd01, last, odd23)};
  for (size_t k = 0; k < 2; ++k) {
    lanes[2 * k] = _mm512_inserti64x4(even[k], _mm512_castsi512_si256(odd[k]), 1);
    lanes[2 * k + 1] = _mm512_shuffle_i64x2(even[k], odd[k], 0xEE);
  }
}

/// Appends the chunks of the tiny triangles that place `i` is in one vector with.
template <class P>
HWY_INLINE void FindChunksOfTiny(const ValueView& view, const ValueBatch& b, size_t i, Chunks& chunks) {
  const D d;
  const size_t base = i / kLanes * kLanes;
  const uint32_t drawn = b.drawn[i / kLanes];
  const RowLines lines = LinesFrom(b, base);
  const ChunkSource<P> source = ChunkSource<P>::From(view, b, base);
  const V firstRow = hn::Load(d, b.firstRow + base), endRow = hn::Load(d, b.endRow + base);
  for (size_t s = 0; s < view.samples; ++s) {
    if (HWY_UNLIKELY(chunks.size > Chunks::kSize - kTinySteps * kLanes - kLanes)) DrawChunks<P>(view, b, chunks);
    const RowOffsets offsets = OffsetsFrom(b, base, s);
    const V fromAnchor = FromAnchor(view, source, s);
    hn::Vec<DU> code[kTinySteps], depth[kTinySteps], column[kTinySteps];
    uint32_t more = 0;  // a bit a row, lane by lane
    for (size_t step = 0; step < kTinySteps; ++step) {
      const V r = firstRow + hn::Set(d, static_cast<double>(step));
      V begin, end;
      RowBounds(lines, offsets, r, begin, end);
      code[step] = ChunkCodes(source, RowElements(view, source, s, r), begin, end);
      if (P::kDepth) depth[step] = ChunkDepths(source, RowDepths(view, source, s, r), fromAnchor, begin);
      if (P::kCorners) column[step] = hn::BitCast(DU(), fromAnchor + begin);
      more |= _pdep_u32(hn::And(hn::Lt(begin, end), hn::Lt(r, endRow)).raw & drawn, 0x11111111u << step);
    }
    const auto append = [&](const hn::Vec<DU>* rows, uint64_t* to) HWY_ATTR {
      __m512i lane[kTinySteps];
      RowsOfLanes(rows, lane);
      size_t size = chunks.size;
      for (size_t k = 0; k < kTinySteps; ++k) Append(hn::Vec<DU>{lane[k]}, M{static_cast<__mmask8>(more >> 8 * k)}, to, size);
      return size;
    };
    if (P::kDepth) append(depth, reinterpret_cast<uint64_t*>(chunks.depth));
    if (P::kCorners) append(column, reinterpret_cast<uint64_t*>(chunks.column));
    chunks.size = append(code, chunks.codes);
  }
}
#endif

}  // namespace HWY_NAMESPACE
}  // namespace rasterdiff::rasterizer
HWY_AFTER_NAMESPACE();
#endif
