#include "rasterizer/geometry.hpp"

#include <algorithm>

#include "rasterizer/drawing_region.hpp"
#include "rasterizer/facing_freedom.hpp"
#include "rasterizer/figures.hpp"
#include "rasterizer/piece_maker.hpp"
#include "rasterizer/target_area.hpp"
#include "rasterizer/uncut_triangle.hpp"
#include "rasterizer/vertex_stage.hpp"

namespace rasterdiff::rasterizer {
namespace {

class DrawGeometry {
 public:
  DrawGeometry(const Scene& scene, const Rules& rules, const Draw& draw, RuleCounts& counts, const PrimitiveVisitor& visit)
      : scene_(scene), rules_(rules), draw_(draw), counts_(counts), visit_(visit),
        viewportIndex_(rules.error == DeliberateError::ViewportIndexIgnored ? 0 : draw.viewportIndex),
        stage_(vertexStage(scene, rules, viewportIndex_)),
        volume_(clipVolume(scene.state, draw, rules.error)),
        pieceMaker_(scene.state, rules, counts),
        figureMaker_(scene, rules, draw, stage_, volume_, drawingRegion(scene, viewportIndex_, rules), counts) {
    const Viewport& viewport = viewportOf(scene, viewportIndex_);
    const Viewport whole{0, 0, static_cast<float>(scene.target.width), static_cast<float>(scene.target.height), 0, 1};
    if (viewport != whole) counts_[Rule::ViewportMap] += draw.positions.size();
    const bool shared = draw.indices || scene.state.topology != PrimitiveTopology::TRIANGLE_LIST;
    outcodes_.reserve(draw.positions.size());
    if (shared) vertices_.reserve(draw.positions.size());
    for (uint32_t i = 0; i < draw.positions.size(); ++i) {
      if (draw.positions[i].w != 1) ++counts_[Rule::Division];
      outcodes_.push_back(outcode(input(i), volume_));
      someClipped_ = someClipped_ || outcodes_.back() != 0;
      if (shared) vertices_.push_back(projected(i));
    }
    volume_.wideSides = rules.choices.pointClip == PointClip::SidesIgnored && scene.furtherViewports.empty() &&
                        scene.state.polygonMode == PolygonMode::POINT;
    primitive_.draw = &draw;
    primitive_.viewport = stage_.viewport;
    primitive_.minDepth = viewport.minDepth;
    primitive_.maxDepth = viewport.maxDepth;
    primitive_.viewportIndex = viewportIndex_;
  }

  uint32_t run(uint32_t number) {
    const std::vector<AssembledTriangle> all = assemble(draw_, scene_.state, rules_.error);
    for (size_t i = 0; i < all.size(); ++i) {
      const size_t at = rules_.error == DeliberateError::DrawBackward ? all.size() - 1 - i : i;
      const AssembledTriangle& assembled = all[at];
      primitive_.number = number + static_cast<uint32_t>(at) + 1;
      primitive_.assembled = assembled;
      primitive_.polygon.clear();
      primitive_.pieces.clear();
      primitive_.figures.clear();
      primitive_.cut = primitive_.cutByDistance = primitive_.unprojectable = primitive_.folded = primitive_.reversed = false;
      primitive_.frontFacing = true;
      for (size_t k = 0; k < 3; ++k) primitive_.clip[k] = draw_.positions[assembled.vertices[k]];
      if (culledByDistance()) {
        ++counts_[Rule::UserDistance];
        continue;
      }
      switch (assembled.count) {
        case 1: figureMaker_.makePoint(primitive_, input(assembled.vertices[0])); break;
        case 2: figureMaker_.makeLine(primitive_, input(assembled.vertices[0]), input(assembled.vertices[1])); break;
        default: makeTriangle();
      }
      const bool mayDraw = !primitive_.pieces.empty() || !primitive_.figures.empty() || primitive_.unprojectable;
      if (mayDraw || (rules_.open && primitive_.polygon.size() >= 3)) visit_(primitive_);
    }
    return number + static_cast<uint32_t>(all.size());
  }

 private:
  [[nodiscard]] ClipInput input(uint32_t vertex) const {
    const size_t count = volume_.distances;
    return {draw_.positions[vertex], std::span(draw_.clipDistances).subspan(vertex * size_t{draw_.clipDistanceCount}, count)};
  }

  [[nodiscard]] RasterVertex projected(uint32_t vertex) const {
    const ClipPosition& position = draw_.positions[vertex];
    return outcodes_[vertex] == 0 && position.w > 0 ? stage_.original(position) : RasterVertex{};
  }

