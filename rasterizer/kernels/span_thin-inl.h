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

/// Appends all rows of [row, end) in which a pixel may be covered, and perhaps some of the following lanes.
/// `gap`: from the bound on line A inwards to the next pixel; `width`: of the triangle. Both Q0.32 at `row`, a row's step.
HWY_INLINE uint32_t* FindRows(uint32_t gap, uint32_t gapStep, uint32_t width, uint32_t widthStep, int32_t row, int32_t end,
                              uint32_t* HWY_RESTRICT rows) {
  const DF df;
  const auto lane = hn::Iota(df, 0);
  auto g = hn::Set(df, gap) + lane * hn::Set(df, gapStep), w = hn::Set(df, width) + lane * hn::Set(df, widthStep);
  auto r = hn::Iota(df, static_cast<uint32_t>(row));
  const auto stepG = hn::Set(df, gapStep * uint32_t{kFilterLanes}), stepW = hn::Set(df, widthStep * uint32_t{kFilterLanes});
  for (; row < end; row += static_cast<int32_t>(kFilterLanes)) {
    const auto may = hn::Lt(g, w);
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
    g = g + stepG, w = w + stepW, r = r + hn::Set(df, kFilterLanes);
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
  for (size_t bent = 1; bent < 3; ++bent) {
    const int32_t from = bent == 1 ? top : middle, to = bent == 1 ? middle : bottom;
    const double a = slope * from + b.offset[s][0][i], e = b.slope[bent][i] * from + b.offset[s][bent][i];
    const double inwardA = inward * (a - 0.5);  // the offset has the half of rounding in it
    if (from >= to) continue;
    // The width is below 255/256 in all rows with a pixel; in the others it may wrap.
    rows = FindRows(Fraction(inwardA - std::floor(inwardA)) + kSlack, Fraction(inward * slope), Fraction(inward * (a - e)) + 2 * kSlack,
                    Fraction(inward * (slope - b.slope[bent][i])), from, to, rows);
  }
  return rows;
}

/// `rows`: scratch for all rows of the target and 64 more.
template <size_t kSide, size_t kSamples>
void DrawThin(const Batch<kSamples>& b, size_t i, const SnappedTriangle& t, const SpanTarget& target,
              uint32_t* HWY_RESTRICT rows, Pixels& pixels) {
  const D d;
  const DU du;
  const size_t samples = kSamples == 0 ? target.samples : kSamples;
  const int32_t corner = b.firstRow[i] / 8 * 8, top = b.firstRow[i] - corner, bottom = b.endRow[i] - corner;
  const int32_t y0 = t.v[0].y, y1 = t.v[1].y, y2 = t.v[2].y;
  const int32_t middleY = std::max(std::min(y0, y1), std::min(std::max(y0, y1), y2));
  const int windowShift = std::countr_zero(2 * static_cast<uint64_t>(target.blockWords));
  const V rowWords = hn::Set(d, target.rowWords);
  const V magic = hn::Set(d, 6755399441055744.0);  // 1.5 · 2^52: rounds to integers, which stand in the low bits
  for (size_t s = 0; s < samples; ++s) {
    const int32_t middle =
        std::clamp(((middleY - static_cast<int32_t>(target.y[s]) + 255) >> kSubpixelBits) - corner, top, bottom);
    const auto found = static_cast<size_t>(FindThinRows<kSide>(b, i, s, top, middle, bottom, rows) - rows);
    const auto block = hn::Set(du, static_cast<uint64_t>(b.block[i]) + s * 8);
    for (size_t k = 0; k < found; k += kLanes) {
      const V row = hn::PromoteTo(d, hn::LoadU(DI(), reinterpret_cast<const int32_t*>(rows + k)));
      V left, right;
      Bounds<kSide>(b, i, s, row, left, right);
      left = left + magic, right = right + magic;
      const V lane = hn::Iota(d, static_cast<double>(k));
      const M covered = hn::And(hn::Lt(left, right), hn::Lt(lane, hn::Set(d, static_cast<double>(found))));
      const auto x = hn::And(hn::BitCast(du, left), hn::Set(du, 0xFFFFFFFF));
      const V blockRow = hn::Floor(row * hn::Set(d, 0.125));
      const V rowWord = hn::MulAdd(blockRow, rowWords, hn::NegMulAdd(blockRow, hn::Set(d, 8), row)) + magic;
      const auto word = hn::And(hn::BitCast(du, rowWord), hn::Set(du, 0xFFFFFFFF)) +
                        hn::ShiftLeftSame(hn::ShiftRight<6>(x), windowShift) + block;
      Append(hn::Or(hn::ShiftLeft<6>(word), hn::And(x, hn::Set(du, 63))), covered, pixels.codes, pixels.size);
      if (HWY_UNLIKELY(pixels.size > Pixels::kRoom)) pixels.Flush(target.words);
    }
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace rasterdiff::rasterizer
HWY_AFTER_NAMESPACE();
#endif
