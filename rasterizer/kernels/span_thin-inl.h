// Triangles that are nowhere wider than a pixel: most rows cover nothing. A filter in 32-bit fixed point finds the few
// rows that may, and only those are evaluated exactly.
#if defined(RASTERDIFF_SPAN_THIN_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RASTERDIFF_SPAN_THIN_INL_H
#undef RASTERDIFF_SPAN_THIN_INL_H
#else
#define RASTERDIFF_SPAN_THIN_INL_H
#endif

#include <algorithm>
#include <bit>
#include <cmath>

#include "rasterizer/kernels/span_blocks-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rasterdiff::rasterizer {
namespace HWY_NAMESPACE {

using DF = hn::CappedTag<uint32_t, 16>;
inline constexpr size_t kFilterLanes = hn::MaxLanes(DF());

/// A fraction of a pixel as Q0.32, wrapping.
HWY_INLINE uint32_t Fraction(double x) { return static_cast<uint32_t>(static_cast<int64_t>(x * 4294967296.0)); }

/// A number that changes by `step` a row, wrapping.  // Q0.32
struct Stepped {
  uint32_t start = 0, step = 0;
};

/// Appends all rows of [row, end) in which a pixel may be covered, and perhaps some of the following lanes. `gap`: from the
/// bound on line A inwards to the next pixel; `width` of the triangle: the first before row `middle`, then the second.
HWY_INLINE uint32_t* FindRows(Stepped gap, const Stepped* width, int32_t row, int32_t middle, int32_t end,
                              uint32_t* HWY_RESTRICT rows) {
  const DF df;
  const auto lane = hn::Iota(df, 0);
  const auto first = [&](Stepped v) { return hn::Set(df, v.start) + lane * hn::Set(df, v.step); };
  const auto next = [&](Stepped v) { return hn::Set(df, v.step * uint32_t{kFilterLanes}); };
  auto g = first(gap), upper = first(width[0]), lower = first(width[1]), r = lane + hn::Set(df, static_cast<uint32_t>(row));
  const auto nextG = next(gap), nextUpper = next(width[0]), nextLower = next(width[1]);
  const auto turn = hn::Set(df, static_cast<uint32_t>(middle));
  for (; row < end; row += static_cast<int32_t>(kFilterLanes)) {
    const auto may = hn::Lt(g, hn::IfThenElse(hn::Lt(r, turn), upper, lower));
#if HWY_TARGET <= HWY_AVX3
    _mm512_storeu_si512(rows, _mm512_maskz_compress_epi32(may.raw, r.raw));
    rows += __builtin_popcount(may.raw);
#else
    alignas(64) uint32_t bits[kFilterLanes];
    hn::Store(hn::VecFromMask(df, may), df, bits);
    for (size_t k = 0; k < kFilterLanes; ++k) {
      *rows = static_cast<uint32_t>(row) + static_cast<uint32_t>(k);
      rows += bits[k] & 1;
    }
#endif
    g = g + nextG, upper = upper + nextUpper, lower = lower + nextLower, r = r + hn::Set(df, kFilterLanes);
  }
  return rows;
}

/// Pixels to be set: word << 6 | bit.
struct Pixels {
  static constexpr size_t kRoom = 2048;
  size_t size = 0;
  uint64_t codes[kRoom + 16];

