// Which samples a polygon covers that snapping may have folded: what clipping left, or the outline of a line.
// Where it is convex, the triangles of its fan say the same and faster. [choice:cut-fill] [vk:primsrast-polygons-basic]
#pragma once

#include <span>
#include <vector>

#include "rasterizer/geometry.hpp"

namespace rasterdiff::rasterizer {

/// Twice the area that the corners wind around, 1/65536 pixel²; sign as in doubleArea of a triangle.
[[nodiscard]] int64_t doubleArea(std::span<const RasterVertex> polygon);

/// Does `fill` cover other samples than the fan's triangles together, or cover some twice? Fan: never.
[[nodiscard]] bool isFolded(std::span<const RasterVertex> polygon, CutFill fill);

/// Each row from its last left to its last right edge, edges taken in order.
class SpanFill {
 public:
  /// `reversed`: the corners are meant to run counter-clockwise on the screen.
  SpanFill(std::span<const SubpixelPosition> corners, bool reversed, TieRule rule);

  [[nodiscard]] bool covers(int64_t px, int64_t py, bool& tie) const;

 private:
  std::vector<EdgeFunction> edges_;
  bool ownsTop_;
};

/// The fill of a folded primitive.
class CutPolygon {
 public:
  /// `primitive` is folded and has its pieces.
  CutPolygon(const Primitive& primitive, const Rules& rules);

  /// The piece that draws the sample: an index into Primitive::pieces. None: it is not covered.
  [[nodiscard]] std::optional<size_t> pieceAt(int64_t px, int64_t py) const;

 private:
  const Primitive& primitive_;
  bool reversed_;
  std::optional<SpanFill> spans_;
};

}  // namespace rasterdiff::rasterizer
