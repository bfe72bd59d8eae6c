// Fragments that user clip distances keep where a device does not cut primitives by them, but drops whole fragments by the
// distance that it interpolates in float32 to the pixel's centre. Everything else cuts (clip.hpp). [choice:clip-distances]
#pragma once

#include <vector>

#include "rasterizer/vertex_stage.hpp"

namespace rasterdiff::rasterizer {

/// Closed rules whose answer is Fragments.
[[nodiscard]] bool leavesDistancesToFragments(const Rules& rules);

class KeptFragments {
 public:
  /// Of a filled triangle.
  KeptFragments(const Primitive& primitive, const VertexStage& stage);
  /// Of a line or point: the primitive itself, or an edge or corner of a triangle, which counts as it was before clipping.
  KeptFragments(const Primitive& primitive, const Figure& figure, const VertexStage& stage);

  /// Is none of the distances, or what they become where the plane of 1/w is negative beyond the primitive, below 0?
  [[nodiscard]] bool keeps(int32_t x, int32_t y) const;

 private:
  /// c + y b + x a, from the anchor, in float32 in this order.
  struct Plane {
    float a = 0, b = 0, c = 0;
    [[nodiscard]] float at(float x, float y) const { return x * a + (c + y * b); }
  };
  void add(const Draw& draw, const std::array<uint32_t, 3>& vertices, const std::array<std::array<float, 3>, 3>& matrix);

  float x0_ = 0, y0_ = 0;  ///< of the first vertex, pixels from the centre of the target's first pixel
  Plane reciprocalW_;
  std::vector<Plane> planes_;  ///< of each distance, divided by w
};

}  // namespace rasterdiff::rasterizer
