// Which windows of 64 pixels a triangle touches and fills, for several block rows at a time, from its lines at the first
// and last row of each.
#if defined(RASTERDIFF_SPAN_RANGES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RASTERDIFF_SPAN_RANGES_INL_H
#undef RASTERDIFF_SPAN_RANGES_INL_H
#else
#define RASTERDIFF_SPAN_RANGES_INL_H
#endif

#include "rasterizer/kernels/span_blocks-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rasterdiff::rasterizer {
namespace HWY_NAMESPACE {

/// Windows of kLanes block rows: touched are [begin, end), filled for every sample [fullBegin, fullEnd) in between
/// (both `end` where there is none). Conservative by a pixel or two, except that full windows are full.
struct Ranges {
  V begin, fullBegin, fullEnd, end;
};

/// What FindRanges needs of a triangle; rows [top, bottom) and windows count from the first block.
struct Lines {
  V slope[3], offset[3], margin[3], fullMargin[3];
  int32_t top, bottom, blocks, windows;
};

template <size_t kSamples>
HWY_INLINE Lines LinesOf(const Batch<kSamples>& b, size_t i) {
  const D d;
  Lines lines;
  const V one = hn::Set(d, 1);
  for (size_t k = 0; k < 3; ++k) {
    lines.slope[k] = hn::Set(d, b.slope[k][i]);
    lines.offset[k] = hn::Set(d, b.offset[0][k][i]);
    lines.margin[k] = lines.fullMargin[k] = hn::Zero(d);
    if (kSamples != 1) {
      // Another sample's line is less than a pixel and a row away; a horizontal edge is left to the rows.
      const V steepness = hn::Abs(lines.slope[k]);
      lines.margin[k] = steepness + one;
      lines.fullMargin[k] = hn::IfThenElse(hn::Ge(steepness, hn::Set(d, kSteep)), hn::Zero(d), lines.margin[k]);
    }
  }
  const int32_t corner = b.firstRow[i] / 8 * 8;
  lines.top = b.firstRow[i] - corner, lines.bottom = b.endRow[i] - corner;
  lines.blocks = (lines.bottom + 7) / 8;
  lines.windows = (static_cast<int32_t>(b.columns[i]) + 63) / 64;
  return lines;
}

/// Ranges of the kLanes block rows from `firstBlock`.
template <size_t kSide, size_t kSamples>
HWY_INLINE Ranges FindRanges(const Lines& lines, double firstBlock) {
  const D d;
  const V row0 = NumbersFrom(d, firstBlock) * hn::Set(d, 8), row7 = row0 + hn::Set(d, 7);
  const V first = hn::Set(d, lines.top), last = hn::Set(d, lines.bottom - 1);
  const V r0 = hn::Min(hn::Max(row0, first), last), r1 = hn::Min(row7, last);
  V low[3], high[3], fullLow[3], fullHigh[3];
  for (size_t i = 0; i < 3; ++i) {
    const V a = hn::MulAdd(lines.slope[i], r0, lines.offset[i]), z = hn::MulAdd(lines.slope[i], r1, lines.offset[i]);
    low[i] = fullLow[i] = hn::Min(a, z), high[i] = fullHigh[i] = hn::Max(a, z);
    if (kSamples == 1) continue;  // no margin but that of rounding, below
    low[i] = low[i] - lines.margin[i], high[i] = high[i] + lines.margin[i];
    fullLow[i] = fullLow[i] - lines.fullMargin[i], fullHigh[i] = fullHigh[i] + lines.fullMargin[i];
  }
  const V window = hn::Set(d, 1.0 / 64), count = hn::Set(d, lines.windows);
  const V leftLow = kSide == 0 ? low[0] : hn::Max(low[1], low[2]);
  const V rightHigh = kSide == 0 ? hn::Min(high[1], high[2]) : high[0];
  const V leftHigh = kSide == 0 ? fullHigh[0] : hn::Max(fullHigh[1], fullHigh[2]);
  const V rightLow = kSide == 0 ? hn::Min(fullLow[1], fullLow[2]) : fullLow[0];
  const auto clamp = [&](V v) { return hn::Min(hn::Max(v, hn::Zero(d)), count); };
  const V more = window, less = hn::Neg(window);  // a pixel
  Ranges r;
  r.begin = clamp(hn::Floor(hn::MulAdd(leftLow, window, less)));
  r.end = hn::Max(clamp(hn::Ceil(hn::MulAdd(rightHigh, window, more))), r.begin);
  r.fullBegin = clamp(hn::Ceil(hn::MulAdd(leftHigh, window, more)));
  r.fullEnd = clamp(hn::Floor(hn::MulAdd(rightLow, window, less)));
  // A block is full only where all its rows belong to the triangle, for each sample.
  const V inset = hn::Set(d, kSamples == 1 ? 0.0 : 1.0);
  const M full = hn::And(hn::And(hn::Ge(row0, first + inset), hn::Le(row7, last - inset)), hn::Lt(r.fullBegin, r.fullEnd));
  r.fullBegin = hn::IfThenElse(full, r.fullBegin, r.end);
  r.fullEnd = hn::IfThenElse(full, r.fullEnd, r.end);
  return r;
}

}  // namespace HWY_NAMESPACE
}  // namespace rasterdiff::rasterizer
HWY_AFTER_NAMESPACE();
#endif
