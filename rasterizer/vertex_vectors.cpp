// Every operation is one of vertex_stage.cpp, viewport.cpp or snap.cpp, in the same order and precision, so that results are the same
// bits. Under exact arithmetic a lane is left to snapExactly where a double may be wrong: near a decision, unless it is exact. It is,
// where w is a power of two: the product with the scale (24 + 24 bits) and the quotient are exact, and what the sum loses is looked at.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rasterizer/vertex_vectors.cpp"
#include "hwy/foreach_target.h"
// After foreach_target.h:
#include <cmath>

#include "hwy/highway.h"
#include "rasterizer/kernels/span_setup-inl.h"
#include "rasterizer/vertex_vectors.hpp"

HWY_BEFORE_NAMESPACE();
namespace rasterdiff::rasterizer {
namespace HWY_NAMESPACE {

using F = hn::Rebind<float, D>;
using I = DI;
using U = hn::Rebind<uint32_t, D>;
using VF = hn::Vec<F>;

struct ClipVectors {
  VF x, y, z, w;
};

/// What all vertices share.
struct Staging {
  const VertexStage& stage;
  ViewportArithmetic arithmetic;
  SnapRounding rounding;
  SnapShift shift;
  int bits;

  explicit Staging(const VertexStage& s)
      : stage(s), arithmetic(s.rules.choices.viewportArithmetic), rounding(s.rules.choices.snapRounding),
        shift(snapShift(s.rules, s.samples)), bits(gridBits(s.rules)) {}
};

HWY_INLINE V RoundTo(V v, SnapRounding rounding) {
  const D d;
  const V half = hn::Set(d, 0.5);
  const auto down = [&] { return hn::Ceil(v - half); };
  const auto up = [&] { return hn::Floor(v + half); };
  const auto negative = hn::Lt(v, hn::Zero(d));
  switch (rounding) {
    case SnapRounding::NearestEven: return hn::Round(v);
    case SnapRounding::NearestUp: return up();
    case SnapRounding::Floor: return hn::Floor(v);
    case SnapRounding::TowardZero: return hn::Trunc(v);
    case SnapRounding::NearestDown: return down();
    case SnapRounding::NearestAway: return hn::IfThenElse(negative, down(), up());
    case SnapRounding::NearestTowardZero: return hn::IfThenElse(negative, up(), down());
    case SnapRounding::Ceiling: return hn::Ceil(v);
  }
  return v;
}

HWY_INLINE hn::Vec<I> ToSubpixels(V steps, const Staging& s) {
  const I i;
  const auto grid = hn::ShiftLeftSame(hn::DemoteTo(i, steps), kSubpixelBits - s.bits);
  return s.shift == SnapShift::None ? grid : grid + hn::Set(i, kSubpixelOne / 2);
}

HWY_INLINE VF Fused(VF a, VF b, VF c) {
#if HWY_TARGET <= HWY_AVX2
  return hn::MulAdd(a, b, c);
#else
  const F f;
  alignas(64) float x[kLanes], y[kLanes], z[kLanes];
  hn::Store(a, f, x), hn::Store(b, f, y), hn::Store(c, f, z);
  for (size_t k = 0; k < kLanes; ++k) x[k] = std::fma(x[k], y[k], z[k]);
  return hn::Load(f, x);
#endif
}

/// mapAndSnapFloat.
HWY_INLINE hn::Vec<I> SnapFloats(VF coordinate, VF w, const ViewportAxis& axis, const Staging& s) {
  const F f;
  const D d;
  const VF scale = hn::Set(f, static_cast<float>(axis.scale));
  float origin = static_cast<float>(axis.centre) + static_cast<float>(axis.origin);
  if (s.shift == SnapShift::InViewport) origin -= 0.5F;
  const VF offset = hn::Set(f, origin);
  const bool divides = s.arithmetic == ViewportArithmetic::Float32Division || s.arithmetic == ViewportArithmetic::Float32DivisionFma;
  const bool fuses = s.arithmetic == ViewportArithmetic::Float32Fma || s.arithmetic == ViewportArithmetic::Float32DivisionFma;
  const VF ndc = divides ? coordinate / w : coordinate * (hn::Set(f, 1.0F) / w);
  VF pixels = fuses ? Fused(ndc, scale, offset) : ndc * scale + offset;
  if (s.shift == SnapShift::AfterViewport) pixels = pixels - hn::Set(f, 0.5F);
  const VF low = hn::Set(f, static_cast<float>(-kGuardBand)), high = hn::Set(f, static_cast<float>(kGuardBand));
  // NaN goes to the low end.
  const VF clamped = hn::IfThenElse(hn::Gt(pixels, low), hn::Min(pixels, high), low);
  const VF scaled = clamped * hn::Set(f, std::ldexp(1.0F, s.bits));
  return ToSubpixels(RoundTo(hn::PromoteTo(d, scaled), s.rounding), s);
}

HWY_INLINE M IsPowerOfTwo(V w) {
  const hn::RebindToUnsigned<D> u;
  const auto mantissa = hn::And(hn::BitCast(u, w), hn::Set(u, (uint64_t{1} << 52) - 1));
  return hn::RebindMask(D(), hn::Eq(mantissa, hn::Zero(u)));
}

/// snapUnder for exact arithmetic.
HWY_INLINE hn::Vec<I> SnapExactly(VF coordinate, VF w, const ViewportAxis& axis, const Staging& s) {
  const D d;
  const ViewportAxis shifted{axis.scale, s.shift == SnapShift::None ? axis.origin : axis.origin - 0.5, axis.centre};
  const double offset = shifted.offset(), fromCentre = offset - shifted.centre;
  const bool offsetIsExact = (shifted.origin - fromCentre) + (shifted.centre - (offset - fromCentre)) == 0;
  const V wide = hn::PromoteTo(d, w), quotient = hn::PromoteTo(d, coordinate) * hn::Set(d, shifted.scale) / wide;
  const V off = hn::Set(d, offset), sum = quotient + off;
  const V part = sum - off, lost = (quotient - part) + (off - (sum - part));
  const V value = sum * hn::Set(d, std::ldexp(1.0, s.bits));
  const V below = hn::Floor(value), trust = hn::Set(d, kSnapTrust) * (hn::Abs(value) + hn::Set(d, 1));
  const auto decides = [&](V point) { return hn::Gt(hn::Abs(value - point), trust); };
  M sure = hn::And(decides(hn::Round(value)), decides(below + hn::Set(d, 0.5)));
  // Exact: halves of steps, whose roundings are exact, too.
  const V twice = value + value;
  const M exact = hn::And(hn::And(IsPowerOfTwo(wide), hn::Eq(lost, hn::Zero(d))), hn::Eq(hn::Round(twice), twice));
  if (offsetIsExact) sure = hn::Or(sure, exact);
  sure = hn::And(sure, hn::Lt(hn::Abs(sum), hn::Set(d, kGuardBand)));
  const auto snapped = ToSubpixels(RoundTo(hn::IfThenElseZero(sure, value), s.rounding), s);
  if (HWY_LIKELY(hn::AllTrue(d, sure))) return snapped;
  const F f;
  const I i;
  alignas(64) float at[kLanes], by[kLanes];
  alignas(64) int32_t lanes[kLanes];
  uint8_t bits[8] = {};
  hn::Store(coordinate, f, at), hn::Store(w, f, by), hn::Store(snapped, i, lanes);
  hn::StoreMaskBits(d, sure, bits);
  for (size_t k = 0; k < kLanes; ++k)
    if ((bits[0] >> k & 1) == 0 && by[k] > 0 && std::isfinite(at[k]) && std::isfinite(by[k])) lanes[k] = snapUnder(s.stage.rules, s.stage.samples, at[k], by[k], axis);
  return hn::Load(i, lanes);
}

HWY_INLINE hn::Vec<I> Snap(VF coordinate, VF w, const ViewportAxis& axis, const Staging& s) {
  return s.arithmetic == ViewportArithmetic::Exact ? SnapExactly(coordinate, w, axis, s) : SnapFloats(coordinate, w, axis, s);
}

HWY_INLINE hn::Vec<U> Codes(const ClipVectors& p, const ClipVolume& volume) {
  const F f;
  const U u;
  const VF zero = hn::Zero(f);
  hn::Vec<U> code = hn::Zero(u);
  const auto set = [&](hn::Mask<F> mask, uint32_t bit) { code = hn::Or(code, hn::IfThenElseZero(hn::RebindMask(u, mask), hn::Set(u, bit))); };
  set(hn::Gt(p.x, p.w), 1), set(hn::Gt(zero, p.x + p.w), 2), set(hn::Gt(p.y, p.w), 4), set(hn::Gt(zero, p.y + p.w), 8);
  if (volume.nearAndFar) set(hn::Gt(zero, volume.nearAtMinusW ? p.z + p.w : p.z), 16), set(hn::Gt(p.z, p.w), 32);
  const auto finite = hn::And(hn::And(hn::IsFinite(p.x), hn::IsFinite(p.y)), hn::And(hn::IsFinite(p.z), hn::IsFinite(p.w)));
  set(hn::Not(hn::And(finite, hn::Gt(p.w, zero))), kNoPlace);
  return code;
}

HWY_INLINE M IsFloat(V v) { return hn::Eq(hn::PromoteTo(D(), hn::DemoteTo(F(), v)), v); }

/// viewportArithmeticBound; `at` becomes toFramebuffer's coordinate.
HWY_INLINE V ArithmeticBound(V coordinate, V w, M powerOfTwo, const ViewportAxis& axis, V& at) {
  const D d;
  const double offset = axis.offset();
  const V scale = hn::Set(d, axis.scale), off = hn::Set(d, offset);
  at = coordinate * scale / w + off;
  const V ndc = coordinate / w, scaled = ndc * scale, result = scaled + off;
  const V bound = hn::Set(d, kHalfUlp) * (((hn::Set(d, 3) * hn::Abs(scaled) + hn::Set(d, std::fabs(offset))) + hn::Set(d, 2) * hn::Abs(result)) + hn::Set(d, 1));
  const auto isFloat = [](double v) { return static_cast<double>(static_cast<float>(v)) == v; };
  if (!isFloat(axis.scale) || !isFloat(offset)) return bound;
  const M floats = hn::And(hn::And(IsFloat(ndc), IsFloat(scaled)), hn::And(IsFloat(result), IsFloat(result - hn::Set(d, 0.5))));
  return hn::IfThenZeroElse(hn::And(powerOfTwo, floats), bound);
}

struct DepthVectors {
  V x, y, z, deviation, error;
};

HWY_INLINE DepthVectors Depths(const ClipVectors& p, hn::Vec<I> snappedX, hn::Vec<I> snappedY, const VertexStage& stage, const PlanePlaces& places) {
  const D d;
  const V w = hn::PromoteTo(d, p.w);
  const M powerOfTwo = IsPowerOfTwo(w);
  DepthVectors v;
  const V errorX = ArithmeticBound(hn::PromoteTo(d, p.x), w, powerOfTwo, stage.viewport.x, v.x);
  const V errorY = ArithmeticBound(hn::PromoteTo(d, p.y), w, powerOfTwo, stage.viewport.y, v.y);
  v.deviation = hn::Max(errorX, errorY);
  const double offset = stage.viewport.z.offset();
  const V scaled = hn::PromoteTo(d, p.z) * hn::Set(d, stage.viewport.z.scale) / w;
  v.z = scaled + hn::Set(d, offset);
  v.error = hn::Set(d, kHalfUlp) * ((hn::Set(d, 3) * hn::Abs(scaled) + hn::Set(d, std::fabs(offset))) + hn::Abs(v.z));
  const V pixel = hn::Set(d, 1.0 / kSubpixelOne), x = hn::PromoteTo(d, snappedX) * pixel, y = hn::PromoteTo(d, snappedY) * pixel;
  if (places.snapped) {
    v.x = x, v.y = y, v.deviation = hn::Zero(d);
  } else if (places.either) {
    v.deviation = hn::Max(v.deviation, hn::Max(hn::Abs(v.x - x), hn::Abs(v.y - y)));
  }
  return v;
}

HWY_INLINE void StoreDepths(const DepthVectors& v, size_t count, DepthVertex* to) {
  const D d;
  alignas(64) double lanes[5][kLanes];
  hn::Store(v.x, d, lanes[0]), hn::Store(v.y, d, lanes[1]), hn::Store(v.z, d, lanes[2]);
  hn::Store(v.deviation, d, lanes[3]), hn::Store(v.error, d, lanes[4]);
  for (size_t k = 0; k < count; ++k) to[k] = {lanes[0][k], lanes[1][k], lanes[2][k], lanes[3][k], lanes[4][k]};
}

uint64_t StageAll(std::span<const ClipPosition> positions, const VertexStage& stage, const ClipVolume& volume, size_t first, StagedVertices& to) {
  const F f;
  const U u;
  const I i;
  const Staging staging(stage);
  const PlanePlaces places(stage.rules);
  uint64_t divided = 0;
  for (size_t from = 0; from < positions.size(); from += kLanes) {
    const size_t count = std::min(kLanes, positions.size() - from);
    ClipPosition rest[kLanes];
    const ClipPosition* given = positions.data() + from;
    if (HWY_UNLIKELY(count < kLanes)) std::copy(given, given + count, rest), given = rest;
    ClipVectors p;
    hn::LoadInterleaved4(f, &given->x, p.x, p.y, p.z, p.w);
    divided += kLanes - hn::CountTrue(f, hn::Eq(p.w, hn::Set(f, 1)));  // NaN is not 1 either
    const auto x = Snap(p.x, p.w, stage.viewport.x, staging), y = Snap(p.y, p.w, stage.viewport.y, staging);
    alignas(64) SubpixelPosition snapped[kLanes];
    alignas(64) uint32_t codes[kLanes];
    hn::StoreInterleaved2(x, y, i, &snapped->x);
    hn::Store(Codes(p, volume), u, codes);
    std::copy_n(snapped, count, to.snapped.data() + first + from);
    std::copy_n(codes, count, to.codes.data() + first + from);
    if (!to.depths.empty()) StoreDepths(Depths(p, x, y, stage, places), count, to.depths.data() + first + from);
  }
  return divided;
}

}  // namespace HWY_NAMESPACE
}  // namespace rasterdiff::rasterizer
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rasterdiff::rasterizer {

HWY_EXPORT(StageAll);

StagedVertices::StagedVertices(size_t size, bool deep) : snapped(size), codes(size), depths(deep ? size : 0) {}

DepthVertex depthVertex(const RasterVertex& v, const PlanePlaces& places) {
  const double x = v.snapped.x / double{kSubpixelOne}, y = v.snapped.y / double{kSubpixelOne};
  if (places.snapped) return {x, y, v.position.z, 0, v.depthError};
  double deviation = v.deviation;
  if (places.either) deviation = std::max({deviation, std::fabs(v.position.x - x), std::fabs(v.position.y - y)});
  return {v.position.x, v.position.y, v.position.z, deviation, v.depthError};
}

bool stagesInVectors(const Rules& rules) { return !rules.open && rules.error == DeliberateError::None && !rules.variation; }

uint64_t stageVertices(std::span<const ClipPosition> positions, const VertexStage& stage, const ClipVolume& volume, size_t first,
                       StagedVertices& to) {
  return HWY_DYNAMIC_DISPATCH(StageAll)(positions, stage, volume, first, to);
}

}  // namespace rasterdiff::rasterizer
#endif
