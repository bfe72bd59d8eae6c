// Runs are short, so they are written as whole vectors, from left to right: what is too much the next run overwrites.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rasterizer/kernels/settle_row.cpp"
#include "hwy/foreach_target.h"
// After foreach_target.h:
#include <limits>

#include "hwy/highway.h"
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

/// roundedUp of each: the least float that is not below.
HWY_INLINE hn::Vec<F> RoundedUp(V value) {
#if HWY_TARGET <= HWY_AVX3
  return hn::Vec<F>{_mm512_cvt_roundpd_ps(value.raw, _MM_FROUND_TO_POS_INF | _MM_FROUND_NO_EXC)};
#else
  const D d;
  const F f;
  const DI di;
  const auto rounded = hn::DemoteTo(f, value);
  const auto below = hn::DemoteTo(di, hn::IfThenElseZero(hn::Lt(hn::PromoteTo(d, rounded), value), hn::Set(d, 1)));
  const auto magnitude = hn::Set(di, 0x7FFFFFFF);
  const auto turned = [&](auto bits) { return hn::Xor(bits, hn::And(hn::ShiftRight<31>(bits), magnitude)); };
  return hn::BitCast(f, turned(turned(hn::BitCast(di, rounded)) + below));
#endif
}

HWY_INLINE hn::Vec<F> RoundedDown(V value) {
#if HWY_TARGET <= HWY_AVX3
  return hn::Vec<F>{_mm512_cvt_roundpd_ps(value.raw, _MM_FROUND_TO_NEG_INF | _MM_FROUND_NO_EXC)};
#else
  return hn::Neg(RoundedUp(hn::Neg(value)));
#endif
}

HWY_INLINE void PutBounds(const SettledRun& run, const LinearFunction& p, double offset, double y, Bounds* to) {
  const D d;
  const F f;
  const V rise = hn::Set(d, p.dy * (y - p.y0)), a0 = hn::Set(d, p.value), gx = hn::Set(d, p.dx), x0 = hn::Set(d, p.x0), one = hn::Set(d, 1);
  const V constant = hn::Set(d, p.constantRadius), perX = hn::Set(d, p.radiusPerX), farX = hn::Set(d, p.farX);
  const V alongY = hn::Set(d, p.radiusPerY * (std::max(p.farY, y) + 1));
  const V infinity = hn::Set(d, std::numeric_limits<double>::infinity());
  for (size_t i = run.begin; i < run.end; i += kLanes) {
    const V x = NumbersFrom(d, static_cast<double>(i)) + hn::Set(d, offset);
    const V value = (a0 + gx * (x - x0)) + rise;
    // std::max(farX, x) is farX where x is not larger, and where nobody knows.
    const V far = hn::IfThenElse(hn::Lt(farX, x), x, farX);
    const V radius = ((constant + perX * (far + one)) + alongY) + hn::Set(d, kHalfUlp) * hn::Abs(value);
    const V lo = value - radius, hi = value + radius;
    const M bounded = hn::And(hn::Eq(lo, lo), hn::Eq(hi, hi));
    const auto low = RoundedDown(hn::IfThenElse(bounded, lo, hn::Neg(infinity)));
    const auto high = RoundedUp(hn::IfThenElse(bounded, hi, infinity));
    // std::max(high, 0) keeps a zero's sign.
    hn::StoreInterleaved2(hn::Min(low, hn::Set(f, 1)), hn::IfThenElse(hn::Lt(high, hn::Zero(f)), hn::Zero(f), high), f, &to[i].lo);
  }
}

void SettleRuns(std::span<const SettledRun> runs, std::span<const LinearFunction> planes, double offset, double y, Bounds none, const SettledRow& row) {
  const F f;
  const U u;
  for (const SettledRun& run : runs) {
    for (size_t i = run.begin; i < run.end; i += kLanes) hn::StoreU(hn::Set(u, run.primitive), u, row.primitive + i);
    if (row.bounds == nullptr) continue;
    if (run.plane != 0) {
      PutBounds(run, planes[run.plane - 1], offset, y, row.bounds);
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

void settleRuns(std::span<const SettledRun> runs, std::span<const LinearFunction> planes, double offset, double y, Bounds none, const SettledRow& row) {
  HWY_DYNAMIC_DISPATCH(SettleRuns)(runs, planes, offset, y, none, row);
}

}  // namespace rasterdiff::rasterizer
#endif
