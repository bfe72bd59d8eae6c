#include "rasterizer/geometry.hpp"

#include <algorithm>

#include "rasterizer/drawing_region.hpp"
#include "rasterizer/facing_freedom.hpp"
#include "rasterizer/figures.hpp"
#include "rasterizer/geometry_parts.hpp"
#include "rasterizer/kept_fragments.hpp"
#include "rasterizer/parallel.hpp"
#include "rasterizer/piece_maker.hpp"
#include "rasterizer/target_area.hpp"
#include "rasterizer/uncut_triangle.hpp"
#include "rasterizer/vertex_stage.hpp"

namespace rasterdiff::rasterizer {
namespace {

// [choice:clip-distances] Fragments: nothing is cut by them here (kept_fragments.hpp).
ClipVolume volumeOf(const Scene& scene, const Draw& draw, const Rules& rules) {
  ClipVolume volume = clipVolume(scene.state, draw, rules.error);
  if (leavesDistancesToFragments(rules)) volume.distances = 0;
  return volume;
}

/// What all primitives of one draw share, whichever thread makes them: its stages, its vertices, its assembly.
struct DrawVertices {
  DrawVertices(const Scene& scene, const Rules& rules, const Draw& given)
      : draw(given), viewportIndex(rules.error == DeliberateError::ViewportIndexIgnored ? 0 : given.viewportIndex),
        stage(vertexStage(scene, rules, viewportIndex)), volume(volumeOf(scene, given, rules)),
        shared(given.indices || scene.state.topology != PrimitiveTopology::TRIANGLE_LIST),
        assembled(assemble(given, scene.state, rules.error)), outcodes(given.positions.size()) {}

  /// Of which nothing is made before it is asked for.
  DrawVertices(const Scene& scene, const Rules& rules, const Draw& given, bool clipped)
      : draw(given), viewportIndex(given.viewportIndex), stage(vertexStage(scene, rules, viewportIndex)), volume(volumeOf(scene, given, rules)),
        shared(false), someClipped(clipped) {}

  /// Projects vertices [first, end), each at most once.
  void project(uint32_t first, uint32_t end, std::vector<RasterVertex>& to, RuleCounts& counts) {
    if (shared) to.reserve(end - first);
    for (uint32_t i = first; i < end; ++i) {
      if (draw.positions[i].w != 1) ++counts[Rule::Division];
      outcodes[i] = outcode(input(i), volume);
      if (shared) to.push_back(projected(i));
    }
  }

  [[nodiscard]] ClipInput input(uint32_t vertex) const {
    const size_t count = volume.distances;
    return {draw.positions[vertex], std::span(draw.clipDistances).subspan(vertex * size_t{draw.clipDistanceCount}, count)};
  }

  [[nodiscard]] unsigned code(uint32_t vertex) const { return outcodes.empty() ? outcode(input(vertex), volume) : outcodes[vertex]; }

  [[nodiscard]] RasterVertex projected(uint32_t vertex) const {
    const ClipPosition& position = draw.positions[vertex];
    return code(vertex) == 0 && position.w > 0 ? stage.original(position) : RasterVertex{};
  }

  [[nodiscard]] RasterVertex at(uint32_t vertex) const {
    return shared ? parts[vertex / partSize][vertex % partSize] : projected(vertex);
  }

