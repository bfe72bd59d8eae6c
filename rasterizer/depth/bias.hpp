// Depth bias: o = dbclamp(m · depthBiasSlopeFactor + r · depthBiasConstantFactor), with all that is legal for m and r.
// Where a primitive's slope and depths come from is the caller's business. [vk:primsrast-depthbias-computation]
#pragma once

#include "rasterizer/fragment/triangle_plane.hpp"
#include "rasterizer/rules.hpp"
#include "scene/scene.hpp"

namespace rasterdiff::rasterizer {

/// What the bias of one primitive depends on.
struct BiasInputs {
  Gradient slope;        ///< of depth over the screen
  Interval largestDepth; ///< the greatest |z| over the primitive's vertices
};

/// r for a fixed-point format with `bits`, or for a float primitive with these depths (2^(e - 23), e the exponent of
/// the greatest |z|; 0 for a depth of 0).
[[nodiscard]] Interval smallestDifference(uint32_t bits, const Interval& largestDepth, const Rules& rules);

/// o for a triangle. Under open rules m is anything from the larger component of the gradient to its length; a profile
/// takes the larger component.
[[nodiscard]] Interval depthBias(const State& state, uint32_t bits, const Rules& rules, const BiasInputs& inputs);

}  // namespace rasterdiff::rasterizer
