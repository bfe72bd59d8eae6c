// From lines to bits: blocks of 64 pixels by eight rows, for the instruction set being compiled. The lines and their proof
// are in span_setup-inl.h; which blocks a triangle touches is found there for small ones, in span_ranges-inl.h for others.
#if defined(RASTERDIFF_SPAN_BLOCKS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RASTERDIFF_SPAN_BLOCKS_INL_H
#undef RASTERDIFF_SPAN_BLOCKS_INL_H
#else
#define RASTERDIFF_SPAN_BLOCKS_INL_H
#endif

#include "rasterizer/kernels/span_setup-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rasterdiff::rasterizer {
namespace HWY_NAMESPACE {

using Words = hn::Vec<DU>;

/// All pixels of a window of 64, which begins at pixel `x` of the triangle's first block, at or right of a line; `t` is the
/// line's place as in span_setup-inl.h.
HWY_INLINE Words RightOf(V t, uint64_t x) {
  const D d;
  const DU du;
#if HWY_TARGET <= HWY_AVX3
  (void)d, (void)du;
  // Rounds to nearest. Counts of 64 and more shift everything out.
  const __m512i place = _mm512_sub_epi64(_mm512_cvtpd_epi64(t.raw), _mm512_set1_epi64(static_cast<int64_t>(x)));
  return Words{_mm512_sllv_epi64(_mm512_set1_epi64(-1), _mm512_max_epi64(place, _mm512_setzero_si512()))};
#else
  const V clamped = hn::Min(hn::Max(t - hn::Set(d, static_cast<double>(x)), hn::Zero(d)), hn::Set(d, 64.0));
  const Words n = hn::And(hn::BitCast(du, clamped + hn::Set(d, 4503599627370496.0)), hn::Set(du, 127));  // + 2^52 rounds
#if HWY_TARGET == HWY_SCALAR
  return hn::IfThenElseZero(hn::Lt(n, hn::Set(du, 64)), hn::Shl(hn::Set(du, ~uint64_t{0}), hn::And(n, hn::Set(du, 63))));
#else
  return hn::Shl(hn::Set(du, ~uint64_t{0}), n);  // counts of 64 shift everything out
#endif
#endif
}

/// The words `to` of the window at `x` with the pixels from line `left` to line `right` added.
HWY_INLINE void AddBetween(V left, V right, uint64_t x, uint64_t* HWY_RESTRICT to) {
  const DU du;
  const Words l = RightOf(left, x), r = RightOf(right, x);
#if HWY_TARGET <= HWY_AVX3
  _mm512_store_si512(to, _mm512_ternarylogic_epi64(l.raw, r.raw, hn::Load(du, to).raw, 0xBA));  // (l & ~r) | old
#else
  hn::Store(hn::Or(hn::Load(du, to), hn::AndNot(r, l)), du, to);
#endif
}

/// Left and right bounds of rows `r` for place `i` and sample `s`.
template <size_t kSide, class B>
HWY_INLINE void Bounds(const B& b, size_t i, size_t s, V r, V& left, V& right) {
  const D d;
  const V a = hn::MulAdd(hn::Set(d, b.slope[0][i]), r, hn::Set(d, b.offset[s][0][i]));
  const V p = hn::MulAdd(hn::Set(d, b.slope[1][i]), r, hn::Set(d, b.offset[s][1][i]));
  const V q = hn::MulAdd(hn::Set(d, b.slope[2][i]), r, hn::Set(d, b.offset[s][2][i]));
  left = kSide == 0 ? a : hn::Max(p, q);
  right = kSide == 0 ? hn::Min(p, q) : a;
}

/// The blocks of small triangles in their kBlockRow-th block row.
template <size_t kSide, size_t kBlockRow, size_t kSamples>
HWY_INLINE void DrawSmall(const Batch<kSamples>& b, const SpanTarget& target) {
  const auto& list = b.small[kBlockRow][kSide];
  const size_t samples = kSamples == 0 ? target.samples : kSamples;
  uint64_t* const words = target.words + kBlockRow * static_cast<size_t>(target.rowWords);
  for (size_t k = 0; k < list.size; ++k) {
    const size_t i = list.places[k];
    uint64_t* HWY_RESTRICT block = words + b.block[i];
    for (size_t s = 0; s < samples; ++s)
      for (size_t row = 0; row < 8; row += kLanes) {
        V left, right;
        Bounds<kSide>(b, i, s, hn::Iota(D(), static_cast<double>(8 * kBlockRow + row)), left, right);
        AddBetween(left, right, 0, block + s * 8 + row);
      }
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace rasterdiff::rasterizer
HWY_AFTER_NAMESPACE();
#endif
