// ULPs are differences of 32-bit integers, errors and ratios are computed in doubles by the same operations as
// ValueAccumulator::add does one by one; sums are of integers. So every instruction set has the same answer.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "harness/compare/value_tally.cpp"
#include "hwy/foreach_target.h"
// After foreach_target.h:
#include "harness/compare/value_tally.hpp"
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace rasterdiff::harness {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

std::optional<uint32_t> DrawnIfAlike(const uint32_t* primitives, const uint32_t* otherPrimitives, const uint32_t* counts,
                                     const uint32_t* otherCounts, size_t samples) {
  const hn::CappedTag<uint32_t, kTallyStep> d;
  const auto zero = hn::Zero(d);
  auto difference = zero, undrawn = zero;
  for (size_t i = 0; i < samples; i += hn::Lanes(d)) {
    const auto primitive = hn::LoadU(d, primitives + i);
    difference = hn::Or(difference, hn::Xor(primitive, hn::LoadU(d, otherPrimitives + i)));
    difference = hn::Or(difference, hn::Xor(hn::LoadU(d, counts + i), hn::LoadU(d, otherCounts + i)));
    undrawn = hn::Sub(undrawn, hn::VecFromMask(d, hn::Eq(primitive, zero)));
  }
  if (!hn::AllTrue(d, hn::Eq(difference, zero))) return std::nullopt;
  return static_cast<uint32_t>(samples) - hn::GetLane(hn::SumOfLanes(d, undrawn));
}

using D = hn::CappedTag<double, 8>;
using DF = hn::Rebind<float, D>;
using DI = hn::Rebind<int32_t, D>;
using DU = hn::Rebind<uint32_t, D>;
using DU64 = hn::Rebind<uint64_t, D>;

/// The place of a float among all floats: -0 and +0 are 0, and the distance of two finite ones is below 2^32.
template <class V>
HWY_INLINE V PlaceOf(V bits, V magnitude) {
  const V sign = hn::BroadcastSignBit(bits);
  return hn::Sub(hn::Xor(magnitude, sign), sign);
}

std::optional<ValueTally> TallyValues(const ValueRun& run) {
  const D d;
  const DF df;
  const DI di;
  const DU du;
  const DU64 du64;
  const auto magnitudeBits = hn::Set(di, 0x7FFFFFFF), infinity = hn::Set(di, 0x7F800000);
  ValueTally tally;
  auto ulpSum = hn::Zero(du64);
  auto maxUlp = hn::Zero(du);
  auto maxAbs = hn::Zero(d), maxRatio = hn::Zero(d);
  for (size_t i = 0; i < run.values; i += hn::Lanes(d)) {
    const auto expected = hn::LoadU(df, run.expected + i), actual = hn::LoadU(df, run.actual + i);
    const auto expectedBits = hn::BitCast(di, expected), actualBits = hn::BitCast(di, actual);
    const auto unequal = hn::Ne(expectedBits, actualBits);
    if (hn::AllFalse(di, unequal)) continue;
    tally.unequal = true;
    const auto expectedMagnitude = hn::And(expectedBits, magnitudeBits), actualMagnitude = hn::And(actualBits, magnitudeBits);
    auto lo = hn::Zero(df), hi = hn::Zero(df);
    hn::LoadInterleaved2(df, &run.legal[i].lo, lo, hi);
    auto plain = hn::And(hn::Lt(hn::Max(expectedMagnitude, actualMagnitude), infinity),
                         hn::RebindMask(di, hn::And(hn::Ge(actual, lo), hn::Le(actual, hi))));
    if (run.drawn != nullptr) {
      plain = hn::And(plain, hn::Ne(hn::BitCast(di, hn::LoadU(du, run.drawn + i)), hn::Zero(di)));
    }
    if (!hn::AllFalse(di, hn::AndNot(plain, unequal))) return std::nullopt;

    const auto expectedPlace = PlaceOf(expectedBits, expectedMagnitude), actualPlace = PlaceOf(actualBits, actualMagnitude);
    const auto ulps = hn::BitCast(du, hn::Sub(hn::Max(expectedPlace, actualPlace), hn::Min(expectedPlace, actualPlace)));
    ulpSum = hn::Add(ulpSum, hn::PromoteTo(du64, ulps));
    maxUlp = hn::Max(maxUlp, ulps);
    tally.allowed += hn::CountTrue(du, hn::Ne(ulps, hn::Zero(du)));

    // Values that are alike become 0: they may be infinite or NaN. An error of 0 changes no largest error.
    const auto floatUnequal = hn::RebindMask(df, unequal);
    const auto e = hn::PromoteTo(d, hn::IfThenElseZero(floatUnequal, expected));
    const auto error = hn::Sub(hn::PromoteTo(d, hn::IfThenElseZero(floatUnequal, actual)), e);
    const auto reach = hn::IfThenElse(hn::Gt(error, hn::Zero(d)), hn::Sub(hn::PromoteTo(d, hi), e), hn::Sub(e, hn::PromoteTo(d, lo)));
    const auto absolute = hn::Abs(error);
    maxAbs = hn::Max(maxAbs, absolute);
    maxRatio = hn::Max(maxRatio, hn::IfThenElseZero(hn::Gt(reach, hn::Zero(d)), hn::Div(absolute, reach)));
  }
  tally.ulpSum = hn::GetLane(hn::SumOfLanes(du64, ulpSum));
  tally.maxUlp = hn::GetLane(hn::MaxOfLanes(du, maxUlp));
  tally.maxAbs = hn::GetLane(hn::MaxOfLanes(d, maxAbs));
  tally.maxRatio = hn::GetLane(hn::MaxOfLanes(d, maxRatio));
  return tally;
}

}  // namespace HWY_NAMESPACE
}  // namespace rasterdiff::harness
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rasterdiff::harness {

HWY_EXPORT(DrawnIfAlike);
HWY_EXPORT(TallyValues);

std::optional<uint32_t> drawnIfAlike(const uint32_t* primitives, const uint32_t* otherPrimitives, const uint32_t* counts,
                                     const uint32_t* otherCounts, size_t samples) {
  return HWY_DYNAMIC_DISPATCH(DrawnIfAlike)(primitives, otherPrimitives, counts, otherCounts, samples);
}

std::optional<ValueTally> tallyValues(const ValueRun& run) { return HWY_DYNAMIC_DISPATCH(TallyValues)(run); }

}  // namespace rasterdiff::harness
#endif
