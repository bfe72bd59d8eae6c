// Folds a mask's full bits and scratch blocks into its words, once for each instruction set; who draws them is left to the
// span kernel.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rasterizer/kernels/mask_settle.cpp"
#define HWY_DISABLED_TARGETS HWY_SSSE3
#include "hwy/foreach_target.h"
// After foreach_target.h:
#include "hwy/highway.h"
#include "rasterizer/kernels/coverage_mask.hpp"

HWY_BEFORE_NAMESPACE();
namespace rasterdiff::rasterizer {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// One block row: `windows` pairs of a block at an even half column and the scratch block at the next odd one, each of
/// `words` words; `full` holds a bit for each window, 64 a word, `stride` words apart.
void SettleRow(uint64_t* HWY_RESTRICT row, size_t windows, size_t words, uint64_t* HWY_RESTRICT full, size_t stride) {
  const hn::CappedTag<uint64_t, 8> d;
  constexpr size_t kLanes = hn::MaxLanes(d);
  for (size_t i = 0; i < words; i += kLanes) {
    auto fromLeft = hn::Zero(d);
    uint64_t* HWY_RESTRICT at = row + i;
    for (size_t w = 0; w < windows; ++w, at += 2 * words) {
      const auto filled = hn::Set(d, uint64_t{0} - (full[w / 64 * stride] >> (w % 64) & 1));
      const auto scratch = hn::Load(d, at + words);
      const auto sum = hn::Or(hn::Or(hn::Load(d, at), filled), hn::Or(hn::ShiftLeft<32>(scratch), fromLeft));
      hn::Store(sum, d, at);
      hn::Store(hn::Zero(d), d, at + words);
      fromLeft = hn::ShiftRight<32>(scratch);
    }
  }
  for (size_t part = 0; part * 64 < windows; ++part) full[part * stride] = 0;
}

}  // namespace HWY_NAMESPACE
}  // namespace rasterdiff::rasterizer
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include <algorithm>

namespace rasterdiff::rasterizer {

HWY_EXPORT(SettleRow);

void CoverageMask::settle(uint32_t firstBlockRow, uint32_t endBlockRow) {
  const size_t blockWords = kBlockHeight * locations_.size();
  const uint32_t inLast = width_ % kBlockWidth;
  const uint64_t keep = inLast == 0 ? ~uint64_t{0} : (uint64_t{1} << inLast) - 1;
  for (uint32_t blockRow = firstBlockRow; blockRow < std::min(endBlockRow, blockRows()); ++blockRow) {
    uint64_t* block = words_ + blockOffset(blockRow, 0, 0);
    HWY_DYNAMIC_DISPATCH(SettleRow)(block, halfColumns_ / 2, blockWords, full_.data() + blockRow, fullStride());
    uint64_t* last = block + (halfColumns_ - 2) * blockWords;
    for (size_t i = 0; i < blockWords; ++i) last[i] &= keep;
    for (uint32_t row = height_ - std::min(height_, blockRow * kBlockHeight); row < kBlockHeight; ++row)
      for (size_t i = row; i < halfColumns_ * blockWords; i += kBlockHeight) block[i] = 0;
  }
}

}  // namespace rasterdiff::rasterizer
#endif
