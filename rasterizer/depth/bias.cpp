#include "rasterizer/depth/bias.hpp"

namespace rasterdiff::rasterizer {
namespace {

// 2^(e - 23) for the exponent e of a float32 number. // IEEE 754: value = 1.m · 2^e, 23 bits of m
double unitOf(double z) {
  if (!(z > 0)) return 0;
  int exponent = 0;
  std::frexp(z, &exponent);  // z = f · 2^exponent, 0.5 <= f < 1
  return std::ldexp(1.0, exponent - 1 - 23);
}

// [choice:depth-bias-unit]
double unitOf(DepthBiasUnit unit, uint32_t bits) {
  const auto range = static_cast<double>((uint64_t{1} << bits) - 1);
  switch (unit) {
    case DepthBiasUnit::OneStep: break;
    case DepthBiasUnit::TwoSteps: return 2 / range;
    case DepthBiasUnit::OneStepOfRange: return 1 / range;
    case DepthBiasUnit::OneStepAndPercent: return 1.01 / range;
  }
  return std::ldexp(1.0, -static_cast<int>(bits));
}

double clampBias(double bias, double limit) {
  if (limit > 0) return std::min(bias, limit);
  if (limit < 0) return std::max(bias, limit);
  return bias;  // 0 or NaN: no clamp
}

Interval scaled(const Interval& interval, double factor) {
  if (factor == 0) return {};
  const double a = interval.lo * factor, b = interval.hi * factor;
  return {interval.value * factor, std::min(a, b), std::max(a, b)};
}

}  // namespace

Interval smallestDifference(uint32_t bits, const Interval& largestDepth, const Rules& rules) {
  if (rules.error == DeliberateError::DepthBiasUnitOf24 && bits != 0) bits = 24;
  if (bits == 0 && rules.error == DeliberateError::DepthBiasUnitFixed) return {0x1p-24, 0x1p-24, 0x1p-24};
  if (bits == 0) {
    // The float32 number nearest to the depth has the exponent; under a rounding up it is the next one.
    const auto rounded = [](double z) { return static_cast<double>(static_cast<float>(z)); };
    return {unitOf(rounded(largestDepth.value)), unitOf(rounded(largestDepth.lo)), unitOf(rounded(largestDepth.hi))};
  }
  const double step = std::ldexp(1.0, -static_cast<int>(bits));
  if (rules.variation) return {rules.variation->biasUnit * step, rules.variation->biasUnit * step, rules.variation->biasUnit * step};
  const double chosen = unitOf(rules.choices.depthBiasUnit, bits);
  if (!rules.open) return {chosen, chosen, chosen};
  return {chosen, step, 2 * step};
}

Interval depthBias(const State& state, uint32_t bits, const Rules& rules, const BiasInputs& inputs) {
  const Gradient& slope = inputs.slope;
  const double larger = std::max(std::fabs(slope.dx), std::fabs(slope.dy));
  const double length = std::hypot(slope.dx, slope.dy);
  const double nominal = rules.choices.depthBiasSlope == DepthBiasSlope::Length ? length : larger;  // [choice:depth-bias-slope]
  const double shortest = rules.open ? larger : nominal, longest = rules.open ? length : nominal;
  Interval m{nominal, std::max(0.0, shortest - slope.radius), longest + std::sqrt(2.0) * slope.radius};
  if (rules.variation) m.value = larger + rules.variation->biasSlope * (length - larger);
  double slopeFactor = state.depthBiasSlopeFactor, constantFactor = state.depthBiasConstantFactor, limit = state.depthBiasClamp;
  if (rules.error == DeliberateError::DepthBiasSlopeSum) m.value = std::fabs(slope.dx) + std::fabs(slope.dy);
  if (rules.error == DeliberateError::DepthBiasSlopeX) m.value = std::fabs(slope.dx);
  if (rules.error == DeliberateError::DepthBiasSlopeIgnored) slopeFactor = 0;
  if (rules.error == DeliberateError::DepthBiasTripled) constantFactor *= 3;
  if (rules.error == DeliberateError::DepthBiasUnclamped) limit = 0;

  const Interval bySlope = scaled(m, slopeFactor);
  const Interval byUnit = scaled(smallestDifference(bits, inputs.largestDepth, rules), constantFactor);
  // Two products and a sum in float32.
  const double largest = std::max(std::fabs(bySlope.lo), std::fabs(bySlope.hi)) + std::max(std::fabs(byUnit.lo), std::fabs(byUnit.hi));
  const double rounding = 3 * kHalfUlp * largest;
  return {clampBias(bySlope.value + byUnit.value, limit), clampBias(bySlope.lo + byUnit.lo - rounding, limit),
          clampBias(bySlope.hi + byUnit.hi + rounding, limit)};
}

}  // namespace rasterdiff::rasterizer
