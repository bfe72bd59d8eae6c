// Large triangles: block row by block row, the windows at both ends by their bounds and those in between filled.
#if defined(RASTERDIFF_SPAN_LARGE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RASTERDIFF_SPAN_LARGE_INL_H
#undef RASTERDIFF_SPAN_LARGE_INL_H
#else
#define RASTERDIFF_SPAN_LARGE_INL_H
#endif

#include "rasterizer/kernels/span_ranges-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rasterdiff::rasterizer {
namespace HWY_NAMESPACE {

template <size_t kSide, size_t kSamples>
void DrawLarge(const Batch<kSamples>& b, size_t i, const SpanTarget& target) {
  const D d;
  const DU du;
  const size_t samples = kSamples == 0 ? target.samples : kSamples;
  const auto rowWords = static_cast<size_t>(target.rowWords);
  const size_t windowWords = 2 * static_cast<size_t>(target.blockWords);
  const Lines lines = LinesOf(b, i);
  const Words ones = hn::Set(du, ~uint64_t{0});
  const V next = hn::Set(d, 64);
  alignas(64) int32_t begin[kLanes], fullBegin[kLanes], fullEnd[kLanes], end[kLanes];
  uint64_t* HWY_RESTRICT blockRow = target.words + b.block[i];
  for (int32_t block = 0; block < lines.blocks; ++block, blockRow += rowWords) {
    const size_t k = static_cast<size_t>(block) % kLanes;
    if (k == 0) {
      const Ranges range = FindRanges<kSide, kSamples>(lines, block);
      StoreInt(range.begin, begin);
      StoreInt(range.fullBegin, fullBegin);
      StoreInt(range.fullEnd, fullEnd);
      StoreInt(range.end, end);
    }
    const V firstRow = hn::Set(d, 8.0 * block);
    const int32_t edges = fullBegin[k] - begin[k], fulls = fullEnd[k] - fullBegin[k], rest = end[k] - fullEnd[k];
    for (size_t s = 0; s < samples; ++s)
      for (size_t row = 0; row < 8; row += kLanes) {
        V left, right;
        Bounds<kSide>(b, i, s, hn::Iota(d, static_cast<double>(row)) + firstRow, left, right);
        uint64_t* HWY_RESTRICT p = blockRow + s * 8 + row + static_cast<size_t>(begin[k]) * windowWords;
        const V x = hn::Set(d, 64.0 * begin[k]);
        left = left - x, right = right - x;
        for (int32_t w = 0; w < edges; ++w, p += windowWords) {
          AddBetween(left, right, p);
          left = left - next, right = right - next;
        }
        if (fulls == 0) continue;
        for (int32_t w = 0; w < fulls; ++w, p += windowWords) hn::Store(ones, du, p);
        right = right - hn::Set(d, 64.0 * fulls);
        for (int32_t w = 0; w < rest; ++w, p += windowWords) {
          hn::Store(hn::Or(hn::Load(du, p), hn::AndNot(RightOf(right), ones)), du, p);
          right = right - next;
        }
      }
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace rasterdiff::rasterizer
HWY_AFTER_NAMESPACE();
#endif
