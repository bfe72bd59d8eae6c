// Triangles of a few windows: kLanes block rows at a time. Each block row begins at the half column where the triangle does,
// so that most need one block only; that one has a loop of its own, others go through a list (span_touched-inl.h).
#if defined(RASTERDIFF_SPAN_MEDIUM_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RASTERDIFF_SPAN_MEDIUM_INL_H
#undef RASTERDIFF_SPAN_MEDIUM_INL_H
#else
#define RASTERDIFF_SPAN_MEDIUM_INL_H
#endif

#include "rasterizer/kernels/span_touched-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rasterdiff::rasterizer {
namespace HWY_NAMESPACE {

/// The first blocks of kLanes block rows of some triangles. Found first and drawn then, for the way from one to the other
/// is long and a processor looks ahead no more than two of them.
struct FirstBlocks {
  static constexpr size_t kSize = 16;
  size_t size = 0;
  size_t place[kSize];
  alignas(64) uint64_t* block[kSize][kLanes];
  alignas(64) double start[kSize][3][kLanes];  ///< of the lines in the first row, pixels from the block's left
  alignas(64) uint64_t nobody[kLanes * 8];
};

/// Always draws kLanes blocks: a loop that ended with the triangle would mispredict its end each time. Those below the
/// triangle are blocks of nobody, one for each lane: a single one would be a chain of stores and loads.
template <size_t kSide>
HWY_NOINLINE void DrawFirstBlocks(const Batch<1>& b, FirstBlocks& first) {
  const D d;
  for (size_t k = 0; k < first.size; ++k) {
    V slope[3];
    for (size_t line = 0; line < 3; ++line) slope[line] = hn::Set(d, b.slope[line][first.place[k]]);
    for (size_t lane = 0; lane < kLanes; ++lane)
      for (size_t row = 0; row < 8; row += kLanes) {
        V t[3];
        for (size_t line = 0; line < 3; ++line)
          t[line] = hn::MulAdd(slope[line], hn::Iota(d, static_cast<double>(row)), hn::Set(d, first.start[k][line][lane]));
        AddBetween(kSide == 0 ? t[0] : hn::Max(t[1], t[2]), kSide == 0 ? hn::Min(t[1], t[2]) : t[0], 0,
                   first.block[k][lane] + row);
      }
  }
  first.size = 0;
}

template <size_t kSide, size_t kSamples>
HWY_NOINLINE void DrawMedium(const Batch<kSamples>& b, const typename Batch<kSamples>::Long& list, const SpanTarget& target,
                             Touched& touched, FirstBlocks& first) {
  const D d;
  const DU du;
  const V zero = hn::Zero(d), one = hn::Set(d, 1), seven = hn::Set(d, 7), k32 = hn::Set(d, 32), k64 = hn::Set(d, 64);
  const V magic = hn::Set(d, 4503599627370496.0);  // 2^52: doubles from here hold an integer in their low bits
  // A block's word << 12 | its half column, as doubles: below 2^42.
  const V rowCode = hn::Set(d, target.rowWords * (4096.0 / 8)), columnCode = hn::Set(d, target.blockWords * 4096 + 1);
  const auto nextWindow = hn::Set(du, static_cast<uint64_t>(2 * target.blockWords) << Touched::kWordShift |
                                          uint64_t{2} << Touched::kColumnShift);
  const auto nobody = hn::Set(du, reinterpret_cast<uintptr_t>(first.nobody)) + hn::ShiftLeft<6>(hn::Iota(du, 0));
  size_t size = 0;
  for (size_t k = 0; k < list.size; ++k) {
    const size_t i = list.places[k] & 0xFFFF, firstBlock = (list.places[k] >> 16) * kLanes;
    const V row = hn::Iota(d, 0) * hn::Set(d, 8) + hn::Set(d, kEights[firstBlock]);
    V start[3], low[3], high[3];
    for (size_t line = 0; line < 3; ++line) {
      const V slope = hn::Set(d, b.slope[line][i]);
      start[line] = hn::MulAdd(slope, row, hn::Set(d, b.offset[0][line][i]));
      const V stop = hn::MulAdd(slope, seven, start[line]);
      low[line] = hn::Min(start[line], stop), high[line] = hn::Max(start[line], stop);
      if (kSamples == 1) continue;
      const V margin = hn::Abs(slope) + one;  // another sample's line is less than a pixel and a row away
      low[line] = low[line] - margin, high[line] = high[line] + margin;
    }
    const V left = kSide == 0 ? low[0] : hn::Max(low[1], low[2]), right = kSide == 0 ? hn::Min(high[1], high[2]) : high[0];
    // A pixel more on each side for rounding.
    const V column = hn::Max(hn::Floor((left - one) * hn::Set(d, 1.0 / 32)), zero), x = column * k32;
    const V end = hn::Min(right + one, hn::Set(d, b.columns[i]));
    const auto block = hn::BitCast(du, hn::MulAdd(row, rowCode, hn::MulAdd(column, columnCode, magic)));
    const M inside = hn::And(hn::Lt(row, hn::Set(d, b.rows[i])), hn::Lt(x, end));  // not below or right of the box
    auto code = hn::ShiftLeft<Touched::kColumnShift>(block) + hn::ShiftLeft<Touched::kRowShift>(hn::Iota(du, 0)) +
                hn::Set(du, firstBlock << Touched::kRowShift | i);
    V from = x;
    if constexpr (kSamples == 1) {
      const size_t n = first.size++;
      first.place[n] = i;
      const auto at = hn::Set(du, reinterpret_cast<uintptr_t>(target.words + b.block[i])) +
                      hn::ShiftRight<9>(hn::And(block, hn::Set(du, 0xFFFFFFFFull << 12)));
      hn::Store(hn::IfThenElse(hn::RebindMask(du, inside), at, nobody), du, reinterpret_cast<uint64_t*>(first.block[n]));
      for (size_t line = 0; line < 3; ++line) hn::Store(start[line] - x, d, first.start[n][line]);
      if (first.size == FirstBlocks::kSize) DrawFirstBlocks<kSide>(b, first);
      from = from + k64;
      code = code + nextWindow;
    }
    size_t window = kSamples == 1 ? 1 : 0;
    do {
      Append(code, hn::And(inside, hn::Lt(from, end)), touched.codes, size);
      from = from + k64;
      code = code + nextWindow;
      if (HWY_UNLIKELY(size > Touched::kRoom)) {
        DrawTouched<kSide>(b, touched, size, target);
        size = 0;
      }
    } while (++window < 2 || HWY_UNLIKELY(!hn::AllFalse(d, hn::And(inside, hn::Lt(from, end)))));
  }
  if constexpr (kSamples == 1) DrawFirstBlocks<kSide>(b, first);
  DrawTouched<kSide>(b, touched, size, target);
}

}  // namespace HWY_NAMESPACE
}  // namespace rasterdiff::rasterizer
HWY_AFTER_NAMESPACE();
#endif
