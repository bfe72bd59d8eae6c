// Triangles of a few windows: first a list of all touched blocks, then one loop without surprises over it. A loop a
// triangle would mispredict its end each time, which costs more than several blocks.
#if defined(RASTERDIFF_SPAN_MEDIUM_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RASTERDIFF_SPAN_MEDIUM_INL_H
#undef RASTERDIFF_SPAN_MEDIUM_INL_H
#else
#define RASTERDIFF_SPAN_MEDIUM_INL_H
#endif

#include "rasterizer/kernels/span_ranges-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rasterdiff::rasterizer {
namespace HWY_NAMESPACE {

/// A touched block: place in the batch | block row << 16 | window << 32.
struct Touched {
  static constexpr size_t kSize = 1024, kRoom = kSize - 16;
  uint64_t codes[kSize];
};

template <size_t kSide, size_t kSamples>
HWY_NOINLINE void DrawTouched(const Batch<kSamples>& b, const Touched& touched, size_t size, const SpanTarget& target) {
  const D d;
  const size_t samples = kSamples == 0 ? target.samples : kSamples;
  const auto rowWords = static_cast<size_t>(target.rowWords);
  const size_t windowWords = 2 * static_cast<size_t>(target.blockWords);
  for (size_t k = 0; k < size; ++k) {
    const uint64_t code = touched.codes[k];
    const size_t i = code & 0xFFFF, blockRow = code >> 16 & 0xFFFF, window = code >> 32;
    uint64_t* HWY_RESTRICT block = target.words + b.block[i] + blockRow * rowWords + window * windowWords;
    const V firstRow = hn::Set(d, kEights[blockRow]), x = hn::Set(d, kEights[8 * window]);
    for (size_t s = 0; s < samples; ++s)
      for (size_t row = 0; row < 8; row += kLanes) {
        V left, right;
        Bounds<kSide>(b, i, s, hn::Iota(d, static_cast<double>(row)) + firstRow, left, right);
        AddBetween(left - x, right - x, block + s * 8 + row);
      }
  }
}

template <size_t kSide, size_t kSamples>
void DrawMedium(const Batch<kSamples>& b, const typename Batch<kSamples>::Long& list, const SpanTarget& target) {
  const D d;
  const DU du;
  Touched touched;
  size_t size = 0;
  const V two52 = hn::Set(d, 4503599627370496.0);  // doubles from here hold an integer in their low bits
  const auto lane16 = hn::ShiftLeft<16>(hn::Iota(du, 0));
  for (size_t k = 0; k < list.size; ++k) {
    const size_t i = list.places[k] & 0xFFFF, block = (list.places[k] >> 16) * kLanes;
    const Lines lines = LinesOf(b, i);
    const Ranges range = FindRanges<kSide, kSamples>(lines, kEights[block] / 8);
    const V inside = hn::Set(d, lines.blocks - static_cast<int32_t>(block));
    const V end = hn::IfThenElseZero(hn::Lt(hn::Iota(d, 0), inside), range.end + two52);
    V window = range.begin + two52;
    auto code = hn::ShiftLeft<32>(hn::BitCast(du, window)) + lane16 + hn::Set(du, block << 16 | i);
    for (size_t w = 0; w < 3 || HWY_UNLIKELY(!hn::AllFalse(d, hn::Lt(window, end))); ++w) {
      Append(code, hn::Lt(window, end), touched.codes, size);
      window = window + hn::Set(d, 1);
      code = code + hn::Set(du, uint64_t{1} << 32);
      if (HWY_UNLIKELY(size > Touched::kRoom)) {
        DrawTouched<kSide>(b, touched, size, target);
        size = 0;
      }
    }
  }
  DrawTouched<kSide>(b, touched, size, target);
}

}  // namespace HWY_NAMESPACE
}  // namespace rasterdiff::rasterizer
HWY_AFTER_NAMESPACE();
#endif
