#include "rasterizer/explain.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "rasterizer/choice_table.hpp"
#include "rasterizer/cut_polygon.hpp"
#include "rasterizer/drawing_region.hpp"
#include "rasterizer/figure_rules.hpp"
#include "rasterizer/fragment_replay.hpp"
#include "rasterizer/figure_verdict.hpp"
#include "rasterizer/freedom_band.hpp"
#include "rasterizer/kept_fragments.hpp"
#include "rasterizer/lines/line_coverage.hpp"
#include "rasterizer/sample_grid.hpp"
#include "rasterizer/sample_pattern.hpp"
#include "rasterizer/shape.hpp"
#include "rasterizer/target_area.hpp"

namespace rasterdiff::rasterizer {
namespace {

// A pixel of margin, so that near misses are shown too.
bool reaches(const Primitive& primitive, const SetupTriangle& piece, SubpixelPosition p) {
  SubpixelPosition low = primitive.polygon[piece.corner[0]].lowest, high = primitive.polygon[piece.corner[0]].highest;
  for (const uint8_t corner : piece.corner) {
    const RasterVertex& v = primitive.polygon[corner];
    low = {std::min(low.x, v.lowest.x), std::min(low.y, v.lowest.y)};
    high = {std::max(high.x, v.highest.x), std::max(high.y, v.highest.y)};
  }
  return p.x >= low.x - kSubpixelOne && p.x <= high.x + kSubpixelOne && p.y >= low.y - kSubpixelOne &&
         p.y <= high.y + kSubpixelOne;
}

bool reaches(const Figure& figure, SampleQuery query) {
  const auto x = static_cast<int32_t>(query.x), y = static_cast<int32_t>(query.y);
  for (int32_t row = y - 1; row <= y + 1; ++row) {
    const RowSpan columns = figure.shape->columns(row);
    const Shape::Rows rows = figure.shape->rows();
    if (row >= rows.first && row <= rows.last && x >= columns.begin - 1 && x <= columns.end) return true;
  }
  return false;
}

EdgeExplanation explainEdge(const RasterVertex& a, const RasterVertex& b, const EdgeFunction& edge, SubpixelPosition p) {
  EdgeExplanation result;
  result.ends = {a.snapped, b.snapped};
  result.value = edge.at(p.x, p.y);
  result.ownsTies = edge.ownsTies;
  result.lowest = result.highest = result.value;
  for (unsigned corner = 0; corner < 16; ++corner) {
    const SubpixelPosition from{(corner & 1) != 0 ? a.highest.x : a.lowest.x, (corner & 2) != 0 ? a.highest.y : a.lowest.y};
    const SubpixelPosition to{(corner & 4) != 0 ? b.highest.x : b.lowest.x, (corner & 8) != 0 ? b.highest.y : b.lowest.y};
    const int64_t value = edgeFunction(from, to, TieOwner::TopLeft).at(p.x, p.y);
    result.lowest = std::min(result.lowest, value);
    result.highest = std::max(result.highest, value);
  }
  return result;
}

// The fragment operation that took the sample away, else the geometry's own rule.
Rule decidingRule(const PrimitiveExplanation& e, Rule shape, bool tie, bool inside) {
  if (e.culled) return Rule::Culling;
  if (e.dropped) return Rule::LineStipple;
  switch (e.fate.end) {
    case FragmentFate::End::OutsideScissor: return Rule::Scissor;
    case FragmentFate::End::Masked: return Rule::SampleMask;
    case FragmentFate::End::ShaderMasked: return Rule::ShaderSampleMask;
    case FragmentFate::End::AlphaDropped: return Rule::AlphaToCoverage;
    case FragmentFate::End::DepthFailed: return Rule::DepthTest;
    case FragmentFate::End::NotCovered:
    case FragmentFate::End::Written: break;
  }
  if (tie) return Rule::TieBreak;
  if (e.kind == PrimitiveExplanation::Kind::Triangle && e.clipped && !inside) return Rule::ViewVolume;
  return shape;
}

class Explainer {
 public:
  Explainer(const Scene& scene, const Rules& rules, SampleQuery query, SampleExplanation& result)
      : scene_(scene), rules_(rules), query_(query), x_(static_cast<int32_t>(query.x)), y_(static_cast<int32_t>(query.y)),
        offset_{result.position.x - x_ * kSubpixelOne, result.position.y - y_ * kSubpixelOne}, needs_(needsOf(scene)),
        replay_(scene, rules, query, result.position), result_(result) {}

