#include "rasterizer/depth/depth_stage.hpp"

namespace rasterdiff::rasterizer {
namespace {

bool clipsDepth(const State& state) { return state.depthClipEnable.value_or(!state.depthClampEnable); }

}  // namespace

DepthStage::DepthStage(const Scene& scene, const Rules& rules, RuleCounts* counts)
    : state_(scene.state), rules_(rules), counts_(counts),
      format_(scene.target.depthFormat.value_or(DepthFormat::D32_SFLOAT)),
      biases_(scene.state.depthBiasEnable && scene.target.depthFormat.has_value()),
      clamps_(scene.state.depthClampEnable && rules.error != DeliberateError::DepthClampIgnored),
      mayLeaveRange_(!clamps_ && (biases_ || !clipsDepth(scene.state))),
      plain_(unormBits(format_) == 0 && !biases_ && !clamps_ && !mayLeaveRange_) {}

void DepthStage::setUp(const Primitive& primitive) {
  minDepth_ = std::min(primitive.minDepth, primitive.maxDepth);
  maxDepth_ = std::max(primitive.minDepth, primitive.maxDepth);
  bias_ = {};
}

void DepthStage::setBias(const BiasInputs& inputs) {
  bias_ = depthBias(state_, unormBits(format_), rules_, inputs);
  if (state_.depthBiasConstantFactor != 0) count(Rule::DepthBiasUnit);
  if (state_.depthBiasSlopeFactor != 0 || state_.depthBiasClamp != 0) count(Rule::DepthBiasSlope);
}

void DepthStage::setFigureBias(const Primitive& primitive, const BiasInputs& inputs) {
  count(Rule::DepthBiasMode);
  if (primitive.assembled.count == 3) {
    setBias(inputs);
    if (rules_.error == DeliberateError::DepthBiasOnFillOnly) bias_ = {};
    return;
  }
  // [choice:line-bias] a profile has none on lines and points.
  if (rules_.variation && rules_.variation->biasesLines) setBias(inputs);
  if (!rules_.open) return;
  const Interval whole = depthBias(state_, unormBits(format_), rules_, inputs);
  // What the slope of a line or a point is, is not stated: none, or that of its values on the screen.
  const Interval level = depthBias(state_, unormBits(format_), rules_, {{}, inputs.largestDepth});
  bias_ = {0, std::min({0.0, whole.lo, level.lo}), std::max({0.0, whole.hi, level.hi})};
}

Interval DepthStage::biased(const Interval& z) const {
  if (!biases_) return z;
  const double value = z.value + bias_.value, lo = z.lo + bias_.lo, hi = z.hi + bias_.hi;
  return {value, lo - kHalfUlp * std::fabs(lo), hi + kHalfUlp * std::fabs(hi)};
}

Interval DepthStage::clamped(const Interval& z) const {
  const auto clamp = [&](double value) { return std::clamp(value, minDepth_, maxDepth_); };
  return {clamp(z.value), clamp(z.lo), clamp(z.hi)};
}

Interval DepthStage::shown(const Interval& z) const {
  if (plain_) return z;
  const Interval raw = biased(z);
  if (!rules_.open) return raw;
  const Interval cut = clamped(raw);
  return {raw.value, std::min({raw.lo, z.lo, cut.lo}), std::max({raw.hi, z.hi, cut.hi})};
}

Interpolated DepthStage::stored(const Interval& z) const {
  if (plain_) {
    // What is inside of the view volume has a depth in range: one that rounding puts outside may be clamped.
    const Interval cut = clamped(z);
    return toFloat({z.value, std::min(z.lo, cut.lo), std::max(z.hi, cut.hi)});
  }
  Interval depth = rules_.error == DeliberateError::DepthClampBeforeBias && clamps_ ? biased(clamped(z)) : biased(z);
  if (clamps_) {
    if (depth.value < minDepth_ || depth.value > maxDepth_) count(Rule::DepthClamp);
    if (rules_.error != DeliberateError::DepthClampBeforeBias) depth = clamped(depth);
  } else if (mayLeaveRange_) {
    // What the interval adds to the exact depth is rounding; only a depth that is really outside is undefined.
    const double below = z.value + bias_.lo, above = z.value + bias_.hi;
    const double slack = std::max(z.hi - z.value, z.value - z.lo);
    const bool undefined = below < minDepth_ - slack || above > maxDepth_ + slack;
    depth.value = std::clamp(depth.value, 0.0, 1.0);
    if (undefined) depth = {depth.value, -kUnbounded, kUnbounded};
  }
  Interpolated result = rasterizer::stored(depth, format_);
  if (unormBits(format_) == 0) return result;
  if (static_cast<double>(result.value) != depth.value) count(Rule::DepthConversion);
  if (rules_.error == DeliberateError::DepthTruncated) {
    const double steps = static_cast<double>((uint64_t{1} << unormBits(format_)) - 1);
    result.value = fromUnorm(std::max(0.0, std::floor(result.bounds.lo * steps) - 2), unormBits(format_));
  }
  if (rules_.error == DeliberateError::DepthTimesPowerOfTwo) {
    const double powerOfTwo = std::ldexp(1.0, static_cast<int>(unormBits(format_)));
    const double k = std::nearbyint(std::clamp(depth.value, 0.0, 1.0) * powerOfTwo);
    result.value = fromUnorm(std::min(k, powerOfTwo - 1), unormBits(format_));
  }
  return result;
}

void DepthStage::count(Rule rule) const {
  if (counts_ != nullptr) ++(*counts_)[rule];
}

}  // namespace rasterdiff::rasterizer