  // [vk:vertexpostproc-clipping] discarded if some cull distance is negative at all vertices.
  [[nodiscard]] bool culledByDistance() const {
    if (rules_.error == DeliberateError::CullDistanceIgnored) return false;
    const AssembledTriangle& assembled = primitive_.assembled;
    for (uint32_t d = 0; d < draw_.cullDistanceCount; ++d) {
      const auto negative = [&](uint32_t k) {
        return draw_.cullDistances[size_t{assembled.vertices[k]} * draw_.cullDistanceCount + d] < 0;
      };
      uint32_t count = 0;
      for (uint32_t k = 0; k < assembled.count; ++k) count += negative(k) ? 1U : 0U;
      const uint32_t enough = rules_.error == DeliberateError::CullDistanceAny ? 1 : assembled.count;
      if (count >= enough) return true;
    }
    return false;
  }

  void makeTriangle() {
    const AssembledTriangle& assembled = primitive_.assembled;
    const auto code = [&](size_t i) { return outcodes_[assembled.vertices[i]]; };
    const unsigned any = code(0) | code(1) | code(2);
    primitive_.cut = any != 0;
    countUnclippedDepth();
    if (scene_.state.polygonMode != PolygonMode::FILL && !rules_.open && rules_.choices.cutOutline == CutOutline::Uncut) {
      return uncutOutline();
    }
    if (primitive_.cut) {
      if (rules_.error == DeliberateError::FlatAfterCut) primitive_.assembled.provoking = assembled.vertices[1];
      primitive_.cutByDistance = (any >> kVolumePlanes) != 0;
      ++counts_[primitive_.cutByDistance ? Rule::UserDistance : Rule::ViewVolume];
      if ((code(0) & code(1) & code(2)) != 0) return;
      if (!cutPolygon()) return;
    } else {
      wholePolygon();
      // Inside the volume w >= |x|, so w = 0 means the origin of clip space, which has no place on the screen.
      const auto& clip = primitive_.clip;
      if (clip[0].w <= 0 || clip[1].w <= 0 || clip[2].w <= 0) {
        primitive_.polygon.clear();
        primitive_.unprojectable = rules_.open;
        return;
      }
    }
    std::optional<float> uncutArea;
    if (rules_.choices.cullPosition == CullPosition::UncutFloat32) uncutArea = uncutDoubleArea<float>(primitive_.clip, stage_);
    pieceMaker_.makePieces(primitive_, uncutArea);
    if (!primitive_.cut) takeWholeAsClipped();
    if (rules_.choices.cullPosition == CullPosition::AlsoFloat && someClipped_) {
      for (SetupTriangle& piece : primitive_.pieces) piece.culled = piece.culled || pieceMaker_.isCulled(areaInFloat(piece.corner, piece.flipped));
    }
    if (scene_.state.polygonMode != PolygonMode::FILL && rules_.error != DeliberateError::PolygonModeIgnored) outline();
  }

  void countUnclippedDepth() {
    if (volume_.nearAndFar) return;
    const auto outside = [&](const ClipPosition& p) { return p.z > p.w || p.z < (volume_.nearAtMinusW ? -p.w : 0); };
    if (std::any_of(primitive_.clip.begin(), primitive_.clip.end(), outside)) ++counts_[Rule::DepthClip];
  }

  void wholePolygon() {
    for (size_t i = 0; i < 3; ++i) {
      const uint32_t at = primitive_.assembled.vertices[i];
      RasterVertex vertex = vertices_.empty() ? projected(at) : vertices_[at];
      vertex.smoothWeights = vertex.linearWeights = {};
      vertex.smoothWeights[i] = vertex.linearWeights[i] = 1;
      primitive_.polygon.push_back(vertex);
    }
  }

  bool cutPolygon() {
    const auto& v = primitive_.assembled.vertices;
    const std::array<ClipInput, 3> triangle{input(v[0]), input(v[1]), input(v[2])};
    if (clipTriangle(triangle, rules_.choices.clipArithmetic, volume_, clipped_) == ClipOutcome::Rejected) return false;
    if (clipped_.size < 3) return false;
    for (int i = 0; i < clipped_.size; ++i) {
      if (clipped_.vertices[static_cast<size_t>(i)].position[3] > 0) continue;
      // The cut went through the origin of clip space: without depth clipping a triangle may contain the eye.
      primitive_.unprojectable = rules_.open;
      return false;
    }
    for (int i = 0; i < clipped_.size; ++i) {
      primitive_.polygon.push_back(stage_.clipped(clipped_.vertices[static_cast<size_t>(i)]));
    }
    return true;
  }