  const Draw& draw;
  const uint32_t viewportIndex;
  const VertexStage stage;
  ClipVolume volume;
  const bool shared;  // primitives may have vertices in common: each is projected once
  const std::vector<AssembledTriangle> assembled;
  std::vector<unsigned> outcodes;
  std::vector<std::vector<RasterVertex>> parts;  // of partSize vertices each, one after the other
  uint32_t partSize = 1;
  bool someClipped = false;
};

/// The vertices of one draw, by as many threads as there are counts.
std::unique_ptr<DrawVertices> makeVertices(const Scene& scene, const Rules& rules, const Draw& draw, std::span<RuleCounts> counts) {
  auto all = std::make_unique<DrawVertices>(scene, rules, draw);
  if (!isWholeTarget(scene, all->viewportIndex)) counts[0][Rule::ViewportMap] += draw.positions.size();
  const auto threads = static_cast<uint32_t>(counts.size()), size = static_cast<uint32_t>(draw.positions.size());
  all->partSize = std::max(1U, (size + threads - 1) / threads);
  all->parts.resize(threads);
  inParallel(threads, [&](unsigned k) {
    const uint32_t first = std::min(size, k * all->partSize);
    all->project(first, std::min(size, first + all->partSize), all->parts[k], counts[k]);
  });
  all->someClipped = std::ranges::any_of(all->outcodes, [](unsigned code) { return code != 0; });
  all->volume.wideSides = rules.choices.pointClip == PointClip::SidesIgnored && scene.furtherViewports.empty() &&
                          scene.state.polygonMode == PolygonMode::POINT;
  return all;
}

class DrawGeometry {
 public:
  DrawGeometry(const Scene& scene, const Rules& rules, const DrawVertices& vertices, RuleCounts& counts, const PrimitiveVisitor& visit)
      : scene_(scene), rules_(rules), draw_(vertices.draw), all_(vertices), counts_(counts), visit_(visit),
        stage_(vertices.stage), volume_(vertices.volume), someClipped_(vertices.someClipped),
        pieceMaker_(scene.state, rules, counts),
        figureMaker_(scene, rules, draw_, stage_, volume_, drawingRegion(scene, vertices.viewportIndex, rules), counts) {
    const Viewport& viewport = viewportOf(scene, vertices.viewportIndex);
    primitive_.draw = &draw_;
    primitive_.viewport = stage_.viewport;
    primitive_.minDepth = viewport.minDepth;
    primitive_.maxDepth = viewport.maxDepth;
    primitive_.viewportIndex = vertices.viewportIndex;
  }

  /// Primitives [first, end) of the draw, in drawing order; `number`: primitives of earlier draws.
  void run(uint32_t number, size_t first, size_t end) {
    const std::vector<AssembledTriangle>& all = all_.assembled;
    for (size_t i = first; i < end; ++i) {
      const size_t at = rules_.error == DeliberateError::DrawBackward ? all.size() - 1 - i : i;
      make(number + static_cast<uint32_t>(at) + 1, all[at]);
    }
  }

  void make(uint32_t number, const AssembledTriangle& assembled) {
    primitive_.number = number;
    primitive_.assembled = assembled;
    primitive_.polygon.clear();
    primitive_.pieces.clear();
    primitive_.figures.clear();
    primitive_.cut = primitive_.cutByDistance = primitive_.unprojectable = primitive_.folded = primitive_.reversed = false;
    for (size_t k = 0; k < 3; ++k) primitive_.clip[k] = draw_.positions[assembled.vertices[k]];
    if (culledByDistance()) {
      ++counts_[Rule::UserDistance];
      return;
    }
    switch (assembled.count) {
      case 1: figureMaker_.makePoint(primitive_, input(assembled.vertices[0])); break;
      case 2: figureMaker_.makeLine(primitive_, input(assembled.vertices[0]), input(assembled.vertices[1])); break;
      default: makeTriangle();
    }
    const bool mayDraw = !primitive_.pieces.empty() || !primitive_.figures.empty() || primitive_.unprojectable;
    if (mayDraw || (rules_.open && primitive_.polygon.size() >= 3)) visit_(primitive_);
  }

 private:
  [[nodiscard]] ClipInput input(uint32_t vertex) const { return all_.input(vertex); }

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
    const auto code = [&](size_t i) { return all_.code(assembled.vertices[i]); };
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
      RasterVertex vertex = all_.at(at);
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

  // [choice:cull-position] each triangle of the fan on its own.
  FanSides sidesInFloat() const {
    FanSides sides;
    for (size_t i = 2; i < primitive_.polygon.size(); ++i) {
      const double area = areaInFloat({0, static_cast<uint8_t>(i - 1), static_cast<uint8_t>(i)}, false);
      sides.culled |= uint32_t{pieceMaker_.isCulled(area)} << (i - 2);
      sides.front |= uint32_t{pieceMaker_.isFront(area)} << (i - 2);
    }
    return sides;
  }

  // [choice:cut-outline] edges or corners of the triangle, each clipped for itself.
  void uncutOutline() {
    const bool corners = scene_.state.polygonMode == PolygonMode::POINT;
    bool front = false;
    if (rules_.choices.cullPosition == CullPosition::UncutFloat32) {
      const float area = corners ? clipDeterminant(primitive_.clip) : uncutDoubleArea<float>(primitive_.clip, stage_);
      front = pieceMaker_.isFront(static_cast<double>(area)) || (area == 0 && !corners);
    } else {
      front = pieceMaker_.isFront(uncutDoubleArea<double>(primitive_.clip, stage_));
    }
    if (pieceMaker_.isFaceCulled(front)) return;
    const auto& v = primitive_.assembled.vertices;
    for (size_t i = 0; i < 3; ++i) {
      if (corners) {
        figureMaker_.makeCorner(primitive_, input(v[i]), i);
      } else {
        figureMaker_.makeEdge(primitive_, input(v[i]), input(v[(i + 1) % 3]), i);
      }
    }
    for (Figure& figure : primitive_.figures) figure.frontFacing = front;
  }

