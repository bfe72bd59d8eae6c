#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rasterizer/kernels/settle_inputs.cpp"
#include "hwy/foreach_target.h"
// After foreach_target.h:
#include <algorithm>
#include <limits>

#include "hwy/highway.h"
#include "rasterizer/kernels/linear_over-inl.h"
#include "rasterizer/kernels/round_outward-inl.h"
#include "rasterizer/kernels/settle_inputs.hpp"
#include "rasterizer/kernels/span_setup-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rasterdiff::rasterizer {
namespace HWY_NAMESPACE {

template <size_t kCorners>
struct Divisor {
  V weight, radius, smallest;
  V corners[std::max<size_t>(kCorners, 1)];
  M determined;
};

template <size_t kCorners>
HWY_INLINE Divisor<kCorners> DivisorOf(const LinearFunction& f, const Pixels& p) {
  const V zero = hn::Zero(D());
  Divisor<kCorners> q;
  q.weight = At(f, p.x, p.y), q.radius = Radius(f, p), q.smallest = hn::Abs(q.weight);
  q.determined = hn::Gt(q.smallest, q.radius);
  for (size_t i = 0; i < kCorners; ++i) {
    const V at = q.corners[i] = AtCorner(f, p, i);
    const M otherSide = hn::Xor(hn::Gt(at, zero), hn::Gt(q.weight, zero));
    q.determined = hn::And(q.determined, hn::AndNot(otherSide, hn::Gt(hn::Abs(at), q.radius)));
    q.smallest = Least(q.smallest, hn::Abs(at));
  }
  return q;
}

template <size_t kCorners>
HWY_INLINE Evaluated Quotient(const LinearFunction& f, const Divisor<kCorners>& q, const Pixels& p) {
  const D d;
  const V value = At(f, p.x, p.y) / q.weight;
  V lo = value, hi = value;
  for (size_t i = 0; i < kCorners; ++i) {
    const V at = AtCorner(f, p, i) / q.corners[i];
    lo = Least(lo, at), hi = Most(hi, at);
  }
  const V magnitude = Most(hn::Abs(lo), hn::Abs(hi));
  const V radius = (Radius(f, p) + magnitude * q.radius) / (q.smallest - q.radius) + hn::Set(d, 4 * kHalfUlp) * magnitude;
  const Evaluated e = Widened(value, lo, hi, radius);
  const V infinity = hn::Set(d, std::numeric_limits<double>::infinity());
  return {value, hn::IfThenElse(q.determined, e.lo, hn::Neg(infinity)), hn::IfThenElse(q.determined, e.hi, infinity)};
}

/// Of the pixels from `x` on, `count` of them.
HWY_INLINE void Put(const Evaluated& e, const InputRow& row, size_t x, size_t count) {
  const FloatOf f;
  alignas(64) float value[kLanes], lo[kLanes], hi[kLanes];
  hn::Store(Rounded(e.value), f, value);
  const Outward outward = RoundedOutward(e.lo, e.hi);
  hn::Store(outward.lo, f, lo), hn::Store(outward.hi, f, hi);
  float* HWY_RESTRICT values = row.values + x * row.stride;
  Bounds* HWY_RESTRICT bounds = row.bounds + x * row.stride;
  for (size_t k = 0; k < count; ++k) values[k * row.stride] = value[k], bounds[k * row.stride] = {lo[k], hi[k]};
}

template <size_t kCorners>
void SettleAll(std::span<const SettledRun> runs, const InputPlanes& pieces, uint32_t y, std::span<const InputRow> rows) {
  const D d;
  const size_t components = pieces.kinds.size(), others = pieces.planesEach - components;
  const bool divides = std::ranges::find(pieces.kinds, ValueKind::Perspective) != pieces.kinds.end();
  for (const SettledRun& run : runs) {
    const LinearFunction* HWY_RESTRICT planes = pieces.planes.data() + (run.plane - 1) * pieces.planesEach;
    const float* HWY_RESTRICT constants = pieces.constants.data() + (run.plane - 1) * components;
    for (size_t x = run.begin; x < run.end; x += kLanes) {
      const size_t count = std::min<size_t>(kLanes, run.end - x);
      const Pixels p{NumbersFrom(d, static_cast<double>(x)) + hn::Set(d, 0.5), y + 0.5};
      Divisor<kCorners> divisor;
      if (divides) divisor = DivisorOf<kCorners>(planes[pieces.reciprocalW], p);
      for (size_t c = 0; c < components; ++c) {
        const LinearFunction& f = planes[others + c];
        switch (pieces.kinds[c]) {
          case ValueKind::Flat:
            for (size_t k = x; k < x + count; ++k) {
              rows[c].values[k * rows[c].stride] = constants[c];
              rows[c].bounds[k * rows[c].stride] = {constants[c], constants[c]};
            }
            break;
          case ValueKind::Noperspective: Put(Linear<kCorners>(f, p), rows[c], x, count); break;
          case ValueKind::Perspective: Put(Quotient<kCorners>(f, divisor, p), rows[c], x, count); break;
        }
      }
    }
  }
}

void SettleInputs(std::span<const SettledRun> runs, const InputPlanes& pieces, uint32_t y, std::span<const InputRow> rows) {
  return pieces.anywhere ? SettleAll<4>(runs, pieces, y, rows) : SettleAll<0>(runs, pieces, y, rows);
}

}  // namespace HWY_NAMESPACE
}  // namespace rasterdiff::rasterizer
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rasterdiff::rasterizer {

HWY_EXPORT(SettleInputs);

void settleInputs(std::span<const SettledRun> runs, const InputPlanes& pieces, uint32_t y, std::span<const InputRow> rows) {
  HWY_DYNAMIC_DISPATCH(SettleInputs)(runs, pieces, y, rows);
}

}  // namespace rasterdiff::rasterizer
#endif
