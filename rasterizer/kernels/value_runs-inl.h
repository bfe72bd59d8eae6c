// From a plane of numbers to runs: which triangle is seen in which neighbouring pixels of some rows of a tile, as one flat
// list, so that no loop a row mispredicts its end; for the instruction set being compiled.
#if defined(RASTERDIFF_VALUE_RUNS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RASTERDIFF_VALUE_RUNS_INL_H
#undef RASTERDIFF_VALUE_RUNS_INL_H
#else
#define RASTERDIFF_VALUE_RUNS_INL_H
#endif

#include <bit>
#include <cstring>

#include "hwy/highway.h"
#include "rasterizer/kernels/value_view.hpp"

HWY_BEFORE_NAMESPACE();
namespace rasterdiff::rasterizer {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

inline constexpr uint32_t kStripColumns = 64;  // pixels, of a strip: a bit each
inline constexpr size_t kStripRows = 16;       // sample rows, of a strip, at most

/// A sample row of a strip, by bits of pixels. `same`: lines of 16 pixels that have the first sample's numbers; they
/// are in no run.
struct StripRow {
  uint64_t starts = 0, drawn = 0, same = 0;
  size_t firstRun = 0;  // in the list; the run that pixel 0 is in
};

/// Some sample rows and their runs, left to right, row by row. Undrawn pixels are in runs, too.
struct Strip {
  static constexpr size_t kSize = kStripRows * kStripColumns, kRoom = 16;
  StripRow rows[kStripRows];
  uint64_t drawn = 0;  // in any row
  size_t size = 0;
  uint32_t numbers[kSize + kRoom];
  size_t wantedSize = 0;
  uint32_t wanted[kSize + kRoom];       // numbers that the row above has not
  alignas(64) double y[kSize + kRoom];  // of the pixels' centres, 1/256 pixel
};

using NumberTag = hn::CappedTag<uint32_t, 16>;
using Numbers = hn::Vec<NumberTag>;
inline constexpr size_t kNumberLanes = hn::MaxLanes(NumberTag());
inline constexpr uint64_t kNumberBits = (1u << kNumberLanes) - 1;

/// One bit a lane.
HWY_INLINE uint64_t BitsOf(hn::Mask<NumberTag> mask) {
#if HWY_TARGET <= HWY_AVX3
  return mask.raw;
#else
  uint8_t bytes[8] = {};
  hn::StoreMaskBits(NumberTag(), mask, bytes);
  return bytes[0];
#endif
}

/// From one bit a lane; above those of the lanes there is none.
template <class T>
HWY_INLINE hn::Mask<T> MaskOfBits(T tag, uint64_t bits) {
#if HWY_TARGET <= HWY_AVX3
  (void)tag;
  return hn::Mask<T>{static_cast<decltype(hn::Mask<T>::raw)>(bits)};
#else
  const uint8_t bytes[8] = {static_cast<uint8_t>(bits)};
  return hn::LoadMaskBits(tag, bytes);
#endif
}

/// Fetches what a triangle's vertices carry.
HWY_INLINE void PrefetchTriangle(const ValueTriangles& triangles, size_t each, size_t t) {
  __builtin_prefetch(&triangles.positions[t]);
  __builtin_prefetch(triangles.values.data() + each * t);
  __builtin_prefetch(triangles.values.data() + each * (t + 1) - 1);
  __builtin_prefetch(triangles.reciprocalW.data() + 3 * t);
}

/// Bits of the lines of 16 pixels that have any.
HWY_INLINE uint64_t WholeLines(uint64_t bits) {
  bits = (bits | bits >> 8) & 0x00FF00FF00FF00FF;
  bits = (bits | bits >> 4) & 0x000F000F000F000F;
  bits = (bits | bits >> 2) & 0x0003000300030003;
  return ((bits | bits >> 1) & 0x0001000100010001) * 0xFFFF;
}

/// Appends the runs of `pixels` pixels from `numbers` on as row `row`, and those that are to be fetched to `wanted`; `first`: the row of
/// the pixels' first sample, if this is another one; `above`: a row whose triangles were fetched already, if there is one. Reads a
/// vector more than the pixels.
HWY_INLINE void FindRuns(const uint32_t* HWY_RESTRICT numbers, const uint32_t* HWY_RESTRICT first, const uint32_t* HWY_RESTRICT above, size_t pixels,
                         double y, StripRow& row, Strip& strip) {
  const NumberTag u;
  const uint64_t all = ~uint64_t{0} >> (kStripColumns - pixels);
  row.firstRun = strip.size, row.starts = row.same = 0;
  uint64_t drawn = 0;
  for (size_t x = 0; x < pixels; x += kNumberLanes) drawn |= BitsOf(hn::Ne(hn::LoadU(u, numbers + x), hn::Zero(u))) << x;
  row.drawn = drawn & all;
  if (row.drawn == 0) return;
  uint64_t ends = 0, others = 0, fresh = 0;
  for (size_t x = 0; x < pixels; x += kNumberLanes) {
    const Numbers here = hn::LoadU(u, numbers + x);
    ends |= BitsOf(hn::Ne(here, hn::LoadU(u, numbers + x + 1))) << x;
    if (first != nullptr) others |= BitsOf(hn::Ne(here, hn::LoadU(u, first + x))) << x;
    if (above != nullptr) fresh |= BitsOf(hn::Ne(here, hn::LoadU(u, above + x))) << x;
  }
  row.starts = (ends << 1 | 1) & all;
  if (first != nullptr) {
    const uint64_t run = WholeLines(others & all);
    row.starts = (row.starts | (run & ~(run << 16) & 0x0001000100010001)) & run;
    row.same = ~run;
    fresh &= others;
  }
  fresh = (above != nullptr ? fresh : ~uint64_t{0}) & row.starts & row.drawn;
  size_t size = strip.size, wanted = strip.wantedSize;
  for (size_t x = 0; x < pixels; x += kNumberLanes) {
    const Numbers here = hn::LoadU(u, numbers + x);
    const uint64_t bits = row.starts >> x & kNumberBits, freshBits = fresh >> x & kNumberBits;
    hn::StoreU(hn::Compress(here, MaskOfBits(u, bits)), u, strip.numbers + size);
    hn::StoreU(hn::Compress(here, MaskOfBits(u, freshBits)), u, strip.wanted + wanted);
    size += static_cast<size_t>(std::popcount(bits)), wanted += static_cast<size_t>(std::popcount(freshBits));
  }
  const hn::CappedTag<double, 8> d;
  for (size_t k = strip.size; k < size; k += hn::MaxLanes(d)) hn::StoreU(hn::Set(d, y), d, strip.y + k);
  strip.size = size, strip.wantedSize = wanted;
}

/// Fetches what a strip wants of triangles.
HWY_INLINE void PrefetchWanted(const ValueTriangles& triangles, const Strip& strip) {
  const size_t each = 3 * triangles.kinds.size();
  for (size_t k = 0; k < strip.wantedSize; ++k) PrefetchTriangle(triangles, each, strip.wanted[k] - size_t{1});
}

}  // namespace HWY_NAMESPACE
}  // namespace rasterdiff::rasterizer
HWY_AFTER_NAMESPACE();
#endif