  void add(const Primitive& primitive) {
    reached_.push_back(primitive.number);
    region_ = drawingRegion(scene_, primitive.viewportIndex, rules_);
    if (primitive.unprojectable) result_.primitives.push_back(explainUnprojectable(primitive));
    for (const SetupTriangle& piece : primitive.pieces) {
      if (reaches(primitive, piece, result_.position)) result_.primitives.push_back(explainPiece(primitive, piece));
    }
    for (const Figure& figure : primitive.figures) {
      if (reaches(figure, query_)) result_.primitives.push_back(explainFigure(primitive, figure));
    }
  }

  [[nodiscard]] const std::vector<uint32_t>& reached() const { return reached_; }

 private:
  [[nodiscard]] PrimitiveExplanation begin(const Primitive& primitive) const {
    PrimitiveExplanation result;
    result.primitive = primitive.number;
    result.vertices = primitive.assembled.count;
    result.clip = primitive.clip;
    result.clipped = primitive.cut;
    return result;
  }

  template <class Part>
  void settle(PrimitiveExplanation& e, const Primitive& primitive, const Part& part, bool inside, bool writable) {
    if (inside && !writable) e.fate.end = FragmentFate::End::OutsideScissor;
    if (inside && writable) e.fate = replay_.next(primitive, part);
    e.covered = inside && writable;
    e.coverage = e.covered ? Coverage::In : Coverage::Out;
    if (!needs_.depth) return;
    PieceValues values(scene_, needs_, rules_);
    values.setUp(primitive, part);
    e.depth = values.depth(result_.position.x / double{kSubpixelOne}, result_.position.y / double{kSubpixelOne}).value;
  }

  // Open rules, under which nothing leaks.
  void allow(PrimitiveExplanation& e, const BandVerdict& verdict, bool writable) const {
    if (!rules_.open || !writable) return;
    e.coverage = verdict.coverage;
    e.freedom = verdict.freedom;
  }

  PrimitiveExplanation explainUnprojectable(const Primitive& primitive) const {
    PrimitiveExplanation e = begin(primitive);
    e.unprojectable = true;
    e.decidedBy = Rule::Division;
    allow(e, {Coverage::Either, Freedom::DivisionByZero, std::nullopt}, region_.area.contains(x_, y_));
    return e;
  }

  // [choice:clip-distances]
  [[nodiscard]] bool dropsFragments(const Primitive& primitive) const {
    return leavesDistancesToFragments(rules_) && primitive.draw->clipDistanceCount > 0;
  }
  [[nodiscard]] bool keeps(const KeptFragments& kept) const { return kept.keeps(x_, y_); }
  [[nodiscard]] VertexStage stageOf(const Primitive& primitive) const { return {rules_, primitive.viewport, scene_.target.samples}; }

  PrimitiveExplanation explainPiece(const Primitive& primitive, const SetupTriangle& piece) {
    const SubpixelPosition p = result_.position;
    PrimitiveExplanation e = begin(primitive);
    e.doubleArea = piece.area;
    e.frontFacing = piece.frontFacing;
    e.culled = piece.culled;
    bool inside = true, touched = true, tie = false;
    for (size_t i = 0; i < 3; ++i) {
      const RasterVertex& a = primitive.polygon[piece.corner[i]];
      const RasterVertex& b = primitive.polygon[piece.corner[(i + 1) % 3]];
      e.snapped[i] = a.snapped;
      e.edges[i] = explainEdge(a, b, piece.edges[i], p);
      inside = inside && piece.edges[i].covers(p.x, p.y);
      touched = touched && e.edges[i].value >= 0;
      tie = tie || e.edges[i].value == 0;
    }
    if (primitive.folded) {
      const std::optional<size_t> drawn = CutPolygon(primitive, rules_).pieceAt(p.x, p.y);
      inside = drawn && &primitive.pieces[*drawn] == &piece;
    }
    const bool kept = !dropsFragments(primitive) || keeps(KeptFragments(primitive, stageOf(primitive)));
    const bool writable = region_.of(primitive, piece).contains(x_, y_, offset_);
    settle(e, primitive, piece, inside && kept && !piece.culled, writable);
    if (rules_.open) allow(e, FreedomBand(primitive, scene_.state.cullMode, scene_.state.frontFace).classifyExactly(p.x, p.y), writable);
    e.decidedBy = kept ? decidingRule(e, Rule::SampleCoverage, tie && touched, touched) : Rule::UserDistance;
    return e;
  }

