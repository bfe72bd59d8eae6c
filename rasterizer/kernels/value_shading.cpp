// Deferred varyings, once for each sample that is left, from its own primitive: tile by tile runs (value_runs-inl.h), sums along
// them (value_run_sums-inl.h), values (value_components-inl.h).
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rasterizer/kernels/value_shading.cpp"
#include "hwy/foreach_target.h"
// After foreach_target.h:
#include <algorithm>
#include <bit>
#include <cstdint>

#include "hwy/highway.h"
#include "rasterizer/kernels/value_components-inl.h"
#include "rasterizer/kernels/value_shading.hpp"

HWY_BEFORE_NAMESPACE();
namespace rasterdiff::rasterizer {
namespace HWY_NAMESPACE {

/// Some pixels whose runs are found together.
struct StripBox {
  uint32_t left = 0, right = 0, top = 0, bottom = 0;
  bool below = false;  // in the same tile there are rows above
};

/// Tile by tile, for the sake of caches: a tile's rows have much the same triangles. In a tile strip by strip, to the right first; what the
/// next one wants is fetched before one is shaded.
class Tiles {
 public:
  Tiles(const ValueTriangles& triangles, ValueTarget& target, const DrawnArea& area)
      : triangles_(triangles), area_(area), components_(ComponentsOf(triangles)), numbers_(target.primitive.data()), samples_(target.samples()),
        stride_(target.stride()), rows_(std::max(uint32_t{1}, kLeastRows / samples_)),
        past_(samples_ == 1 && BytesOf(area) * components_.count >= kManyBytes) {
    for (size_t c = 0; c < components_.count; ++c) to_[c] = target.varyings[c].data();
  }

  void Shade() {
    StripBox box = First(area_.left / kStripColumns * kStripColumns, area_.top);
    if (area_.left >= area_.right || area_.top >= area_.bottom) return;
    FindStrip(box, strips_[0]);
    for (uint32_t k = 0;; k ^= 1) {
      const StripBox next = Next(box);
      const bool last = next.top >= area_.bottom;
      if (!last) FindStrip(next, strips_[k ^ 1]);
      if (strips_[k].drawn != 0) ShadeStrip(box, strips_[k]);
      if (last) return;
      box = next;
    }
  }

 private:
  static constexpr size_t kManyBytes = size_t{1} << 21;  // of varyings: more than a cache should be given for what is written only

  static size_t BytesOf(const DrawnArea& area) {
    return area.left < area.right && area.top < area.bottom ? sizeof(float) * (area.right - area.left) * (area.bottom - area.top) : 0;
  }

  // kLeastRows: sample rows of a strip, or one of pixels if that is more.
  static constexpr uint32_t kTileRows = 32, kTileColumns = 512, kLeastRows = 8;

  [[nodiscard]] size_t ElementOf(uint32_t x, uint32_t row) const { return size_t{row} * stride_ + x; }

  [[nodiscard]] StripBox First(uint32_t left, uint32_t top) const {
    return {left, std::min(left + kStripColumns, area_.right), top, std::min(top + rows_, area_.bottom), false};
  }

  /// Behind the last one it begins below the area.
  [[nodiscard]] StripBox Next(const StripBox& box) const {
    const uint32_t start = area_.left / kStripColumns * kStripColumns, tileLeft = box.left - (box.left - start) % kTileColumns;
    const uint32_t tileTop = box.top - (box.top - area_.top) % kTileRows;
    StripBox next = First(box.left + kStripColumns, box.top);
    if (next.left >= std::min(tileLeft + kTileColumns, area_.right)) next = First(tileLeft, box.bottom);
    if (next.top >= std::min(tileTop + kTileRows, area_.bottom)) next = First(tileLeft + kTileColumns, tileTop);
    if (next.left >= area_.right) next = First(start, tileTop + kTileRows);
    next.below = (next.top - area_.top) % kTileRows != 0;
    return next;
  }

  /// Beyond the plane that does nothing.
  template <class T>
  static HWY_INLINE void PrefetchRow(const T* from) {
    constexpr size_t kLine = 16;  // elements
    for (size_t x = 0; x < kStripColumns; x += kLine) __builtin_prefetch(from + x);
  }