  // [vk:primsrast-polygonmode] edges or corners of what clipping and culling left.
  void outline() {
    // [vk:primsrast-polygons-basic] without area it is back-facing.
    bool culled = scene_.state.cullMode != CullMode::NONE && scene_.state.cullMode != CullMode::FRONT;
    bool front = false;
    if (!primitive_.pieces.empty()) {
      culled = primitive_.pieces.front().culled;
      front = primitive_.pieces.front().frontFacing;
    } else if (rules_.error == DeliberateError::ZeroAreaFront) {
      culled = scene_.state.cullMode != CullMode::NONE && scene_.state.cullMode != CullMode::BACK;
      front = true;
    }
    const auto all = [](bool on) { return on ? ~uint32_t{0} : 0; };
    const FanSides sides = rules_.choices.cullPosition == CullPosition::AlsoFloat ? sidesInFloat() : FanSides{all(culled), all(front)};
    const bool oneSideIsCulled = scene_.state.cullMode == CullMode::FRONT || scene_.state.cullMode == CullMode::BACK;
    figureMaker_.makeOutline(primitive_, clipped_, sides, rules_.open && oneSideIsCulled && sideIsFree(primitive_));
    primitive_.pieces.clear();
    primitive_.polygon.clear();
  }

  const Scene& scene_;
  const Rules& rules_;
  const Draw& draw_;
  const DrawVertices& all_;
  RuleCounts& counts_;
  const PrimitiveVisitor& visit_;
  const VertexStage& stage_;
  const ClipVolume& volume_;
  const bool someClipped_;
  const PieceMaker pieceMaker_;
  FigureMaker figureMaker_;
  Primitive primitive_;
  ClipPolygon clipped_;
};

}  // namespace

struct PrimitiveMaker::Impl {
  Impl(const Scene& scene, const Rules& rules, const Draw& draw, bool someClipped, RuleCounts& counts, PrimitiveVisitor visitor)
      : visit(std::move(visitor)), vertices(scene, rules, draw, someClipped), geometry(scene, rules, vertices, counts, visit) {}
  const PrimitiveVisitor visit;
  const DrawVertices vertices;
  DrawGeometry geometry;
};

PrimitiveMaker::PrimitiveMaker(const Scene& scene, const Rules& rules, const Draw& draw, bool someClipped, RuleCounts& counts, PrimitiveVisitor visit)
    : impl_(std::make_unique<Impl>(scene, rules, draw, someClipped, counts, std::move(visit))) {}

PrimitiveMaker::~PrimitiveMaker() = default;

void PrimitiveMaker::make(uint32_t number, const AssembledTriangle& assembled) { impl_->geometry.make(number, assembled); }

void forEachPrimitive(const Scene& scene, const Rules& rules, RuleCounts& counts, const PrimitiveVisitor& visit) {
  forEachPrimitive(scene, rules, {&counts, 1}, {&visit, 1});
}

void forEachPrimitive(const Scene& scene, const Rules& rules, std::span<RuleCounts> counts, std::span<const PrimitiveVisitor> visitors) {
  std::vector<std::unique_ptr<DrawVertices>> draws;
  size_t primitives = 0;
  for (const Draw& draw : scene.draws) {
    draws.push_back(makeVertices(scene, rules, draw, counts));
    primitives += draws.back()->assembled.size();
  }
  inParallel(static_cast<unsigned>(visitors.size()), [&](unsigned k) {
    const size_t first = primitives * k / visitors.size(), end = primitives * (k + 1) / visitors.size();
    size_t before = 0;
    for (const auto& draw : draws) {
      const size_t size = draw->assembled.size(), from = std::max(first, before), to = std::min(end, before + size);
      if (from < to) DrawGeometry(scene, rules, *draw, counts[k], visitors[k]).run(static_cast<uint32_t>(before), from - before, to - before);
      before += size;
    }
  });
}

}  // namespace rasterdiff::rasterizer
