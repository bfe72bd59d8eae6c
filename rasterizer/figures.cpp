#include "rasterizer/figures.hpp"

#include <algorithm>
#include <cmath>

#include "rasterizer/lines/clip_corner_line.hpp"
#include "rasterizer/lines/line_coverage.hpp"
#include "rasterizer/lines/line_shape.hpp"
#include "rasterizer/lines/stipple.hpp"

namespace rasterdiff::rasterizer {
namespace {

constexpr unsigned kVolumeMask = (1U << kVolumePlanes) - 1;

ClipPosition rounded(const ClipVertex& vertex) {
  const auto at = [&](size_t i) { return static_cast<float>(vertex.position[i]); };
  return {at(0), at(1), at(2), at(3)};
}

// Do both vertices lie on one edge of the unclipped triangle? Only then some corner has no weight in either.
bool onOriginalEdge(const RasterVertex& a, const RasterVertex& b) {
  for (size_t k = 0; k < 3; ++k) {
    if (a.smoothWeights[k] == 0 && b.smoothWeights[k] == 0) return true;
  }
  return false;
}

bool atCorner(const RasterVertex& vertex) {
  return vertex.made && std::ranges::any_of(vertex.smoothWeights, [](double weight) { return weight == 1; });
}

// Does clipping leave only one corner or edge of the triangle, on the border of the volume? No area is left, and whether that
// is a polygon depends on the new vertices.
bool cutToItsBorder(const Primitive& primitive) {
  std::array<bool, 3> left{};
  for (const RasterVertex& vertex : primitive.polygon) {
    const auto corner = std::ranges::find(vertex.smoothWeights, 1.0);
    if (corner == vertex.smoothWeights.end()) return false;
    left[static_cast<size_t>(corner - vertex.smoothWeights.begin())] = true;
  }
  return primitive.cut && std::ranges::count(left, true) < 3;
}

// [choice:cut-outline] Flagged: the edges of each triangle of the fan come last edge first. The one that closes the
// polygon is then the first of a whole triangle, and the last but one of a cut polygon that begins with its provoking vertex.
size_t flaggedOrder(bool cut, ProvokingVertexMode mode, size_t n, size_t k) {
  if (cut && mode == ProvokingVertexMode::LAST_VERTEX) return k;
  if (n == 3) return (k + 2) % 3;
  return k + 2 < n ? k : 2 * n - 3 - k;
}

// Which triangle (0, i + 1, i + 2) of a fan over n corners edge i, and corner i, belong to.
size_t fanTriangleOf(size_t i, size_t n) { return i == 0 ? 0 : i == n - 1 ? n - 3 : i - 1; }

// From those of an edge's two ends to those of the triangle whose edge `k` it is.
void turnWeights(RasterVertex& vertex, size_t k) {
  for (std::array<double, 3>* weights : {&vertex.smoothWeights, &vertex.linearWeights}) {
    std::rotate(weights->begin(), weights->end() - static_cast<std::ptrdiff_t>(k), weights->end());
  }
}

// A deliberate error: the last end goes a pixel on along the line.
void lengthen(RasterVertex& b, const RasterVertex& a) {
  const double dx = b.position.x - a.position.x, dy = b.position.y - a.position.y;
  const double longer = std::max(std::fabs(dx), std::fabs(dy));
  if (longer == 0) return;
  b.position.x += dx / longer;
  b.position.y += dy / longer;
  const SubpixelPosition step{static_cast<int32_t>(std::lround(dx / longer * kSubpixelOne)),
                              static_cast<int32_t>(std::lround(dy / longer * kSubpixelOne))};
  for (SubpixelPosition* p : {&b.snapped, &b.lowest, &b.highest}) {
    p->x += step.x;
    p->y += step.y;
  }
}

}  // namespace

FigureMaker::FigureMaker(const Scene& scene, const Rules& rules, const Draw& draw, const VertexStage& stage,
                         const ClipVolume& volume, const DrawingRegion& region, RuleCounts& counts)
    : scene_(scene), rules_(rules), draw_(draw), stage_(stage), volume_(volume), region_(region), counts_(counts) {}

PointSize FigureMaker::pointSizeOf(uint32_t vertex) const {
  if (rules_.error == DeliberateError::PointSizeIgnored) return {};
  return pointSize(draw_.pointSizes.empty() ? scene_.state.pointSize : draw_.pointSizes[vertex], rules_.limits);
}

bool FigureMaker::pointSurvives(const ClipInput& vertex) {
  const unsigned code = outcode(vertex, volume_);
  if (code == 0) return true;
  ++counts_[Rule::PointClip];
  if (rules_.choices.pointClip == PointClip::SidesIgnored) {
    return (code & ~kSideMask) == 0 && vertex.position.w > 0 && std::isfinite(vertex.position.x) && std::isfinite(vertex.position.y);
  }
  const bool onlyUserPlanes = rules_.limits.pointClippingBehavior == PointClippingBehavior::USER_CLIP_PLANES_ONLY;
  const bool ignored = onlyUserPlanes || rules_.error == DeliberateError::PointClipIgnored;
  return ignored && (code & ~kVolumeMask) == 0 && vertex.position.w > 0;
}

void FigureMaker::addPoint(Primitive& primitive, const ClipVertex& clip, RasterVertex vertex, const PointSize& size,
                           const Existence& existence) {
  if (rules_.error == DeliberateError::PointRounded) {
    const auto centre = [](int32_t v) { return (v >> kSubpixelBits) * kSubpixelOne + kSubpixelOne / 2; };
    vertex.snapped = {centre(vertex.snapped.x), centre(vertex.snapped.y)};
    vertex.lowest = vertex.highest = vertex.snapped;
  }
  Figure figure;
  figure.kind = Figure::Kind::Point;
  figure.a = vertex;
  figure.size = figure.smallest = figure.largest = size.drawn(rules_.choices.pointArithmetic);
  if (rules_.open) figure.smallest = size.smallest, figure.largest = size.largest;
  figure.existence = existence.freedom;
  figure.nominal = existence.nominal;
  figure.frontFacing = existence.frontFacing;
  figure.shape = makePointShape(rounded(clip), vertex, floatPosition(stage_, clip), size, stage_);
  primitive.figures.push_back(std::move(figure));
}

void FigureMaker::makePoint(Primitive& primitive, const ClipInput& vertex) { makeCorner(primitive, vertex, 0); }

void FigureMaker::makeCorner(Primitive& primitive, const ClipInput& vertex, size_t k) {
  if (primitive.assembled.count == 3) ++counts_[Rule::PolygonMode];
  if (!pointSurvives(vertex)) return;
  if (vertex.position.w <= 0) return;
  const PointSize size = pointSizeOf(primitive.assembled.vertices[k]);
  RasterVertex raster = stage_.original(vertex.position);
  raster.smoothWeights = raster.linearWeights = {};
  raster.smoothWeights[k] = raster.linearWeights[k] = 1;
  if (rules_.error == DeliberateError::PointClippedByExtent) {
    const Viewport& v = scene_.viewport;
    const double half = size.nominal / 2, low = std::min(v.y, v.y + v.height), high = std::max(v.y, v.y + v.height);
    if (raster.position.x - half < v.x || raster.position.x + half > double{v.x} + v.width ||
        raster.position.y - half < low || raster.position.y + half > high) {
      return;
    }
  }
  ClipVertex clip;
  clip.position = {vertex.position.x, vertex.position.y, vertex.position.z, vertex.position.w};
  addPoint(primitive, clip, raster, size, {});
}

LineStyle FigureMaker::lineStyle() const {
  const State& state = scene_.state;
  LineStyle style;
  style.mode = state.lineRasterizationMode;
  style.width = rules_.error == DeliberateError::LineWidthIgnored ? 1.0F : state.lineWidth;
  style.samples = scene_.target.samples;
  style.area = region_.area;
  style.leaky = region_.leaky;
  style.stipple.enabled = state.stippledLineEnable && rules_.error != DeliberateError::StippleIgnored;
  style.stipple.factor = state.lineStippleFactor;
  style.stipple.pattern = state.lineStipplePattern;
  style.stipple.start = stipple_;
  if (rules_.error == DeliberateError::LineModeExchanged) {
    const bool bresenham = lineKind(style, rules_.limits) == LineKind::Bresenham;
    style.mode = bresenham ? LineRasterizationMode::RECTANGULAR : LineRasterizationMode::BRESENHAM;
  }
  return style;
}

void FigureMaker::addLine(Primitive& primitive, const LineEnds& ends, bool ofPolygon, const Existence& existence) {
  const bool smooth = scene_.state.lineRasterizationMode == LineRasterizationMode::RECTANGULAR_SMOOTH;
  if (smooth && rules_.error == DeliberateError::SmoothLinesDropped) return;
  LineStyle style = lineStyle();
  if (smooth && rules_.error == DeliberateError::SmoothLinesWide) style.width += 6;
  style.ofPolygon = ofPolygon;
  const double dx = ends.b.position.x - ends.a.position.x, dy = ends.b.position.y - ends.a.position.y;
  if (rules_.error == DeliberateError::LineWidthOfXMajorOnly && std::fabs(dy) > std::fabs(dx)) style.width = 1;
  Figure figure;
  figure.kind = Figure::Kind::Line;
  figure.a = ends.a;
  figure.b = ends.b;
  figure.size = style.width;
  figure.existence = existence.freedom;
  figure.nominal = existence.nominal;
  figure.frontFacing = existence.frontFacing;
  figure.cutsItself = rules_.choices.lineArithmetic == LineArithmetic::Float32Corners;
  const bool clipCorners = rules_.choices.lineArithmetic == LineArithmetic::ClipCorners && !rules_.open && !style.stipple.enabled;
  figure.shape = clipCorners ? makeClipCornerLine(ends.clip, style, stage_, volume_) : makeLineShape(ends, style, rules_);
  if (style.stipple.enabled) {
    stipple_ = stippleAfter(ends, style, rules_);
    style.stipple.enabled = false;
    if (!ends.removed) figure.solid = lineCoverage(ends, style, rules_);
  }
  if (figure.shape != nullptr) primitive.figures.push_back(std::move(figure));
}

void FigureMaker::makeLine(Primitive& primitive, const ClipInput& a, const ClipInput& b) { makeLine(primitive, a, b, 0, false); }

void FigureMaker::makeEdge(Primitive& primitive, const ClipInput& a, const ClipInput& b, size_t k) {
  if (k == 0) ++counts_[Rule::PolygonMode];
  makeLine(primitive, a, b, k, true);
}

void FigureMaker::makeLine(Primitive& primitive, const ClipInput& a, const ClipInput& b, size_t corner, bool ofPolygon) {
  const bool restarts = !primitive.assembled.continuesLine || rules_.error == DeliberateError::StippleStripRestarts;
  if (restarts && rules_.error != DeliberateError::StippleNotReset) stipple_ = {};
  const std::array<ClipInput, 2> line{a, b};
  ClipPolygon clipped;
  const ClipOutcome outcome = clipLine(line, rules_.choices.clipArithmetic, volume_, clipped);
  LineEnds ends;
  if (outcome != ClipOutcome::Inside) {
    ++counts_[Rule::LineClip];
    primitive.cut = true;
    if (rules_.error == DeliberateError::LineClipDrops) return;
    if (a.position.w > 0 && b.position.w > 0) ends.uncut = {stage_.original(a.position), stage_.original(b.position)};
  }
  ends.clip = {a.position, b.position};
  const bool cutsOutline = rules_.choices.lineArithmetic == LineArithmetic::ClipCorners && ends.uncut;
  const bool nothingLeft = clipped.size < 2 || clipped.vertices[0].position[3] <= 0 || clipped.vertices[1].position[3] <= 0;
  const bool uncut = ends.uncut && ((rules_.variation && rules_.variation->linesUncut) || (cutsOutline && nothingLeft));
  ends.removed = uncut || nothingLeft;
  if (ends.removed && !uncut && (!rules_.open || !ends.uncut)) return;
  if (!ends.removed) {
    ends.a = stage_.clipped(clipped.vertices[0]);
    ends.b = stage_.clipped(clipped.vertices[1]);
    ends.floatA = floatPosition(stage_, clipped.vertices[0]);
    ends.floatB = floatPosition(stage_, clipped.vertices[1]);
  } else {
    ends.a = (*ends.uncut)[0];
    ends.b = (*ends.uncut)[1];
    ends.b.smoothWeights = ends.b.linearWeights = {0, 1, 0};
    if (uncut) ends.removed = false;
  }
  if (rules_.error == DeliberateError::LineEndIncluded) lengthen(ends.b, ends.a);
  if (ofPolygon) {
    turnWeights(ends.a, corner);
    turnWeights(ends.b, corner);
  }
  addLine(primitive, ends, ofPolygon, {});
}

PointSize FigureMaker::cornerSize(const Primitive& primitive, const RasterVertex& corner) const {
  if (draw_.pointSizes.empty() || rules_.error == DeliberateError::PointSizeIgnored) return pointSizeOf(0);
  double size = 0;
  for (size_t k = 0; k < 3; ++k) size += corner.smoothWeights[k] * double{draw_.pointSizes[primitive.assembled.vertices[k]]};
  return pointSize(static_cast<float>(size), rules_.limits);
}

void FigureMaker::makeOutline(Primitive& primitive, const ClipPolygon& polygon, const FanSides& sides, bool sideIsFree) {
  const bool allCulled = sides.culled == ~uint32_t{0};
  if (allCulled && !sideIsFree) return;
  ++counts_[Rule::PolygonMode];
  stipple_ = {};
  const bool flagged = rules_.choices.cutOutline == CutOutline::Flagged;
  const size_t n = primitive.polygon.size();
  const bool open = rules_.error == DeliberateError::LineModeOpen && scene_.state.polygonMode == PolygonMode::LINE;
  const bool mayVanish = rules_.open && cutToItsBorder(primitive);
  const auto existence = [&](bool wanted, size_t part) {
    const Freedom freedom = !wanted || mayVanish ? Freedom::ClipVertexPosition : sideIsFree ? Freedom::NearZeroArea : Freedom::None;
    return Existence{wanted && !allCulled, freedom, (sides.front >> part & 1) != 0};
  };
  const bool lastEarly = flagged && scene_.state.polygonMode == PolygonMode::LINE;
  for (size_t k = 0; k < (open ? n - 1 : n); ++k) {
    const size_t i = lastEarly ? flaggedOrder(primitive.cut, scene_.state.provokingVertexMode, n, k) : k;
    const size_t part = fanTriangleOf(i, n);
    if (!allCulled && (sides.culled >> part & 1) != 0) continue;
    const RasterVertex& a = primitive.polygon[i];
    if (scene_.state.polygonMode == PolygonMode::POINT) {
      const bool wanted = flagged ? polygon.vertices[i].outlined : !a.made;
      if (wanted || rules_.open) addPoint(primitive, polygon.vertices[i], a, cornerSize(primitive, a), existence(wanted, part));
      continue;
    }
    const RasterVertex& b = primitive.polygon[(i + 1) % n];
    LineEnds ends;
    ends.a = a;
    ends.b = b;
    ends.clip = {rounded(polygon.vertices[i]), rounded(polygon.vertices[(i + 1) % n])};
    ends.floatA = floatPosition(stage_, polygon.vertices[i]);
    ends.floatB = floatPosition(stage_, polygon.vertices[(i + 1) % n]);
    // A triangle cut down to one of its edges has that edge, and the one along the cut in the same place.
    const bool alongCut = atCorner(a) && atCorner(b);
    const bool wanted = flagged ? polygon.vertices[i].outlined : !primitive.cut || (onOriginalEdge(a, b) && !alongCut);
    if (wanted || rules_.open) addLine(primitive, ends, true, existence(wanted, part));
  }
}

}  // namespace rasterdiff::rasterizer
