// Folds a mask's full bits and scratch blocks into its words, once for each instruction set; who draws them is left to the
// span kernel.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rasterizer/kernels/mask_settle.cpp"
#include "hwy/foreach_target.h"
// After foreach_target.h:
#include "hwy/highway.h"
#include "rasterizer/kernels/coverage_mask.hpp"

HWY_BEFORE_NAMESPACE();
namespace rasterdiff::rasterizer {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Windows [first, end) of one block row. Each has two blocks, one at an even half column and the scratch block at the next
/// odd one, of `words` words; `full` holds a bit for each window, 64 a word, `stride` words apart. What the last scratch block
/// has for the window behind `end` goes there, if the row, `windows` long, has one.
void SettleRow(uint64_t* HWY_RESTRICT row, size_t first, size_t end, size_t windows, size_t words, uint64_t* HWY_RESTRICT full,
               size_t stride) {
  const hn::CappedTag<uint64_t, 8> d;
  constexpr size_t kLanes = hn::MaxLanes(d);
  for (size_t i = 0; i < words; i += kLanes) {
    auto fromLeft = hn::Zero(d);
    uint64_t* HWY_RESTRICT at = row + first * 2 * words + i;
    for (size_t w = first; w < end; ++w, at += 2 * words) {
      const auto filled = hn::Set(d, uint64_t{0} - (full[w / 64 * stride] >> (w % 64) & 1));
      const auto scratch = hn::Load(d, at + words);
      const auto sum = hn::Or(hn::Or(hn::Load(d, at), filled), hn::Or(hn::ShiftLeft<32>(scratch), fromLeft));
      hn::Store(sum, d, at);
      hn::Store(hn::Zero(d), d, at + words);
      fromLeft = hn::ShiftRight<32>(scratch);
    }
    if (end < windows) hn::Store(hn::Or(hn::Load(d, at), fromLeft), d, at);
  }
  for (size_t w = first; w < end; ++w) full[w / 64 * stride] &= ~(uint64_t{1} << (w % 64));
}

/// Adds to the windows of one sample the tall blocks' eight rows from `tall` on and clears those; tall blocks are `tallWords`
/// apart, four a window of 64 pixels, and reach into the next one. The rest as in SettleRow.
void SettleTall(uint64_t* HWY_RESTRICT row, size_t first, size_t end, size_t windows, size_t words, uint32_t* HWY_RESTRICT tall,
                size_t tallWords) {
  const hn::CappedTag<uint64_t, 8> d;
  const hn::Rebind<uint32_t, decltype(d)> d32;
  constexpr size_t kLanes = hn::MaxLanes(d);
  for (size_t i = 0; i < 8; i += kLanes) {
    auto fromLeft = hn::Zero(d);
    uint32_t* HWY_RESTRICT from = tall + first * 4 * tallWords + i;
    uint64_t* HWY_RESTRICT at = row + first * 2 * words + i;
    const auto next = [&] {
      const auto bits = hn::PromoteTo(d, hn::Load(d32, from));
      hn::Store(hn::Zero(d32), d32, from);
      from += tallWords;
      return bits;
    };
    for (size_t w = first; w < end; ++w, at += 2 * words) {
      const auto block0 = next(), block1 = next(), block2 = next(), block3 = next();
      const auto sum = hn::Or(hn::Or(block0, hn::ShiftLeft<16>(block1)), hn::Or(hn::ShiftLeft<32>(block2), hn::ShiftLeft<48>(block3)));
      hn::Store(hn::Or(hn::Or(hn::Load(d, at), fromLeft), sum), d, at);
      fromLeft = hn::ShiftRight<16>(block3);
    }
    if (end < windows) hn::Store(hn::Or(hn::Load(d, at), fromLeft), d, at);
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

namespace {

using Windows = CoverageMask::Windows;

/// The windows of a triangle's box, and the one to the left, whose scratch block reaches into it.
Windows windowsOf(const SnappedTriangle& triangle, const CoverageMask& mask) {
  const auto& v = triangle.v;
  const auto [left, right] = std::minmax({v[0].x, v[1].x, v[2].x});
  const auto [top, bottom] = std::minmax({v[0].y, v[1].y, v[2].y});
  const auto inside = [](int32_t subpixels, uint32_t step, uint32_t count, int32_t more) {
    const int32_t place = (subpixels >> kSubpixelBits) / static_cast<int32_t>(step) + more;
    return static_cast<uint32_t>(std::clamp(place, 0, static_cast<int32_t>(count)));
  };
  const uint32_t windows = mask.halfColumns() / 2;
  return {inside(top, CoverageMask::kBlockHeight, mask.blockRows(), 0), inside(bottom, CoverageMask::kBlockHeight, mask.blockRows(), 1),
          inside(left, CoverageMask::kBlockWidth, windows, -1), inside(right, CoverageMask::kBlockWidth, windows, 1)};
}

}  // namespace

void CoverageMask::settle(std::span<const SnappedTriangle> triangles) {
  constexpr size_t kRowCost = 8;  // of a few windows in a row, as if that were so many windows more
  const size_t all = size_t{blockRows()} * halfColumns_ / 2;
  size_t cost = triangles.size() * kRowCost;
  for (size_t i = 0; i < triangles.size() && cost < all; ++i) {
    const Windows windows = windowsOf(triangles[i], *this);
    cost += size_t{windows.endRow - windows.firstRow} * (windows.end - windows.first + kRowCost);
  }
  if (cost >= all) return settle({0, blockRows(), 0, halfColumns_ / 2});
  for (const SnappedTriangle& triangle : triangles) settle(windowsOf(triangle, *this));
}

void CoverageMask::settle(const Windows& windows) {
  const size_t blockWords = kBlockHeight * locations_.size(), rowWindows = halfColumns_ / 2;
  const uint32_t inLast = width_ % kBlockWidth;
  const uint64_t keep = inLast == 0 ? ~uint64_t{0} : (uint64_t{1} << inLast) - 1;
  for (uint32_t blockRow = windows.firstRow; blockRow < windows.endRow; ++blockRow) {
    uint64_t* block = words() + blockOffset(blockRow, 0, 0);
    HWY_DYNAMIC_DISPATCH(SettleRow)(block, windows.first, windows.end, rowWindows, blockWords, full_.data() + blockRow, fullStride());
    for (size_t s = 0; s < locations_.size() && !tall_.empty(); ++s) {
      auto* half = reinterpret_cast<uint32_t*>(&tall_[blockRow / 2 * tallStride() * locations_.size() + s]) + blockRow % 2 * 8;
      HWY_DYNAMIC_DISPATCH(SettleTall)(block + s * kBlockHeight, windows.first, windows.end, rowWindows, blockWords, half,
                                       locations_.size() * 16);
    }
    uint64_t* last = block + (halfColumns_ - 2) * blockWords;
    for (size_t i = 0; i < blockWords; ++i) last[i] &= keep;
    for (uint32_t row = height_ - std::min(height_, blockRow * kBlockHeight); row < kBlockHeight; ++row)
      for (size_t i = row; i < halfColumns_ * blockWords; i += kBlockHeight) block[i] = 0;
  }
}

}  // namespace rasterdiff::rasterizer
#endif
