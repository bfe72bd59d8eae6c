// From draws to snapped, oriented triangles: runs assembly, clipping, viewport and snapping, and hands every primitive to
// a visitor. render, candidates and explain are three visitors of the same geometry.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <vector>

#include "rasterizer/assembly.hpp"
#include "rasterizer/clip.hpp"
#include "rasterizer/edge_function.hpp"
#include "rasterizer/freedoms.hpp"
#include "rasterizer/rule_counts.hpp"
#include "rasterizer/viewport.hpp"

namespace rasterdiff::rasterizer {

/// A vertex of the (clipped) polygon after the viewport transform.
struct RasterVertex {
  FramebufferPosition position;     ///< unsnapped, pixels
  double reciprocalW = 1;
  SubpixelPosition snapped;         ///< nominal
  SubpixelPosition lowest, highest; ///< box of legal placements; = snapped under closed rules
  double deviation = 0;             ///< pixels by which a legal position may differ from `position` in x or y
  double depthError = 0;            ///< bound on the float32 depth's deviation at the vertex
  double relativeWError = 0;        ///< bound on the relative deviation of a float32 clipper's w
  std::array<double, 3> smoothWeights{1, 0, 0}, linearWeights{1, 0, 0};
  bool made = false;                ///< by clipping
};

/// One triangle of the fan over the polygon, oriented so that its double area is positive.
struct SetupTriangle {
  std::array<uint8_t, 3> corner{};      ///< indices into Primitive::polygon, in oriented order
  std::array<EdgeFunction, 3> edges;    ///< edge i runs from corner i to corner i + 1
  bool flipped = false;                 ///< the two last corners were exchanged
  int64_t area = 0;                     ///< double area before orientation, 1/65536 pixel²
  bool frontFacing = false, culled = false;

  /// Is the point (1/256 pixel) inside, or on an edge that owns it?
  [[nodiscard]] bool covers(int64_t px, int64_t py) const {
    return edges[0].covers(px, py) && edges[1].covers(px, py) && edges[2].covers(px, py);
  }
};

class Shape;
class LineCoverage;

/// A line or a point: the primitive itself, or an edge or corner of a triangle in polygon mode LINE or POINT.
struct Figure {
  enum class Kind : uint8_t { Line, Point };
  Kind kind = Kind::Point;
  std::shared_ptr<const Shape> shape;
  RasterVertex a, b;  ///< ends of a line; a point has `a` only. Weights refer to the primitive's vertices.
  Freedom existence = Freedom::None;  ///< why the specification leaves open whether it is drawn at all
  bool nominal = true;                ///< is it drawn where that is open?
  float size = 1;     ///< line width or point size, pixels, as the device draws it
  float smallest = 1, largest = 1;  ///< of a point: sizes that it may have instead under open rules; otherwise that size
  std::shared_ptr<const LineCoverage> solid;  ///< of a stippled line: what it would cover without its pattern
  bool cutsItself = false;  ///< its shape covers nothing outside of the drawing region
  bool frontFacing = true;  ///< of the polygon that it comes from; of a line or point itself
};

struct Primitive {
  uint32_t number = 0;  ///< 1-based over all draws
  const Draw* draw = nullptr;
  AssembledTriangle assembled;
  std::array<ClipPosition, 3> clip;
  bool cut = false;
  bool cutByDistance = false;  ///< by a clip distance among others
  bool folded = false;         ///< snapping folded the cut polygon: CutPolygon decides for all pieces together
  bool reversed = false;       ///< folded: it runs counter-clockwise on the screen, as far as facing is concerned
  bool unprojectable = false;  ///< some w is 0, of a new vertex too: no polygon, and no sample of the target is certain (open rules)
  std::vector<RasterVertex> polygon;
  std::vector<SetupTriangle> pieces;  ///< filled triangles
  std::vector<Figure> figures;        ///< lines and points
  ViewportTransform viewport;         ///< the one the primitive was drawn through
  float minDepth = 0, maxDepth = 1;   ///< of that viewport, as given
  uint32_t viewportIndex = 0;
};

using PrimitiveVisitor = std::function<void(const Primitive&)>;

/// Visits every primitive that has at least one piece (open rules: or may have one), in drawing order. The Primitive is reused between calls.
/// Counts what is decided before rasterization.
void forEachPrimitive(const Scene& scene, const Rules& rules, RuleCounts& counts, const PrimitiveVisitor& visit);

}  // namespace rasterdiff::rasterizer
