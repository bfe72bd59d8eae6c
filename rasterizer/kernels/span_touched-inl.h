// Lists of blocks that triangles touch, and one loop without surprises over such a list. A loop a triangle would mispredict
// its end each time, which costs more than several blocks. Who touches what is found in span_medium-inl.h, span_large-inl.h.
#if defined(RASTERDIFF_SPAN_TOUCHED_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RASTERDIFF_SPAN_TOUCHED_INL_H
#undef RASTERDIFF_SPAN_TOUCHED_INL_H
#else
#define RASTERDIFF_SPAN_TOUCHED_INL_H
#endif

#include "rasterizer/kernels/span_blocks-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rasterdiff::rasterizer {
namespace HWY_NAMESPACE {

/// A touched block: place in the batch | block row << 8 | half column << 20 | first word << 32, all but the place counted
/// from the first block. Bounds: 2^8 places, 2^12 block rows, 2^10 half columns, 2^30 words (32,768² px, 16 samples, scratch).
struct Touched {
  static constexpr size_t kSize = 1024, kRoom = kSize - 16;
  static constexpr int kRowShift = 8, kColumnShift = 20, kWordShift = 32;  // word and column are adjacent
  uint64_t codes[kSize];
};

template <size_t kSide, size_t kSamples>
HWY_NOINLINE void DrawTouched(const Batch<kSamples>& b, const Touched& touched, size_t size, const SpanTarget& target) {
  const D d;
  const size_t samples = kSamples == 0 ? target.samples : kSamples;
  for (size_t k = 0; k < size; ++k) {
    const uint64_t code = touched.codes[k];
    const size_t i = code & 0xFF, blockRow = code >> Touched::kRowShift & 0xFFF;
    const uint64_t x = code >> (Touched::kColumnShift - 5) & 0xFFF << 5;
    uint64_t* HWY_RESTRICT block = target.words + b.block[i] + (code >> Touched::kWordShift);
    const V firstRow = hn::Set(d, kEights[blockRow]);
    for (size_t s = 0; s < samples; ++s)
      for (size_t row = 0; row < 8; row += kLanes) {
        V left, right;
        Bounds<kSide>(b, i, s, hn::Iota(d, static_cast<double>(row)) + firstRow, left, right);
        AddBetween(left, right, x, block + s * 8 + row);
      }
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace rasterdiff::rasterizer
HWY_AFTER_NAMESPACE();
#endif
