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

/// Adds to one block row of one sample the tall blocks' eight rows from `tall` on and clears those; tall blocks are `tallBytes`
/// apart, four a window of 64 pixels, and reach into the next one. `words` as in SettleRow.
void SettleTall(uint64_t* HWY_RESTRICT row, size_t windows, size_t words, uint32_t* HWY_RESTRICT tall, size_t tallWords) {
  const hn::CappedTag<uint64_t, 8> d;
  const hn::Rebind<uint32_t, decltype(d)> d32;
  constexpr size_t kLanes = hn::MaxLanes(d);
  for (size_t i = 0; i < 8; i += kLanes) {
    auto fromLeft = hn::Zero(d);
    uint32_t* HWY_RESTRICT from = tall + i;
    uint64_t* HWY_RESTRICT at = row + i;
    const auto next = [&] {
      const auto bits = hn::PromoteTo(d, hn::Load(d32, from));
      hn::Store(hn::Zero(d32), d32, from);
      from += tallWords;
      return bits;
    };
    for (size_t w = 0; w < windows; ++w, at += 2 * words) {
      const auto first = next(), second = next(), third = next(), fourth = next();
      const auto sum = hn::Or(hn::Or(first, hn::ShiftLeft<16>(second)), hn::Or(hn::ShiftLeft<32>(third), hn::ShiftLeft<48>(fourth)));
      hn::Store(hn::Or(hn::Or(hn::Load(d, at), fromLeft), sum), d, at);
      fromLeft = hn::ShiftRight<16>(fourth);
    }
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace rasterdiff::rasterizer
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include <algorithm>

namespace rasterdiff::rasterizer {

HWY_EXPORT(SettleRow);
HWY_EXPORT(SettleTall);

void CoverageMask::settle(uint32_t firstBlockRow, uint32_t endBlockRow) {
  const size_t blockWords = kBlockHeight * locations_.size();
  const uint32_t inLast = width_ % kBlockWidth;
  const uint64_t keep = inLast == 0 ? ~uint64_t{0} : (uint64_t{1} << inLast) - 1;
  for (uint32_t blockRow = firstBlockRow; blockRow < std::min(endBlockRow, blockRows()); ++blockRow) {
    uint64_t* block = words() + blockOffset(blockRow, 0, 0);
    HWY_DYNAMIC_DISPATCH(SettleRow)(block, halfColumns_ / 2, blockWords, full_.data() + blockRow, fullStride());
    for (size_t s = 0; s < locations_.size() && !tall_.empty(); ++s) {
      auto* half = reinterpret_cast<uint32_t*>(&tall_[blockRow / 2 * tallStride() * locations_.size() + s]) + blockRow % 2 * 8;
      HWY_DYNAMIC_DISPATCH(SettleTall)(block + s * kBlockHeight, halfColumns_ / 2, blockWords, half, locations_.size() * 16);
    }
    uint64_t* last = block + (halfColumns_ - 2) * blockWords;
    for (size_t i = 0; i < blockWords; ++i) last[i] &= keep;
    for (uint32_t row = height_ - std::min(height_, blockRow * kBlockHeight); row < kBlockHeight; ++row)
      for (size_t i = row; i < halfColumns_ * blockWords; i += kBlockHeight) block[i] = 0;
  }
}

}  // namespace rasterdiff::rasterizer
#endif