  PrimitiveExplanation explainFigure(const Primitive& primitive, const Figure& figure) {
    const SubpixelPosition p = result_.position;
    PrimitiveExplanation e = begin(primitive);
    const bool point = figure.kind == Figure::Kind::Point;
    e.kind = point ? PrimitiveExplanation::Kind::Point : PrimitiveExplanation::Kind::Line;
    e.frontFacing = figure.frontFacing;
    e.ends = {figure.a.position, point ? figure.a.position : figure.b.position};
    e.size = figure.size;
    const Draw& draw = *primitive.draw;
    const auto& weights = figure.a.smoothWeights;
    const uint32_t corner = primitive.assembled.vertices[static_cast<size_t>(std::ranges::max_element(weights) - weights.begin())];
    const double pointSize = draw.pointSizes.empty() ? scene_.state.pointSize : draw.pointSizes[corner];
    e.requested = point ? pointSize : scene_.state.lineWidth;
    const FigureRules own(scene_, rules_, primitive, figure);
    e.shapeRules.assign(own.all().begin(), own.all().end());
    bool tie = false, ignored = false;
    const bool inside = figure.nominal && figure.shape->covers(p.x, p.y, tie);
    e.facts = figure.shape->facts(p.x, p.y);
    e.dropped = !inside && figure.solid != nullptr && figure.solid->covers(p.x, p.y, ignored);
    if (e.facts.sides.empty() && !e.facts.diamond && figure.solid != nullptr) e.facts = figure.solid->facts(p.x, p.y);
    const bool kept = !dropsFragments(primitive) || keeps(KeptFragments(primitive, figure, stageOf(primitive)));
    const bool writable = region_.allows(figure, x_, y_);
    settle(e, primitive, figure, inside && kept, writable);
    if (rules_.open) allow(e, legalVerdict(figure, p.x, p.y), writable);
    e.decidedBy = kept ? decidingRule(e, own.shape(), tie, inside) : Rule::UserDistance;
    return e;
  }

  const Scene& scene_;
  const Rules& rules_;
  const SampleQuery query_;
  const int32_t x_, y_;            // its pixel
  const SubpixelPosition offset_;  // of the sample from the pixel's corner
  const SceneNeeds needs_;
  FragmentReplay replay_;
  SampleExplanation& result_;
  std::vector<uint32_t> reached_;
  DrawingRegion region_;  // of the primitive being explained
};

}  // namespace

Result<SampleExplanation> explain(const Scene& scene, const Rules& profile, SampleQuery query) {
  const Rules rules = rulesFor(scene, profile);
  const Result<Frame> frame = render(scene, rules);
  if (!frame) return tl::unexpected<Error>(frame.error());
  if (query.x >= scene.target.width || query.y >= scene.target.height || query.sample >= scene.target.samples) {
    return fail(ErrorCode::BadInput, "sample",
                fmt::format("sample {} of pixel ({}, {}) is outside the target of {} × {} pixels with {} sample(s)",
                            query.sample, query.x, query.y, scene.target.width, scene.target.height, scene.target.samples),
                "X and Y count pixels from the top-left corner, samples count from 0");
  }
  if (scene.target.sampleLocations) {
    const Result<SampleGrid> grid = SampleGrid::of(scene, rules);
    if (!grid) return tl::unexpected<Error>(grid.error());
    const GridPixel& place = grid->ofPixel(query.x, query.y);
    Result<SampleExplanation> explanation = explain(place.scene, place.rules, query);
    if (explanation) explanation->rules.push_back(Rule::CustomLocations);
    return explanation;
  }
  const std::vector<SubpixelPosition> pattern = *samplePattern(scene.target.samples, rules);
  SampleExplanation result;
  result.position = {static_cast<int32_t>(query.x) * kSubpixelOne + pattern[query.sample].x,
                     static_cast<int32_t>(query.y) * kSubpixelOne + pattern[query.sample].y};
  result.insideScissor = false;
  for (uint32_t viewport = 0; viewport <= scene.furtherViewports.size(); ++viewport) {
    const PixelArea area = targetArea(scene, viewport, rules.error);
    result.insideScissor = result.insideScissor || area.contains(static_cast<int32_t>(query.x), static_cast<int32_t>(query.y));
  }
  result.owner = frame->primitive.at(query.x, query.y, query.sample);
  Explainer explainer(scene, rules, query, result);
  RuleCounts ignored;
  forEachPrimitive(scene, rules, ignored, [&](const Primitive& primitive) { explainer.add(primitive); });
  result.rejections = explainRejections(scene, rules, explainer.reached());
  result.rules = rulesAtWork(scene, result);
  return result;
}

}  // namespace rasterdiff::rasterizer
