// Points and lines of a draw: the primitives themselves, and the edges and corners of triangles in polygon mode LINE or
// POINT. [vk:primsrast-points] [vk:primsrast-lines] [vk:primsrast-polygonmode]
#pragma once

#include "rasterizer/drawing_region.hpp"
#include "rasterizer/geometry.hpp"
#include "rasterizer/lines/line_style.hpp"
#include "rasterizer/points/square_point.hpp"
#include "rasterizer/vertex_stage.hpp"

namespace rasterdiff::rasterizer {

/// Of a polygon's fan, a bit a triangle: whether its share of edges and corners is left out, and which side it shows.
struct FanSides {
  uint32_t culled = 0, front = 0;
};

class FigureMaker {
 public:
  FigureMaker(const Scene& scene, const Rules& rules, const Draw& draw, const VertexStage& stage, const ClipVolume& volume,
              const DrawingRegion& region, RuleCounts& counts);

  /// Fills primitive.figures; none where nothing can be drawn.
  void makePoint(Primitive& primitive, const ClipInput& vertex);
  void makeLine(Primitive& primitive, const ClipInput& a, const ClipInput& b);
  /// The corner or edge `k` of a triangle as a point or line of its own. [choice:cut-outline]
  void makeCorner(Primitive& primitive, const ClipInput& vertex, size_t k);
  void makeEdge(Primitive& primitive, const ClipInput& a, const ClipInput& b, size_t k);
  /// A triangle in polygon mode LINE or POINT, from its polygon after clipping. `sideIsFree`: whether it is culled at all depends on
  /// legal snapping.
  void makeOutline(Primitive& primitive, const ClipPolygon& polygon, const FanSides& sides, bool sideIsFree);

 private:
  /// Is a figure drawn, what leaves that open, and which side of a polygon does it show?
  struct Existence {
    bool nominal = true;
    Freedom freedom = Freedom::None;
    bool frontFacing = true;
  };

  [[nodiscard]] bool pointSurvives(const ClipInput& vertex);
  void addPoint(Primitive& primitive, const ClipVertex& clip, RasterVertex vertex, const PointSize& size,
                const Existence& existence);
  void addLine(Primitive& primitive, const LineEnds& ends, bool ofPolygon, const Existence& existence);
  void makeLine(Primitive& primitive, const ClipInput& a, const ClipInput& b, size_t first, bool ofPolygon);
  [[nodiscard]] PointSize pointSizeOf(uint32_t vertex) const;
  /// Sizes of a made corner are interpolated as any other output is.
  [[nodiscard]] PointSize cornerSize(const Primitive& primitive, const RasterVertex& corner) const;
  [[nodiscard]] LineStyle lineStyle() const;

  const Scene& scene_;
  const Rules& rules_;
  const Draw& draw_;
  const VertexStage& stage_;
  const ClipVolume& volume_;
  const DrawingRegion region_;
  RuleCounts& counts_;
  StippleCounter stipple_;
};

}  // namespace rasterdiff::rasterizer
