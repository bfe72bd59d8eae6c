// Setup of filled triangles: the fan over a polygon, facing, culling, orientation, edge functions.
// [vk:primsrast-polygons-basic]
#pragma once

#include <optional>

#include "rasterizer/geometry.hpp"

namespace rasterdiff::rasterizer {

class PieceMaker {
 public:
  PieceMaker(const State& state, const Rules& rules, RuleCounts& counts) : state_(state), rules_(rules), counts_(counts) {}

  /// Fills primitive.pieces from primitive.polygon. Pieces of zero area draw nothing. `uncutArea`: the double area by which
  /// the triangle was judged before clipping, if it was. [choice:cull-position]
  void makePieces(Primitive& primitive, std::optional<float> uncutArea) const;

  /// Is a triangle with this double area on the screen (y down, any unit) discarded by its facing?
  [[nodiscard]] bool isCulled(double doubleArea) const;
  [[nodiscard]] bool isFaceCulled(bool frontFacing) const;
  [[nodiscard]] bool isFront(double doubleArea) const;

 private:
  const State& state_;
  const Rules& rules_;
  RuleCounts& counts_;
};

}  // namespace rasterdiff::rasterizer
