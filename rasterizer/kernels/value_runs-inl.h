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
  uint32_t places[kSize + kRoom];       // of triangles; nobody's: any
  int32_t columns[kSize + kRoom];       // first pixels, from the strip's left on
  size_t wantedSize = 0;
  uint32_t wanted[kSize + kRoom];       // places that the row above has not
  alignas(64) double y[kSize + kRoom];  // of the pixels' centres, 1/256 pixel
};

using NumberTag = hn::CappedTag<uint32_t, 16>;
using Numbers = hn::Vec<NumberTag>;
inline constexpr size_t kNumberLanes = hn::MaxLanes(NumberTag());

/// One bit a lane.
HWY_INLINE uint64_t BitsOf(hn::Mask<NumberTag> mask) {
#if HWY_TARGET <= HWY_AVX3
  return mask.raw;
#elif HWY_TARGET <= HWY_AVX2
  return static_cast<uint32_t>(_mm256_movemask_ps(_mm256_castsi256_ps(mask.raw)));
#else
  uint8_t bytes[8] = {};
  hn::StoreMaskBits(NumberTag(), mask, bytes);
  return bytes[0];
#endif
}

/// Appends runs that start at pixels whose bits are set; there is room for a vector more.
HWY_INLINE void AppendPlaces(const uint32_t* HWY_RESTRICT numbers, uint64_t starts, Strip& strip, size_t& size) {
#if HWY_TARGET <= HWY_AVX3
  const __m512i one = _mm512_set1_epi32(1), iota = _mm512_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
  for (size_t x = 0; x < kStripColumns; x += kNumberLanes) {
    const auto mask = static_cast<__mmask16>(starts >> x);
    const __m512i number = _mm512_maskz_compress_epi32(mask, _mm512_maskz_loadu_epi32(mask, numbers + x));
    _mm512_storeu_si512(strip.places + size, _mm512_sub_epi32(_mm512_max_epu32(number, one), one));
    _mm512_storeu_si512(strip.columns + size, _mm512_maskz_compress_epi32(mask, _mm512_add_epi32(iota, _mm512_set1_epi32(static_cast<int>(x)))));
    size += static_cast<size_t>(__builtin_popcount(mask));
  }
#else
  for (; starts != 0; starts &= starts - 1, ++size) {
    const int x = std::countr_zero(starts);
    strip.places[size] = numbers[x] - (numbers[x] != 0 ? 1 : 0), strip.columns[size] = x;
  }
#endif
}

/// Appends those of the runs, which start where `starts` says, that start where `fresh` says, too.
HWY_INLINE void AppendWanted(const uint32_t* HWY_RESTRICT places, uint64_t starts, uint64_t fresh, Strip& strip) {
#if HWY_TARGET <= HWY_AVX3
  uint64_t which = _pext_u64(fresh, starts);
  for (; which != 0; which >>= kNumberLanes, places += kNumberLanes) {
    const auto mask = static_cast<__mmask16>(which);
    _mm512_storeu_si512(strip.wanted + strip.wantedSize, _mm512_maskz_compress_epi32(mask, _mm512_loadu_si512(places)));
    strip.wantedSize += static_cast<size_t>(__builtin_popcount(mask));
  }
#else
  for (; starts != 0; starts &= starts - 1, ++places)
    if ((fresh & starts & ~(starts - 1)) != 0) strip.wanted[strip.wantedSize++] = *places;
#endif
}

/// Fetches where a triangle's vertices are and the `each` floats that they carry.
HWY_INLINE void PrefetchTriangle(const ValueTriangles& triangles, size_t each, size_t t) {
  constexpr size_t kLine = 16;  // floats
  const SnappedTriangle* HWY_RESTRICT positions = &triangles.positions[t];
  const float* HWY_RESTRICT carried = triangles.carried.data() + each * t;
  __builtin_prefetch(positions);
  __builtin_prefetch(&positions->v[2].y);
  for (size_t k = 0; k < each; k += kLine) __builtin_prefetch(carried + k);
}

/// Bits of the lines of 16 pixels that have any.
HWY_INLINE uint64_t WholeLines(uint64_t bits) {
  bits = (bits | bits >> 8) & 0x00FF00FF00FF00FF;
  bits = (bits | bits >> 4) & 0x000F000F000F000F;
  bits = (bits | bits >> 2) & 0x0003000300030003;
  return ((bits | bits >> 1) & 0x0001000100010001) * 0xFFFF;
}

/// Appends the runs of `pixels` pixels from `numbers` on as row `row`, and those that are to be fetched to `wanted`; `first`: the row of
/// the pixels' first sample, if this is another one; `above`: a row whose triangles were fetched already, if there is one; `apart`: every
/// pixel is a run. Reads a vector more than the pixels.
HWY_INLINE void FindRuns(const uint32_t* HWY_RESTRICT numbers, const uint32_t* HWY_RESTRICT first, const uint32_t* HWY_RESTRICT above, size_t pixels,
                         double y, bool apart, StripRow& row, Strip& strip) {
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
  row.starts = (apart ? ~uint64_t{0} : ends << 1 | 1) & all;
  if (first != nullptr) {
    const uint64_t run = WholeLines(others & all);
    row.starts = (row.starts | (run & ~(run << 16) & 0x0001000100010001)) & run;
    row.same = ~run;
    fresh &= others;
  }
  fresh = (above != nullptr ? fresh : ~uint64_t{0}) & row.starts & row.drawn;
  size_t size = strip.size;
  AppendPlaces(numbers, row.starts, strip, size);
  AppendWanted(strip.places + strip.size, row.starts, fresh, strip);
  const hn::CappedTag<double, 8> d;
  for (size_t k = strip.size; k < size; k += hn::MaxLanes(d)) hn::StoreU(hn::Set(d, y), d, strip.y + k);
  strip.size = size;
}

/// Fetches what a strip wants of triangles.
HWY_INLINE void PrefetchWanted(const ValueTriangles& triangles, const Strip& strip) {
  const size_t each = carriedSize(triangles.kinds.size());
  for (size_t k = 0; k < strip.wantedSize; ++k) PrefetchTriangle(triangles, each, strip.wanted[k]);
}

}  // namespace HWY_NAMESPACE
}  // namespace rasterdiff::rasterizer
HWY_AFTER_NAMESPACE();
#endif
