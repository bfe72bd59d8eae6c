// LinearFunction (fragment/linear_function.hpp) and linearOver (fragment/value_planes.hpp) for a vector of pixels in one row: operation
// by operation, so that they have the same bits.
#if defined(RASTERDIFF_LINEAR_OVER_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RASTERDIFF_LINEAR_OVER_INL_H
#undef RASTERDIFF_LINEAR_OVER_INL_H
#else
#define RASTERDIFF_LINEAR_OVER_INL_H
#endif

#include <algorithm>

#include "rasterizer/fragment/linear_function.hpp"
#include "rasterizer/kernels/span_setup-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rasterdiff::rasterizer {
namespace HWY_NAMESPACE {

// std::min and std::max, which keep `a` where nobody knows.
HWY_INLINE V Least(V a, V b) { return hn::IfThenElse(hn::Lt(b, a), b, a); }
HWY_INLINE V Most(V a, V b) { return hn::IfThenElse(hn::Lt(a, b), b, a); }

/// A vector of pixels in one row, and the corners of their areas: none, or left top, right top, left bottom, right bottom.
struct Pixels {
  V x;
  double y;
};
inline constexpr double kCornerX[] = {-0.5, 0.5, -0.5, 0.5}, kCornerY[] = {-0.5, -0.5, 0.5, 0.5};

HWY_INLINE V At(const LinearFunction& f, V x, double y) {
  const D d;
  return (hn::Set(d, f.value) + hn::Set(d, f.dx) * (x - hn::Set(d, f.x0))) + hn::Set(d, f.dy * (y - f.y0));
}

HWY_INLINE V AtCorner(const LinearFunction& f, const Pixels& p, size_t corner) { return At(f, p.x + hn::Set(D(), kCornerX[corner]), p.y + kCornerY[corner]); }

HWY_INLINE V Radius(const LinearFunction& f, const Pixels& p) {
  const D d;
  const V far = Most(hn::Set(d, f.farX), p.x), one = hn::Set(d, 1);
  return (hn::Set(d, f.constantRadius) + hn::Set(d, f.radiusPerX) * (far + one)) + hn::Set(d, f.radiusPerY * (std::max(f.farY, p.y) + 1));
}

struct Evaluated {
  V value, lo, hi;
};

HWY_INLINE Evaluated Widened(V value, V lo, V hi, V radius) { return {value, lo - radius, hi + radius}; }

template <size_t kCorners>
HWY_INLINE Evaluated Linear(const LinearFunction& f, const Pixels& p) {
  const V value = At(f, p.x, p.y);
  V lo = value, hi = value;
  for (size_t i = 0; i < kCorners; ++i) {
    const V at = AtCorner(f, p, i);
    lo = Least(lo, at), hi = Most(hi, at);
  }
  return Widened(value, lo, hi, Radius(f, p) + hn::Set(D(), kHalfUlp) * Most(hn::Abs(lo), hn::Abs(hi)));
}

}  // namespace HWY_NAMESPACE
}  // namespace rasterdiff::rasterizer
HWY_AFTER_NAMESPACE();
#endif
