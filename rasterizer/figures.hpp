// Points and lines of a draw: the primitives themselves, and the edges and corners of triangles in polygon mode LINE or
// POINT. [vk:primsrast-points] [vk:primsrast-lines] [vk:primsrast-polygonmode]
#pragma once

#include "rasterizer/geometry.hpp"
#include "rasterizer/lines/line_style.hpp"
#include "rasterizer/points/square_point.hpp"
#include "rasterizer/vertex_stage.hpp"

namespace rasterdiff::rasterizer {

class FigureMaker {
 public:
  FigureMaker(const Scene& scene, const Rules& rules, const Draw& draw, const VertexStage& stage, const ClipVolume& volume,
              PixelArea area, RuleCounts& counts);

  /// Fills primitive.figures; none where nothing can be drawn.
  void makePoint(Primitive& primitive, const ClipInput& vertex);
  void makeLine(Primitive& primitive, const ClipInput& a, const ClipInput& b);
  /// A triangle in polygon mode LINE or POINT, from its polygon after clipping and culling.
  void makeOutline(Primitive& primitive, const ClipPolygon& polygon);

 private:
  [[nodiscard]] bool pointSurvives(const ClipInput& vertex);
  void addPoint(Primitive& primitive, const ClipPosition& position, RasterVertex vertex, const PointSize& size);
  void addLine(Primitive& primitive, const LineEnds& ends, bool ofPolygon, bool optional);
  [[nodiscard]] PointSize pointSizeOf(uint32_t vertex) const;
  [[nodiscard]] LineStyle lineStyle() const;

  const Scene& scene_;
  const Rules& rules_;
  const Draw& draw_;
  const VertexStage& stage_;
  const ClipVolume& volume_;
  const PixelArea area_;
  RuleCounts& counts_;
  StippleCounter stipple_;
};

}  // namespace rasterdiff::rasterizer