  HWY_INLINE void Flush(uint64_t* HWY_RESTRICT words) {
    for (size_t k = 0; k < size; ++k) words[codes[k] >> 6] |= uint64_t{1} << (codes[k] & 63);
    size = 0;
  }
};

/// Rows (of the first block and below) in which a sample may be covered; the end of what is written to `rows`.
template <size_t kSide, size_t kSamples>
HWY_INLINE uint32_t* FindThinRows(const Batch<kSamples>& b, size_t i, size_t s, int32_t top, int32_t middle, int32_t bottom,
                                  uint32_t* HWY_RESTRICT rows) {
  // A step is cut off by less than one unit a row, a start by less than two: below 2^17 units in 2^15 rows for gap and
  // width together. The filter takes 2^17 more on either side.
  constexpr uint32_t kSlack = 1u << 17;
  const double inward = kSide == 0 ? -1 : 1, slope = b.slope[0][i];
  const auto lineA = [&](int32_t row) { return slope * row + b.offset[s][0][i]; };
  const double a = inward * (lineA(top) - 0.5);  // the offset has the half of rounding in it
  // The width is below 255/256 in all rows with a pixel; in the others it may wrap.
  Stepped width[2];
  for (size_t k = 0; k < 2; ++k) {
    const int32_t from = k == 0 ? top : middle, to = k == 0 ? middle : bottom;
    if (from >= to) continue;  // a horizontal edge
    const double here = inward * (lineA(from) - (b.slope[k + 1][i] * from + b.offset[s][k + 1][i]));
    const uint32_t step = Fraction(inward * (slope - b.slope[k + 1][i]));
    width[k] = {Fraction(here) + 2 * kSlack - step * static_cast<uint32_t>(from - top), step};
  }
  return FindRows({Fraction(a - std::floor(a)) + kSlack, Fraction(inward * slope)}, width, top, middle, bottom, rows);
}

/// Rows that FindThinRows may write beyond those of the target.
inline constexpr size_t kThinExtra = 64;

/// Candidates of one sample of one triangle.
struct ThinRows {
  size_t place = 0, sample = 0, size = 0;
  const uint32_t* rows = nullptr;
};

/// Evaluates the candidates exactly and notes the pixels covered: one a row, the first right of the left bound.
template <size_t kSide, size_t kSamples>
HWY_INLINE void EvaluateThinRows(const Batch<kSamples>& b, const ThinRows& thin, const SpanTarget& target, Pixels& pixels) {
  const D d;
  const DU du;
  const int windowShift = std::countr_zero(2 * static_cast<uint64_t>(target.blockWords));
  const V rowWords = hn::Set(d, target.rowWords), size = hn::Set(d, static_cast<double>(thin.size));
  const V magic = hn::Set(d, 6755399441055744.0);  // 1.5 · 2^52: rounds to integers, which stand in the low bits
  const auto low32 = hn::Set(du, 0xFFFFFFFF);
  const auto block = hn::Set(du, static_cast<uint64_t>(b.block[thin.place]) + thin.sample * 8);
  for (size_t k = 0; k < thin.size; k += kLanes) {
    const V row = hn::PromoteTo(d, hn::LoadU(DI(), reinterpret_cast<const int32_t*>(thin.rows + k)));
    V left, right;
    Bounds<kSide>(b, thin.place, thin.sample, row, left, right);
    left = left + magic, right = right + magic;
    const M covered = hn::And(hn::Lt(left, right), hn::Lt(hn::Iota(d, 0) + hn::Set(d, static_cast<double>(k)), size));
    const auto x = hn::And(hn::BitCast(du, left), low32);
    const V blockRow = hn::Floor(row * hn::Set(d, 0.125));
    const V rowWord = hn::MulAdd(blockRow, rowWords, hn::NegMulAdd(blockRow, hn::Set(d, 8), row)) + magic;
    const auto word = hn::And(hn::BitCast(du, rowWord), low32) + hn::ShiftLeftSame(hn::ShiftRight<6>(x), windowShift) + block;
    Append(hn::Or(hn::ShiftLeft<6>(word), hn::And(x, hn::Set(du, 63))), covered, pixels.codes, pixels.size);
    if (HWY_UNLIKELY(pixels.size > Pixels::kRoom)) pixels.Flush(target.words);
  }
}

/// `rows`: scratch for twice the rows of the target and kThinExtra. The candidates of one triangle are evaluated after
/// the next one's were found: what was just stored in pieces is slow to load.
template <size_t kSide, size_t kSamples>
HWY_NOINLINE void DrawThin(const Batch<kSamples>& b, const SnappedTriangle* HWY_RESTRICT triangles, const SpanTarget& target,
                           uint32_t* HWY_RESTRICT rows, Pixels& pixels) {
  const size_t samples = kSamples == 0 ? target.samples : kSamples;
  const size_t half = static_cast<size_t>(target.height) + kThinExtra;
  ThinRows waiting;
  size_t turn = 0;
  for (size_t k = 0; k < b.thin[kSide].size; ++k) {
    const size_t i = b.thin[kSide].places[k];
    const SnappedTriangle& t = triangles[i];
    const int32_t corner = b.firstRow[i] / 8 * 8, top = b.firstRow[i] - corner, bottom = b.endRow[i] - corner;
    const int32_t y0 = t.v[0].y, y1 = t.v[1].y, y2 = t.v[2].y;
    const int32_t middleY = std::max(std::min(y0, y1), std::min(std::max(y0, y1), y2));
    for (size_t s = 0; s < samples; ++s, turn ^= 1) {
      const int32_t middleRow = ((middleY - static_cast<int32_t>(target.y[s]) + 255) >> kSubpixelBits) - corner;
      uint32_t* const mine = rows + turn * half;
      const uint32_t* const end = FindThinRows<kSide>(b, i, s, top, std::clamp(middleRow, top, bottom), bottom, mine);
      EvaluateThinRows<kSide>(b, waiting, target, pixels);
      waiting = {i, s, static_cast<size_t>(end - mine), mine};
    }
  }
  EvaluateThinRows<kSide>(b, waiting, target, pixels);
}

}  // namespace HWY_NAMESPACE
}  // namespace rasterdiff::rasterizer
HWY_AFTER_NAMESPACE();
#endif