  void takeWholeAsClipped() {
    clipped_.size = 3;
    for (size_t i = 0; i < 3; ++i) {
      const ClipPosition& p = primitive_.clip[i];
      clipped_.vertices[i] = ClipVertex{};
      clipped_.vertices[i].position = {p.x, p.y, p.z, p.w};
    }
  }

  // Double area by differences, products and their difference in float32, of positions before snapping.
  [[nodiscard]] double areaInFloat(const std::array<uint8_t, 3>& corner, bool flipped) const {
    const auto at = [&](size_t k) { return floatPosition(stage_, clipped_.vertices[corner[k]]); };
    const FloatPosition a = at(0), b = at(flipped ? 2 : 1), c = at(flipped ? 1 : 2);
    const float ex = a.x - c.x, ey = a.y - c.y, fx = b.x - c.x, fy = b.y - c.y;
    return static_cast<double>(ex * fy - ey * fx);
  }

  // [choice:cull-position] each triangle of the fan on its own; the first that is left gives the facing.
  uint32_t facesInFloat() {
    uint32_t culled = 0;
    for (size_t i = primitive_.polygon.size() - 1; i >= 2; --i) {
      const double area = areaInFloat({0, static_cast<uint8_t>(i - 1), static_cast<uint8_t>(i)}, false);
      if (pieceMaker_.isCulled(area)) {
        culled |= uint32_t{1} << (i - 2);
      } else {
        primitive_.frontFacing = pieceMaker_.isFront(area);
      }
    }
    return culled;
  }

  // [choice:cut-outline] edges or corners of the triangle, each clipped for itself.
  void uncutOutline() {
    const bool corners = scene_.state.polygonMode == PolygonMode::POINT;
    if (rules_.choices.cullPosition == CullPosition::UncutFloat32) {
      const float area = corners ? clipDeterminant(primitive_.clip) : uncutDoubleArea<float>(primitive_.clip, stage_);
      primitive_.frontFacing = pieceMaker_.isFront(static_cast<double>(area)) || (area == 0 && !corners);
    } else {
      primitive_.frontFacing = pieceMaker_.isFront(uncutDoubleArea<double>(primitive_.clip, stage_));
    }
    if (pieceMaker_.isFaceCulled(primitive_.frontFacing)) return;
    const auto& v = primitive_.assembled.vertices;
    for (size_t i = 0; i < 3; ++i) {
      if (corners) {
        figureMaker_.makeCorner(primitive_, input(v[i]), i);
      } else {
        figureMaker_.makeEdge(primitive_, input(v[i]), input(v[(i + 1) % 3]), i);
      }
    }
  }

  // [vk:primsrast-polygonmode] edges or corners of what clipping and culling left.
  void outline() {
    // [vk:primsrast-polygons-basic] without area it is back-facing.
    bool culled = scene_.state.cullMode != CullMode::NONE && scene_.state.cullMode != CullMode::FRONT;
    primitive_.frontFacing = false;
    if (!primitive_.pieces.empty()) {
      culled = primitive_.pieces.front().culled;
      primitive_.frontFacing = primitive_.pieces.front().frontFacing;
    } else if (rules_.error == DeliberateError::ZeroAreaFront) {
      culled = scene_.state.cullMode != CullMode::NONE && scene_.state.cullMode != CullMode::BACK;
      primitive_.frontFacing = true;
    }
    uint32_t dropped = culled ? ~uint32_t{0} : 0;
    if (rules_.choices.cullPosition == CullPosition::AlsoFloat) dropped = facesInFloat();
    const bool oneSideIsCulled = scene_.state.cullMode == CullMode::FRONT || scene_.state.cullMode == CullMode::BACK;
    figureMaker_.makeOutline(primitive_, clipped_, dropped, rules_.open && oneSideIsCulled && sideIsFree(primitive_));
    primitive_.pieces.clear();
    primitive_.polygon.clear();
  }

  const Scene& scene_;
  const Rules& rules_;
  const Draw& draw_;
  RuleCounts& counts_;
  const PrimitiveVisitor& visit_;
  const uint32_t viewportIndex_;
  const VertexStage stage_;
  ClipVolume volume_;
  const PieceMaker pieceMaker_;
  FigureMaker figureMaker_;
  Primitive primitive_;
  ClipPolygon clipped_;
  std::vector<RasterVertex> vertices_;  // of the draw, once each; empty where no two primitives share any
  std::vector<unsigned> outcodes_;
  bool someClipped_ = false;
};

}  // namespace

void forEachPrimitive(const Scene& scene, const Rules& rules, RuleCounts& counts, const PrimitiveVisitor& visit) {
  uint32_t number = 0;
  for (const Draw& draw : scene.draws) number = DrawGeometry(scene, rules, draw, counts, visit).run(number);
}

}  // namespace rasterdiff::rasterizer
