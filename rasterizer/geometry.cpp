#include "rasterizer/geometry.hpp"

#include <utility>

#include "rasterizer/vertex_stage.hpp"

namespace rasterdiff::rasterizer {
namespace {

bool culledBy(CullMode mode, bool frontFacing) {
  const auto bits = static_cast<uint32_t>(mode);
  const auto face = static_cast<uint32_t>(frontFacing ? CullMode::FRONT : CullMode::BACK);
  return (bits & face) != 0;
}

TieOwner tieOwner(const Rules& rules) {
  return rules.error == DeliberateError::TieOwnerBottomRight ? TieOwner::BottomRight : rules.choices.tieOwner;
}

void setTies(SetupTriangle& triangle, DeliberateError error) {
  if (error != DeliberateError::TiesCoveredByBoth && error != DeliberateError::TiesCoveredByNone) return;
  for (EdgeFunction& edge : triangle.edges) edge.ownsTies = error == DeliberateError::TiesCoveredByBoth;
}

class PieceMaker {
 public:
  PieceMaker(const State& state, const Rules& rules, RuleCounts& counts)
      : state_(state), rules_(rules), counts_(counts) {}

  // Fan over the polygon from its first vertex; pieces of zero area draw nothing.
  // [vk:primsrast-polygons-basic] facing is the sign of a = -doubleArea / 2; a zero area is back-facing.
  void makePieces(Primitive& primitive) const {
    primitive.pieces.clear();
    for (size_t i = 2; i < primitive.polygon.size(); ++i) {
      SetupTriangle triangle;
      triangle.corner = {0, static_cast<uint8_t>(i - 1), static_cast<uint8_t>(i)};
      const auto at = [&](size_t k) { return primitive.polygon[triangle.corner[k]].snapped; };
      triangle.area = doubleArea(at(0), at(1), at(2));
      triangle.frontFacing = isFront(triangle.area);
      triangle.culled = culledBy(state_.cullMode, triangle.frontFacing);
      if (state_.cullMode == CullMode::FRONT || state_.cullMode == CullMode::BACK) ++counts_[Rule::Facing];
      if (triangle.culled) ++counts_[Rule::Culling];
      if (triangle.area == 0) continue;
      if (triangle.area < 0) {
        std::swap(triangle.corner[1], triangle.corner[2]);
        triangle.flipped = true;
      }
      const TieOwner owner = tieOwner(rules_);
      for (size_t k = 0; k < 3; ++k) triangle.edges[k] = edgeFunction(at(k), at((k + 1) % 3), owner);
      setTies(triangle, rules_.error);
      primitive.pieces.push_back(triangle);
    }
  }

 private:
  [[nodiscard]] bool isFront(int64_t area) const {
    const bool counterClockwise = area < 0;  // Vulkan's a > 0
    const bool clockwise = area > 0;
    const bool front = state_.frontFace == FrontFace::COUNTER_CLOCKWISE ? counterClockwise : clockwise;
    return front != (rules_.error == DeliberateError::SwappedWinding && area != 0);
  }

  const State& state_;
  const Rules& rules_;
  RuleCounts& counts_;
};

}  // namespace

void forEachPrimitive(const Scene& scene, const Rules& rules, RuleCounts& counts, const PrimitiveVisitor& visit) {
  const VertexStage stage = vertexStage(scene, rules);
  const PieceMaker pieceMaker(scene.state, rules, counts);
  const bool negativeOneToOne = scene.state.negativeOneToOne;
  Primitive primitive;
  ClipPolygon clipped;
  std::vector<RasterVertex> vertices;  // of one draw, once each
  std::vector<unsigned> outcodes;
  for (const Draw& draw : scene.draws) {
    vertices.clear();
    outcodes.clear();
    for (const ClipPosition& position : draw.positions) {
      outcodes.push_back(outcode(position, negativeOneToOne, rules.error));
      vertices.push_back(outcodes.back() == 0 && position.w > 0 ? stage.original(position) : RasterVertex{});
    }
    primitive.draw = &draw;
    for (const AssembledTriangle& assembled : assemble(draw, scene.state, rules.error)) {
      ++primitive.number;
      primitive.assembled = assembled;
      for (size_t i = 0; i < 3; ++i) primitive.clip[i] = draw.positions[assembled.vertices[i]];
      const auto code = [&](size_t i) { return outcodes[assembled.vertices[i]]; };
      primitive.polygon.clear();
      primitive.unprojectable = false;
      primitive.cut = (code(0) | code(1) | code(2)) != 0;
      if (!primitive.cut) {
        for (size_t i = 0; i < 3; ++i) {
          RasterVertex vertex = vertices[assembled.vertices[i]];
          vertex.smoothWeights = vertex.linearWeights = {};
          vertex.smoothWeights[i] = vertex.linearWeights[i] = 1;
          primitive.polygon.push_back(vertex);
        }
        // Inside the volume w >= |x|, so w = 0 means the origin of clip space, which has no place on the screen.
        primitive.unprojectable = primitive.clip[0].w <= 0 || primitive.clip[1].w <= 0 || primitive.clip[2].w <= 0;
        if (primitive.unprojectable) {
          primitive.polygon.clear();
          primitive.pieces.clear();
          if (rules.open) visit(primitive);
          continue;
        }
      } else {
        ++counts[Rule::ViewVolume];
        if ((code(0) & code(1) & code(2)) != 0) continue;
        if (clipTriangle(primitive.clip, rules, negativeOneToOne, clipped) == ClipOutcome::Rejected) continue;
        bool projectable = clipped.size >= 3;
        for (int i = 0; i < clipped.size; ++i) projectable = projectable && clipped.vertices[static_cast<size_t>(i)].position[3] > 0;
        if (!projectable) continue;
        for (int i = 0; i < clipped.size; ++i) {
          primitive.polygon.push_back(stage.clipped(clipped.vertices[static_cast<size_t>(i)]));
        }
      }
      pieceMaker.makePieces(primitive);
      if (!primitive.pieces.empty() || rules.open) visit(primitive);
    }
  }
}

}  // namespace rasterdiff::rasterizer
