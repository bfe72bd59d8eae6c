// Runs are short, so they are written as whole vectors, from left to right: what is too much the next run overwrites.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rasterizer/kernels/settle_row.cpp"
#include "hwy/foreach_target.h"
// After foreach_target.h:
#include <bit>

#include "hwy/highway.h"
#include "rasterizer/kernels/linear_over-inl.h"
#include "rasterizer/kernels/round_outward-inl.h"
#include "rasterizer/kernels/settle_row.hpp"
#include "rasterizer/kernels/span_setup-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rasterdiff::rasterizer {
namespace HWY_NAMESPACE {

using F = hn::Rebind<float, D>;
using U = hn::Rebind<uint32_t, D>;

/// Bit k: number k differs from the one before it.
HWY_INLINE uint64_t Changes(const uint32_t* HWY_RESTRICT numbers) {
  const hn::CappedTag<uint32_t, 16> d;
  uint64_t bits = 0;
  for (size_t k = 0; k < 64; k += hn::MaxLanes(d)) {
    const auto changes = hn::Ne(hn::LoadU(d, numbers + k), hn::LoadU(d, numbers + k - 1));
#if HWY_TARGET <= HWY_AVX3
    bits |= uint64_t{changes.raw} << k;
#else
    uint8_t bytes[8] = {};
    hn::StoreMaskBits(d, changes, bytes);
    bits |= uint64_t{bytes[0]} << k;  // of at most eight lanes
#endif
  }
  return bits;
}

size_t FindRuns(const uint32_t* HWY_RESTRICT numbers, size_t width, uint32_t* HWY_RESTRICT starts) {
  size_t size = 1, x = 1;
  starts[0] = 0;
  for (; x + 64 <= width; x += 64) {
    for (uint64_t bits = Changes(numbers + x); bits != 0; bits &= bits - 1) starts[size++] = static_cast<uint32_t>(x + static_cast<size_t>(std::countr_zero(bits)));
  }
  for (; x < width; ++x) {
    starts[size] = static_cast<uint32_t>(x);
    size += numbers[x] != numbers[x - 1] ? 1 : 0;
  }
  return size;
}

HWY_INLINE void PutRun(const SettledRun& run, const LinearFunction& plane, double offset, double y, const SettledRow& row) {
  const D d;
  const F f;
  const U u;
  const LinearFunction p = plane;  // which no store can change
  const auto primitive = hn::Set(u, run.primitive);
  V pixel = NumbersFrom(d, static_cast<double>(run.begin));
  for (size_t i = run.begin; i < run.end; i += kLanes, pixel = pixel + hn::Set(d, kLanes)) {
    hn::StoreU(primitive, u, row.primitive + i);
    const Evaluated depth = Linear<0>(p, {pixel + hn::Set(d, offset), y});
    const auto [low, high] = RoundedOutward(depth.lo, depth.hi);
    // std::max(high, 0) keeps a zero's sign.
    hn::StoreInterleaved2(hn::Min(low, hn::Set(f, 1)), hn::IfThenElse(hn::Lt(high, hn::Zero(f)), hn::Zero(f), high), f, &row.bounds[i].lo);
  }
}

void SettleRuns(std::span<const SettledRun> runs, std::span<const LinearFunction> planes, size_t each, double offset, double y, Bounds none, const SettledRow& row) {
  const F f;
  const U u;
  for (const SettledRun& run : runs) {
    if (row.bounds != nullptr && run.plane != 0) {
      PutRun(run, planes[(run.plane - 1) * each], offset, y, row);
      continue;
    }
    for (size_t i = run.begin; i < run.end; i += kLanes) {
      hn::StoreU(hn::Set(u, run.primitive), u, row.primitive + i);
      if (row.bounds != nullptr) hn::StoreInterleaved2(hn::Set(f, none.lo), hn::Set(f, none.hi), f, &row.bounds[i].lo);
    }
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace rasterdiff::rasterizer
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rasterdiff::rasterizer {

HWY_EXPORT(FindRuns);
HWY_EXPORT(SettleRuns);

size_t findRuns(const uint32_t* numbers, size_t width, uint32_t* starts) { return HWY_DYNAMIC_DISPATCH(FindRuns)(numbers, width, starts); }

void settleRuns(std::span<const SettledRun> runs, std::span<const LinearFunction> planes, size_t each, double offset, double y, Bounds none, const SettledRow& row) {
  HWY_DYNAMIC_DISPATCH(SettleRuns)(runs, planes, each, offset, y, none, row);
}

}  // namespace rasterdiff::rasterizer
#endif
