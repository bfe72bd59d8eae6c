// Large triangles: kLanes block rows at a time, the windows that they fill by one bit each and the others through a list
// (span_touched-inl.h), except what is already full. The mask's `settle` turns full bits into words.
#if defined(RASTERDIFF_SPAN_LARGE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RASTERDIFF_SPAN_LARGE_INL_H
#undef RASTERDIFF_SPAN_LARGE_INL_H
#else
#define RASTERDIFF_SPAN_LARGE_INL_H
#endif

#include <bit>

#include "rasterizer/kernels/span_ranges-inl.h"
#include "rasterizer/kernels/span_touched-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rasterdiff::rasterizer {
namespace HWY_NAMESPACE {

/// Which lane's bits have a lowest one, and its number. A power of two in a double has its logarithm for an exponent.
HWY_INLINE Words LowestBit(Words bits) {
  const DU du;
  const Words low = hn::And(bits, hn::Zero(du) - bits);
#if HWY_TARGET <= HWY_AVX3
  return hn::ShiftRight<52>(Words{_mm512_castpd_si512(_mm512_cvtepu64_pd(low.raw))}) - hn::Set(du, 1023);
#else
  alignas(64) uint64_t lanes[kLanes];
  hn::Store(low, du, lanes);
  for (uint64_t& lane : lanes) lane = static_cast<uint64_t>(std::countr_zero(lane));
  return hn::Load(du, lanes);
#endif
}

template <size_t kSide, size_t kSamples>
HWY_NOINLINE void DrawLarge(const Batch<kSamples>& b, const typename Batch<kSamples>::List& list, const SpanTarget& target,
                            Touched& touched) {
  const D d;
  const DU du;
  const auto rowWords = static_cast<size_t>(target.rowWords), windowWords = 2 * static_cast<size_t>(target.blockWords);
  const int windowShift = std::countr_zero(windowWords);
  const V magic = hn::Set(d, 4503599627370496.0);  // 2^52: doubles from here hold an integer in their low bits
  const Words lane = hn::Iota(du, 0), none = hn::Zero(du);
  size_t size = 0;
  for (size_t k = 0; k < list.size; ++k) {
    const size_t i = list.places[k];
    const Lines lines = LinesOf(b, i);
    const size_t firstRow = static_cast<size_t>(b.firstRow[i]) / 8, blocks = static_cast<size_t>(lines.blocks);
    const size_t firstWindow = (static_cast<size_t>(b.block[i]) - firstRow * rowWords) / windowWords;
    const size_t endWindow = firstWindow + static_cast<size_t>(lines.windows);
    for (size_t block = 0; block < blocks; block += kLanes) {
      const Ranges range = FindRanges<kSide, kSamples>(lines, kEights[block] / 8);
      const Words inside = hn::VecFromMask(du, hn::Lt(lane, hn::Set(du, blocks - block)));
      const Words row = lane + hn::Set(du, block);
      const Words rowOffset = hn::And(hn::BitCast(du, hn::MulAdd(hn::Iota(d, 0) + hn::Set(d, kEights[block] / 8),
                                                                  hn::Set(d, target.rowWords), magic)), hn::Set(du, 0xFFFFFFFF));
      const Words rowCode = hn::ShiftLeft<Touched::kRowShift>(row) + hn::Set(du, i);
      // 64 windows at a time, counted from a multiple of 64.
      for (size_t part = firstWindow / 64; part * 64 < endWindow; ++part) {
        const V shift = hn::Set(d, static_cast<double>(firstWindow) - 64.0 * static_cast<double>(part));
        const auto between = [&](V from, V to) { return hn::AndNot(RightOf(to + shift, 0), RightOf(from + shift, 0)); };
        uint64_t* HWY_RESTRICT at = target.full + part * target.fullStride + firstRow + block;
        const Words full = hn::Or(hn::LoadU(du, at), hn::And(inside, between(range.fullBegin, range.fullEnd)));
        hn::StoreU(full, du, at);
        Words rest = hn::AndNot(full, hn::And(inside, between(range.begin, range.end)));
        while (!hn::AllTrue(du, hn::Eq(rest, none))) {
          const Words window = LowestBit(rest) + hn::Set(du, 64 * part - firstWindow);
          const Words words = rowOffset + hn::ShiftLeftSame(window, windowShift);
          const Words code = hn::ShiftLeft<Touched::kWordShift>(words) + hn::ShiftLeft<Touched::kColumnShift + 1>(window) + rowCode;
          Append(code, hn::RebindMask(d, hn::Ne(rest, none)), touched.codes, size);
          if (HWY_UNLIKELY(size > Touched::kRoom)) {
            DrawTouched<kSide>(b, touched, size, target);
            size = 0;
          }
          rest = hn::And(rest, rest - hn::Set(du, 1));
        }
      }
    }
  }
  DrawTouched<kSide>(b, touched, size, target);
}

}  // namespace HWY_NAMESPACE
}  // namespace rasterdiff::rasterizer
HWY_AFTER_NAMESPACE();
#endif
