// Values and bounds in doubles to float32, bounds outward: roundedDown and roundedUp (fragment/linear_function.hpp) of a vector.
#if defined(RASTERDIFF_ROUND_OUTWARD_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RASTERDIFF_ROUND_OUTWARD_INL_H
#undef RASTERDIFF_ROUND_OUTWARD_INL_H
#else
#define RASTERDIFF_ROUND_OUTWARD_INL_H
#endif

#include <limits>

#include "rasterizer/kernels/span_setup-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rasterdiff::rasterizer {
namespace HWY_NAMESPACE {

using FloatOf = hn::Rebind<float, D>;

/// The nearest float. Highway's scalar DemoteTo has no infinities.
HWY_INLINE hn::Vec<FloatOf> Rounded(V value) {
#if HWY_TARGET == HWY_SCALAR
  return hn::Vec<FloatOf>(static_cast<float>(value.raw));
#else
  return hn::DemoteTo(FloatOf(), value);
#endif
}

/// The least float that is not below.
HWY_INLINE hn::Vec<FloatOf> RoundedUp(V value) {
#if HWY_TARGET <= HWY_AVX3
  return hn::Vec<FloatOf>{_mm512_cvt_roundpd_ps(value.raw, _MM_FROUND_TO_POS_INF | _MM_FROUND_NO_EXC)};
#else
  const D d;
  const FloatOf f;
  const DI di;
  const auto rounded = Rounded(value);
  const auto below = hn::DemoteTo(di, hn::IfThenElseZero(hn::Lt(hn::PromoteTo(d, rounded), value), hn::Set(d, 1)));
  const auto magnitude = hn::Set(di, 0x7FFFFFFF);
  const auto turned = [&](auto bits) { return hn::Xor(bits, hn::And(hn::ShiftRight<31>(bits), magnitude)); };
  return hn::BitCast(f, turned(turned(hn::BitCast(di, rounded)) + below));
#endif
}

/// The greatest float that is not above.
HWY_INLINE hn::Vec<FloatOf> RoundedDown(V value) {
#if HWY_TARGET <= HWY_AVX3
  return hn::Vec<FloatOf>{_mm512_cvt_roundpd_ps(value.raw, _MM_FROUND_TO_NEG_INF | _MM_FROUND_NO_EXC)};
#else
  return hn::Neg(RoundedUp(hn::Neg(value)));
#endif
}

struct Outward {
  hn::Vec<FloatOf> lo, hi;
};

/// Unbounded where either is not a number.
HWY_INLINE Outward RoundedOutward(V lo, V hi) {
  const V infinity = hn::Set(D(), std::numeric_limits<double>::infinity());
  const M bounded = hn::And(hn::Eq(lo, lo), hn::Eq(hi, hi));
  return {RoundedDown(hn::IfThenElse(bounded, lo, hn::Neg(infinity))), RoundedUp(hn::IfThenElse(bounded, hi, infinity))};
}

}  // namespace HWY_NAMESPACE
}  // namespace rasterdiff::rasterizer
HWY_AFTER_NAMESPACE();
#endif