  HWY_NOINLINE void FindStrip(const StripBox& box, Strip& strip) {
    strip.size = strip.wantedSize = 0, strip.drawn = 0;
    for (uint32_t row = box.top * samples_, k = 0; row < box.bottom * samples_; ++row, ++k) {
      const uint32_t s = k % samples_, y = box.top + k / samples_;
      const uint32_t* HWY_RESTRICT numbers = numbers_ + ElementOf(box.left, row);
      PrefetchRow(numbers + 2 * kStripColumns);
      FindRuns(numbers, s == 0 ? nullptr : numbers - s * stride_, box.below || k >= samples_ ? numbers - samples_ * stride_ : nullptr,
               box.right - box.left, y * double{kSubpixelOne} + kSubpixelOne / 2, area_.far, strip.rows[k], strip);
      strip.drawn |= strip.rows[k].drawn;
      if (past_ || strip.rows[k].drawn == 0) continue;
      for (size_t c = 0; c < components_.count; ++c) PrefetchRow(to_[c] + ElementOf(box.left, row));
    }
    PrefetchWanted(triangles_, strip);
  }

  void ShadeStrip(const StripBox& box, Strip& strip) {
    SetUpRuns(triangles_, components_, box.left * double{kSubpixelOne} + kSubpixelOne / 2, area_.far, strip, sums_);
    if (components_.allPerspective) {
      past_ ? FindValues<true, true>(box, strip) : FindValues<true, false>(box, strip);
    } else {
      past_ ? FindValues<false, true>(box, strip) : FindValues<false, false>(box, strip);
    }
  }

  template <bool kAllPerspective, bool kPast>
  HWY_NOINLINE void FindValues(const StripBox& box, const Strip& strip) {
    const LineF f;
    constexpr uint64_t kLineBits = (1u << kLinePixels) - 1;
    for (uint32_t row = box.top * samples_, k = 0; row < box.bottom * samples_; ++row, ++k) {
      const StripRow& here = strip.rows[k];
      const size_t first = ElementOf(box.left, row), toFirstSample = k % samples_ * stride_;
      size_t run = here.firstRun;
      for (uint32_t x = 0; x < box.right - box.left; x += kLinePixels) {
        const uint64_t starts = here.starts >> x & kLineBits, drawn = here.drawn >> x & kLineBits;
        const size_t before = run, element = first + x;
        run += static_cast<size_t>(std::popcount(starts));
        if (drawn == 0) continue;
        if ((here.same >> x & kLineBits) != 0) {
          for (size_t c = 0; c < components_.count; ++c) hn::Store(hn::Load(f, to_[c] + element - toFirstSample), f, to_[c] + element);
          continue;
        }
        const Outputs<kPast> out{to_, element, LineMask(drawn)};
        if (starts <= 1) {
          ShadeLine<kAllPerspective>(OneRun(before + starts - 1), strip, sums_, components_, x, out);
        } else if (HWY_LIKELY(run - before < Spread<true>::kNearRuns)) {
          ShadeLine<kAllPerspective>(Spread<true>(starts, before), strip, sums_, components_, x, out);
        } else {
          ShadeLine<kAllPerspective>(Spread<false>(starts, before), strip, sums_, components_, x, out);
        }
      }
    }
  }

  const ValueTriangles& triangles_;
  const DrawnArea area_;
  const Components components_;
  const uint32_t* const numbers_;
  const uint32_t samples_;
  const size_t stride_;
  const uint32_t rows_;
  const bool past_;
  float* to_[kMaxValueComponents] = {};
  Strip strips_[2];
  RunSums sums_;
};

void Shade(const ValueTriangles& triangles, ValueTarget& target, const DrawnArea& area) {
  Tiles(triangles, target, area).Shade();
  hwy::FlushStream();
}

}  // namespace HWY_NAMESPACE
}  // namespace rasterdiff::rasterizer
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rasterdiff::rasterizer {

HWY_EXPORT(Shade);

void shadeArea(const ValueTriangles& triangles, ValueTarget& target, const DrawnArea& area) {
  HWY_DYNAMIC_DISPATCH(Shade)(triangles, target, area);
}

}  // namespace rasterdiff::rasterizer
#endif
