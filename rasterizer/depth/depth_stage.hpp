// From interpolated depth to what the depth test sees: bias, clamp, conversion to the attachment's format.
// [vk:primsrast-depthbias] [vk:fragops-depth]
#pragma once

#include "rasterizer/depth/bias.hpp"
#include "rasterizer/depth/format.hpp"
#include "rasterizer/geometry.hpp"

namespace rasterdiff::rasterizer {

/// A depth that is only rounded. [vk:vertexpostproc-clipping] what is inside of the view volume has one in 0..1: one that
/// rounding puts outside may be clamped.
[[nodiscard]] inline Interpolated roundedDepth(const Interval& z) {
  const Interpolated depth = toFloat(z);
  return {depth.value, {std::min(depth.bounds.lo, 1.0F), std::max(depth.bounds.hi, 0.0F)}};
}

class DepthStage {
 public:
  DepthStage(const Scene& scene, const Rules& rules, RuleCounts* counts);

  /// Nothing to do but to round to float32.
  [[nodiscard]] bool isPlain() const { return plain_; }
  [[nodiscard]] bool needsBias() const { return biases_; }

  /// The depth range of the primitive's viewport; no bias.
  void setUp(const Primitive& primitive);
  /// For a triangle, filled.
  void setBias(const BiasInputs& inputs);
  /// For a figure: of a triangle drawn as lines or points, where bias applies; of a line or point, where it may.
  void setFigureBias(const Primitive& primitive, const BiasInputs& inputs);

  /// What FragCoord.z shows: biased, neither clamped nor converted (open rules: or without its bias, or clamped).
  [[nodiscard]] Interval shown(const Interval& z) const;
  [[nodiscard]] Interpolated stored(const Interval& z) const;

 private:
  [[nodiscard]] Interval biased(const Interval& z) const;
  [[nodiscard]] Interval clamped(const Interval& z) const;
  void count(Rule rule) const;

  const State state_;
  const Rules rules_;
  RuleCounts* const counts_;
  const DepthFormat format_;
  const bool biases_, clamps_, mayLeaveRange_, plain_;
  double minDepth_ = 0, maxDepth_ = 1;
  Interval bias_;
};

}  // namespace rasterdiff::rasterizer
