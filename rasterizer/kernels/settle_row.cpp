// Runs are short, so they are written as whole vectors, from left to right: what is too much the next run overwrites.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rasterizer/kernels/settle_row.cpp"
#include "hwy/foreach_target.h"
// After foreach_target.h:
#include "hwy/highway.h"
#include "rasterizer/kernels/round_outward-inl.h"
#include "rasterizer/kernels/settle_row.hpp"
#include "rasterizer/kernels/span_setup-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rasterdiff::rasterizer {
namespace HWY_NAMESPACE {

using F = hn::Rebind<float, D>;
using U = hn::Rebind<uint32_t, D>;

size_t FindRuns(const uint32_t* HWY_RESTRICT numbers, size_t width, uint32_t* HWY_RESTRICT starts) {
  const hn::CappedTag<uint32_t, 16> d;
  size_t size = 1;
  starts[0] = 0;
  for (size_t x = 1; x < width; x += hn::Lanes(d)) {
    uint8_t bytes[8] = {};
    hn::StoreMaskBits(d, hn::Ne(hn::LoadU(d, numbers + x), hn::LoadU(d, numbers + x - 1)), bytes);
    for (uint32_t bits = bytes[0] | uint32_t{bytes[1]} << 8; bits != 0; bits &= bits - 1)
      starts[size++] = static_cast<uint32_t>(x) + static_cast<uint32_t>(__builtin_ctz(bits));
  }
  while (size > 1 && starts[size - 1] >= width) --size;
  return size;
}

HWY_INLINE void PutBounds(const SettledRun& run, const LinearFunction& p, double offset, double y, Bounds* to) {
  const D d;
  const F f;
  const V rise = hn::Set(d, p.dy * (y - p.y0)), a0 = hn::Set(d, p.value), gx = hn::Set(d, p.dx), x0 = hn::Set(d, p.x0), one = hn::Set(d, 1);
  const V constant = hn::Set(d, p.constantRadius), perX = hn::Set(d, p.radiusPerX), farX = hn::Set(d, p.farX);
  const V alongY = hn::Set(d, p.radiusPerY * (std::max(p.farY, y) + 1));
  for (size_t i = run.begin; i < run.end; i += kLanes) {
    const V x = NumbersFrom(d, static_cast<double>(i)) + hn::Set(d, offset);
    const V value = (a0 + gx * (x - x0)) + rise;
    // std::max(farX, x) is farX where x is not larger, and where nobody knows.
    const V far = hn::IfThenElse(hn::Lt(farX, x), x, farX);
    const V radius = ((constant + perX * (far + one)) + alongY) + hn::Set(d, kHalfUlp) * hn::Abs(value);
    const V lo = value - radius, hi = value + radius;
    const auto [low, high] = RoundedOutward(lo, hi);
    // std::max(high, 0) keeps a zero's sign.
    hn::StoreInterleaved2(hn::Min(low, hn::Set(f, 1)), hn::IfThenElse(hn::Lt(high, hn::Zero(f)), hn::Zero(f), high), f, &to[i].lo);
  }
}

void SettleRuns(std::span<const SettledRun> runs, std::span<const LinearFunction> planes, size_t each, double offset, double y, Bounds none, const SettledRow& row) {
  const F f;
  const U u;
  for (const SettledRun& run : runs) {
    for (size_t i = run.begin; i < run.end; i += kLanes) hn::StoreU(hn::Set(u, run.primitive), u, row.primitive + i);
    if (row.bounds == nullptr) continue;
    if (run.plane != 0) {
      PutBounds(run, planes[(run.plane - 1) * each], offset, y, row.bounds);
      continue;
    }
    for (size_t i = run.begin; i < run.end; i += kLanes) hn::StoreInterleaved2(hn::Set(f, none.lo), hn::Set(f, none.hi), f, &row.bounds[i].lo);
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
