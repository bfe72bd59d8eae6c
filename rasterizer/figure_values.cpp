// Values along lines and of points: their planes, their depth bias, and how a smooth line fades.
#include <algorithm>
#include <cmath>
#include <iterator>

#include "rasterizer/depth/largest_depth.hpp"
#include "rasterizer/fragment/line_plane.hpp"
#include "rasterizer/interpolation.hpp"
#include "rasterizer/lines/line_style.hpp"
#include "rasterizer/lines/smooth_line.hpp"

namespace rasterdiff::rasterizer {

void PieceValues::setUp(const Primitive& primitive, const Figure& figure) {
  if (!setUpCurrent(primitive, nullptr, &figure)) return;
  if (figure.kind == Figure::Kind::Line) {
    setUpLine(figure);
  } else {
    setUpPoint(figure.a);
  }
  inputs_.fillFlat(primitive, constants_);
  builtIns_.setUp(primitive, figure);
  if (depthStage_.isPlain()) return;
  depthStage_.setUp(primitive);
  if (depthStage_.needsBias()) setFigureBias(figure);
}

void PieceValues::setUpPoint(const RasterVertex& vertex) {
  planes_.depth = {};
  planes_.depth.value = vertex.position.z;
  planes_.depth.constantRadius = vertex.depthError;
  planes_.reciprocalW = {};
  planes_.reciprocalW.value = vertex.reciprocalW;
  planes_.reciprocalW.constantRadius = reciprocalWError(vertex);
  inputs_.fillPoint(*primitive_, vertex, planes_, constants_);
}

void PieceValues::setUpLine(const Figure& figure) {
  LineStyle style;
  style.mode = state_.lineRasterizationMode;
  const LineKind kind = lineKind(style, rules_.limits);
  const std::array<const RasterVertex*, 2> ends{&figure.a, &figure.b};
  const auto fill = [&](ValuePlanes& planes, const RasterVertex& a, const RasterVertex& b, LineParameter parameter) {
    const LinePlane plane(a, b, figure.size, parameter);
    fillPlanes(ends, planes, [&plane](const std::array<double, 2>& values, double inputError, double) {
      return plane.through(values[0], values[1], inputError);
    });
  };
  if (rules_.error == DeliberateError::LineAttributesByX) {
    RasterVertex level = figure.b;
    level.position.y = figure.a.position.y;
    fill(planes_, figure.a, level, LineParameter::Projection);
    return;
  }
  // [choice:line-interpolation] nominally by projection, except for parallelograms, whose ends are level.
  const bool parallelogram = kind == LineKind::Parallelogram;
  fill(planes_, figure.a, figure.b, parallelogram ? LineParameter::MajorAxis : LineParameter::Projection);
  if (rules_.variation) varyLine(figure, parallelogram);
  if (!rules_.openValues()) return;
  const bool wideBresenham = kind == LineKind::Bresenham && figure.size >= 1.5F;
  if (parallelogram || wideBresenham) {
    alternative_.emplace();
    alternative_->inputs.resize(inputs_.size());
    fill(*alternative_, figure.a, figure.b, parallelogram ? LineParameter::Projection : LineParameter::Replicated);
  }
  freeDepth_ = location_.samples() > 1;
}

void PieceValues::setFigureBias(const Figure& figure) {
  const bool line = figure.kind == Figure::Kind::Line;
  std::vector<const RasterVertex*> vertices;
  for (const Figure& each : primitive_->figures) {
    vertices.push_back(&each.a);
    if (each.kind == Figure::Kind::Line) vertices.push_back(&each.b);
  }
  BiasInputs inputs{{}, largestDepth(vertices)};
  if (primitive_->assembled.count == 3) {
    // The slope is that of the triangle that the figures outline; clipping does not change its plane.
    std::array<FramebufferPosition, 3> corners;
    for (size_t i = 0; i < 3; ++i) {
      const ClipPosition& p = primitive_->clip[i];
      const double clip[4] = {p.x, p.y, p.z, p.w};
      corners[i] = toFramebuffer(clip, primitive_->viewport);
    }
    double deviation = 0, depthError = 0;
    for (const RasterVertex* vertex : vertices) {
      deviation = std::max(deviation, vertex->deviation);
      depthError = std::max(depthError, vertex->depthError);
    }
    if (primitive_->cut && rules_.openValues()) {
      // Of the cut polygon, or of a piece of it: it may reach either end of the depth range.
      const float farthest = std::max(std::fabs(primitive_->minDepth), std::fabs(primitive_->maxDepth));
      inputs.largestDepth.hi = std::max(inputs.largestDepth.hi, double{farthest});
    }
    inputs.slope = TrianglePlane(corners, deviation).gradient({corners[0].z, corners[1].z, corners[2].z}, depthError);
    if (!std::isfinite(inputs.slope.dx) || !std::isfinite(inputs.slope.dy)) inputs.slope = {0, 0, kUnbounded};
  } else if (line) {
    const LinePlane plane(figure.a, figure.b, figure.size, LineParameter::Projection);
    const double rise = figure.b.position.z - figure.a.position.z;
    inputs.slope = {rise * plane.slopeX(), rise * plane.slopeY(), std::fabs(planes_.depth.dx) + std::fabs(planes_.depth.dy)};
  }
  depthStage_.setFigureBias(*primitive_, inputs);
}

EvaluationRegion PieceValues::nearby(Spot centre, RegionStorage& storage) {
  constexpr double kAway = 2;  // pixels; more than kSmoothReach2
  storage.box = {{{centre.x - kAway, centre.y - kAway}, {centre.x + kAway, centre.y - kAway},
                  {centre.x + kAway, centre.y + kAway}, {centre.x - kAway, centre.y + kAway}}};
  return {centre, storage.box};
}

Interpolated PieceValues::faded(const FragmentPlace& place, const Interpolated& alpha) const {
  const Interval area = smoothCoverage(figure_->a, figure_->b, figure_->size, rules_.limits, place.x, place.y);
  const double products[] = {alpha.bounds.lo * area.lo, alpha.bounds.lo * area.hi, alpha.bounds.hi * area.lo,
                             alpha.bounds.hi * area.hi};
  const auto [lo, hi] = std::minmax_element(std::begin(products), std::end(products));
  const double rounding = 4 * kHalfUlp * std::max(std::fabs(*lo), std::fabs(*hi));
  return toFloat({alpha.value * area.value, *lo - rounding, *hi + rounding});
}

}  // namespace rasterdiff::rasterizer
