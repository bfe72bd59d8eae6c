// What the snapped corners of a polygon reach, in 1/256 pixel.
#pragma once

#include <algorithm>

#include "rasterizer/geometry.hpp"

namespace rasterdiff::rasterizer {

struct SubpixelBox {
  SubpixelPosition low, high;

  explicit SubpixelBox(const SubpixelPosition& p) : low(p), high(p) {}

  /// Of a piece of the primitive.
  SubpixelBox(const Primitive& primitive, const SetupTriangle& piece) : SubpixelBox(primitive.polygon[piece.corner[0]].snapped) {
    for (const uint8_t corner : piece.corner) extend(primitive.polygon[corner].snapped);
  }

  /// Of the primitive's whole polygon, which is not empty.
  explicit SubpixelBox(const Primitive& primitive) : SubpixelBox(primitive.polygon[0].snapped) {
    for (const RasterVertex& vertex : primitive.polygon) extend(vertex.snapped);
  }

  void extend(const SubpixelPosition& p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
};

}  // namespace rasterdiff::rasterizer
