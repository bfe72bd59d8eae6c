// The fragments of one sample, one after another, through the fragment operations: what became of each.
// [vk:fragops]
#pragma once

#include "rasterizer/explain.hpp"
#include "rasterizer/fragment/shader_mask.hpp"
#include "rasterizer/interpolation.hpp"

namespace rasterdiff::rasterizer {

class FragmentReplay {
 public:
  FragmentReplay(const Scene& scene, const Rules& rules, SampleQuery query, SubpixelPosition position);

  /// The next piece or figure in drawing order that covers the sample inside the scissor.
  template <class Part>
  [[nodiscard]] FragmentFate next(const Primitive& primitive, const Part& part) {
    values_.setUp(primitive, part);
    shaderMask_.begin(*primitive.draw);
    return pass(primitive.number);
  }

 private:
  FragmentFate pass(uint32_t primitive);

  const Scene& scene_;
  const SampleQuery query_;
  const double x_, y_;  // of the sample, pixels
  PieceValues values_;
  ShaderMask shaderMask_;
  std::vector<Interpolated> buffer_;
  float stored_ = 0;
  uint32_t owner_ = 0;
};

}  // namespace rasterdiff::rasterizer
