// A vector of doubles as a number: what fragment/plane_formula.hpp asks of one.
#if defined(RASTERDIFF_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RASTERDIFF_LANES_INL_H
#undef RASTERDIFF_LANES_INL_H
#else
#define RASTERDIFF_LANES_INL_H
#endif

#include "rasterizer/kernels/span_setup-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rasterdiff::rasterizer {
namespace HWY_NAMESPACE {

struct Lanes {
  V v;
  Lanes() : v(hn::Zero(D())) {}
  explicit Lanes(double number) : v(hn::Set(D(), number)) {}
  explicit Lanes(V vector) : v(vector) {}
  friend HWY_INLINE Lanes operator+(const Lanes& a, const Lanes& b) { return Lanes(a.v + b.v); }
  friend HWY_INLINE Lanes operator-(const Lanes& a, const Lanes& b) { return Lanes(a.v - b.v); }
  friend HWY_INLINE Lanes operator*(const Lanes& a, const Lanes& b) { return Lanes(a.v * b.v); }
  friend HWY_INLINE Lanes operator/(const Lanes& a, const Lanes& b) { return Lanes(a.v / b.v); }
};

HWY_INLINE Lanes magnitude(const Lanes& a) { return Lanes(hn::Abs(a.v)); }
/// std::max, also where nobody knows.
HWY_INLINE Lanes larger(const Lanes& a, const Lanes& b) { return Lanes(hn::IfThenElse(hn::Lt(a.v, b.v), b.v, a.v)); }
/// For which lanes something holds.
struct LaneMask {
  M m;
};
HWY_INLINE LaneMask isZero(const Lanes& a) { return {hn::Eq(a.v, hn::Zero(D()))}; }
HWY_INLINE LaneMask isAtLeast(const Lanes& a, double bound) { return {hn::Ge(a.v, hn::Set(D(), bound))}; }
HWY_INLINE LaneMask both(const LaneMask& a, const LaneMask& b) { return {hn::And(a.m, b.m)}; }
HWY_INLINE LaneMask either(const LaneMask& a, const LaneMask& b) { return {hn::Or(a.m, b.m)}; }
HWY_INLINE Lanes chosen(const LaneMask& which, const Lanes& yes, const Lanes& no) { return Lanes(hn::IfThenElse(which.m, yes.v, no.v)); }

}  // namespace HWY_NAMESPACE
}  // namespace rasterdiff::rasterizer
HWY_AFTER_NAMESPACE();
#endif
