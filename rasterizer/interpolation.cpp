#include "rasterizer/interpolation.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "rasterizer/choice_table.hpp"
#include "rasterizer/fragment/line_plane.hpp"
#include "rasterizer/lines/line_style.hpp"
#include "rasterizer/lines/smooth_line.hpp"
#include "rasterizer/sample_pattern.hpp"
#include "rasterizer/shape.hpp"
#include "rasterizer/uncut_triangle.hpp"

namespace rasterdiff::rasterizer {
namespace {

// Of a polygon that nine planes and the four sides of a pixel may have cut.
constexpr size_t kMostCorners = 32;

// |z| of the vertices as far as it is known: what the exponent of a float depth bias comes from.
Interval largestDepth(const RasterVertex* const* vertices, size_t count) {
  Interval largest;
  for (size_t i = 0; i < count; ++i) {
    const double z = std::fabs(vertices[i]->position.z), error = vertices[i]->depthError;
    largest = {std::max(largest.value, z), std::max(largest.lo, z - error), std::max(largest.hi, z + error)};
  }
  return largest;
}

// May, or must, the planes of cut triangles be those of the uncut ones?
bool takesUncut(const Rules& rules) {
  const bool varies = rules.variation && rules.variation->uncutCorners;
  return rules.open || varies || isOpen(rules, Choice::PlanePositions) || rules.choices.planePositions == PlanePositions::SnappedUncut;
}

// [choice:depth-bias-exponent] The vertices are rotated: the smallest y comes first, then the largest w.
Interval firstDifferences(const Primitive& primitive) {
  const auto& clip = primitive.clip;
  std::array<size_t, 3> order{0, 1, 2};
  const auto bring = [&order](const std::array<bool, 3>& wanted) {
    if (wanted[1]) std::rotate(order.begin(), order.begin() + 1, order.end());
    if (wanted[2]) std::rotate(order.begin(), order.begin() + 2, order.end());
  };
  const float top = std::min({clip[0].y, clip[1].y, clip[2].y});
  bring({false, clip[1].y == top, clip[2].y == top});
  const auto w = [&](size_t i) { return clip[order[i]].w; };
  const float farthest = std::max({w(0), w(1), w(2)});
  bring({false, w(1) == farthest, w(2) == farthest});
  const auto scale = static_cast<float>(primitive.viewport.z.scale), offset = static_cast<float>(primitive.viewport.z.offset());
  const auto depth = [&](size_t i) { return clip[order[i]].z * (1.0F / clip[order[i]].w); };
  const float first = depth(0);
  float largest = std::fabs(first * scale + offset);
  for (size_t i = 1; i < 3; ++i) largest = std::max(largest, std::fabs((depth(i) - first) * scale + offset));
  return {largest, largest, largest};
}

}  // namespace

PieceValues::PieceValues(const Scene& scene, const SceneNeeds& needs, const Rules& rules, RuleCounts* counts)
    : needs_(needs), rules_(rules), state_(scene.state), counts_(counts),
      location_(samplePattern(scene.target.samples, rules).value_or(std::vector<SubpixelPosition>{}), rules),
      inputs_(scene, rules), builtIns_(scene, rules, counts), depthStage_(scene, rules, counts) {
  const bool multisampled = scene.target.samples > 1;
  perSample_ = (multisampled && inputs_.anyAt(Location::Sample)) || builtIns_.perSample();
  needsMask_ = (multisampled && inputs_.anyAt(Location::Centroid)) || builtIns_.needsMask();
  perspectiveDepth_ = rules.error == DeliberateError::DepthPerspective;
  plainDepth_ = depthStage_.isPlain() && !perspectiveDepth_;
  if (rules.variation && rules.variation->attributesAtSamples) perSample_ = multisampled;
  needsW_ = inputs_.anyPerspective() || builtIns_.observe(BuiltIn::FragCoord) || perspectiveDepth_;
  needsDepth_ = needs.depth || builtIns_.observe(BuiltIn::FragCoord);
  // Undecorated inputs of a multisampled fragment may be evaluated outside the triangle, within its pixel.
  outside_ = multisampled || inputs_.anyAt(Location::Offset) ? 1 : 0;
  hasAlpha_ = !scene.draws.empty() && !scene.draws[0].varyings.empty() && scene.draws[0].varyings[0].components == 4;
  planes_.inputs.resize(inputs_.size());
  constants_.resize(inputs_.size());
  const bool elsewhere = inputs_.anyAt(Location::Centroid) || inputs_.anyAt(Location::Sample) || inputs_.anyAt(Location::Offset);
  atCentre_ = !elsewhere && !builtIns_.any() && !perSample_ && !needsMask_ && !rules.variation &&
              rules.error == DeliberateError::None && (!needs.depth || plainDepth_);
  mayWait_ = atCentre_ && !(takesUncut(rules) && mayClip(scene));
}

bool PieceValues::setUpCurrent(const Primitive& primitive, const SetupTriangle* piece, const Figure* figure) {
  primitive_ = &primitive;
  piece_ = piece;
  figure_ = figure;
  atPoint_ = figure != nullptr && figure->kind == Figure::Kind::Point;
  smoothLine_ = figure != nullptr && !atPoint_ && drawsSmoothLines(state_);
  varied_.reset();
  freeDepth_ = false;
  alternative_.reset();
  uncut_.reset();
  return needsDepth_ || componentCount() > 0;
}

// [choice:plane-positions]
TrianglePlane PieceValues::planeOf(const Corners& v) const {
  std::array<FramebufferPosition, 3> corners;
  double deviation = 0;
  const bool snaps = rules_.choices.planePositions != PlanePositions::Unsnapped && !rules_.open;
  const bool either = isOpen(rules_, Choice::PlanePositions) && !rules_.open;
  for (size_t i = 0; i < 3; ++i) {
    corners[i] = v[i]->position;
    const double x = v[i]->snapped.x / double{kSubpixelOne}, y = v[i]->snapped.y / double{kSubpixelOne};
    if (snaps) {
      corners[i].x = x;
      corners[i].y = y;
      continue;
    }
    deviation = std::max(deviation, v[i]->deviation);
    if (either) deviation = std::max({deviation, std::fabs(corners[i].x - x), std::fabs(corners[i].y - y)});
  }
  return {corners, deviation};
}

// [vk:primsrast-polygons] A device need not cut what it can draw: the planes may be those of the whole triangle.
void PieceValues::findUncut(const Primitive& primitive) {
  if (!primitive.cut || !takesUncut(rules_)) return;
  uncut_ = uncutVertices(primitive.clip, {rules_, primitive.viewport, location_.samples()});
}

Gradient PieceValues::setUpPlanes(const Corners& v, const TrianglePlane& plane, ValuePlanes& planes) {
  planes.inputs.resize(inputs_.size());
  fillPlanes(v, planes, [&plane](const std::array<double, 3>& values, double inputError, double outside) {
    return plane.through(values, inputError, outside);
  });
  if (!depthStage_.needsBias()) return {};
  return plane.gradient({v[0]->position.z, v[1]->position.z, v[2]->position.z},
                        std::max({v[0]->depthError, v[1]->depthError, v[2]->depthError}));
}

void PieceValues::setUp(const Primitive& primitive, const SetupTriangle& piece) {
  if (!setUpCurrent(primitive, &piece, nullptr)) return;
  const Corners v{&primitive.polygon[piece.corner[0]], &primitive.polygon[piece.corner[1]], &primitive.polygon[piece.corner[2]]};
  findUncut(primitive);
  Gradient slope;
  const bool onlyUncut = uncut_ && !rules_.open && rules_.choices.planePositions == PlanePositions::SnappedUncut;
  if (!onlyUncut) slope = setUpPlanes(v, planeOf(v), planes_);
  if (uncut_) {
    const Corners whole{&(*uncut_)[0], &(*uncut_)[1], &(*uncut_)[2]};
    std::array<FramebufferPosition, 3> corners;
    double deviation = 0;
    for (size_t i = 0; i < 3; ++i) {
      corners[i] = whole[i]->position;
      deviation = std::max(deviation, whole[i]->deviation);
    }
    TrianglePlane plane(corners, deviation);
    plane.reachTo(primitive.polygon);
    const Gradient other = setUpPlanes(whole, plane, onlyUncut ? planes_ : alternative_.emplace());
    const double apart = std::max(std::fabs(other.dx - slope.dx), std::fabs(other.dy - slope.dy));
    slope = onlyUncut ? other : Gradient{slope.dx, slope.dy, std::max(slope.radius, apart + other.radius)};
  }
  if (rules_.variation) varyTriangle(v);
  inputs_.fillFlat(primitive, constants_);
  builtIns_.setUp(primitive, piece);
  depthStage_.setUp(primitive);
  if (!depthStage_.needsBias()) return;
  BiasInputs inputs{slope, largestDepth(v.data(), 3)};
  if (primitive.cut && rules_.open) {
    // The bias of a cut polygon is one number; of its pieces, if a device treats them as triangles, one each.
    for (const RasterVertex& vertex : primitive.polygon) {
      inputs.largestDepth.hi = std::max(inputs.largestDepth.hi, std::fabs(vertex.position.z) + vertex.depthError);
    }
  }
  if (rules_.choices.depthBiasExponent == DepthBiasExponent::FirstDifferences && !rules_.open) {
    inputs.largestDepth = firstDifferences(primitive);
  }
  depthStage_.setBias(inputs);
}

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
  BiasInputs inputs{{}, largestDepth(vertices.data(), vertices.size())};
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

Interval PieceValues::inputOver(size_t component, const EvaluationRegion& region) const {
  const auto over = [&](const ValuePlanes& planes) {
    if (atPoint_ || inputs_[component].kind == Kind::Linear) return linearOver(planes.inputs[component], region);
    const Denominator<kMostCorners> denominator(planes.reciprocalW, region);
    return quotientOver(planes.inputs[component], denominator, region);
  };
  const Interval value = over(planes_);
  return alternative_ ? hullOf(value, over(*alternative_)) : value;
}

Interval PieceValues::depthOver(const EvaluationRegion& region) const {
  if (perspectiveDepth_ && !atPoint_) {
    return quotientOver(planes_.depth, Denominator<kMostCorners>(planes_.reciprocalW, region), region);
  }
  const Interval value = linearOver(planes_.depth, region);
  return alternative_ ? hullOf(value, linearOver(alternative_->depth, region)) : value;
}

Interpolated PieceValues::depth(double x, double y) const {
  const EvaluationRegion there{{x, y}, {}};
  if (varied_) {
    const double z = varied_->depth.at({static_cast<float>(x), static_cast<float>(y)});
    return depthStage_.stored({z, z, z});
  }
  if (figure_ == nullptr && plainDepth_ && !uncut_) return toFloat(linearOver(planes_.depth, there));
  if (smoothLine_) {
    RegionStorage storage;
    return depthStage_.stored(depthOver(nearby({x, y}, storage)));
  }
  if (!freeDepth_) return depthStage_.stored(depthOver(there));
  // [vk:primsrast-lines-basic] a line's data are evaluated at the centre or at a sample of the fragment.
  const FragmentPlace place{static_cast<int32_t>(std::floor(x)), static_cast<int32_t>(std::floor(y)), 0, 0};
  std::array<Spot, 17> spots{centreOf(place)};
  for (uint32_t s = 0; s < location_.samples(); ++s) spots[s + 1] = sampleOf(place, s, location_.pattern());
  return depthStage_.stored(depthOver({{x, y}, std::span<const Spot>(spots).first(location_.samples() + 1)}));
}

EvaluationRegion PieceValues::regionOf(const Component& component, const FragmentPlace& place) {
  switch (component.location) {
    case Location::Centre: break;
    case Location::Sample: count(Rule::AttributeLocation); return location_.atSample(place);
    case Location::Offset: count(Rule::InterpolationOffset); return location_.at(place, component.offset, storage_);
    case Location::Centroid: {
      const EvaluationRegion region = location_.centroid(place, *primitive_, storage_);
      const Spot centre = centreOf(place);
      if (region.nominal.x != centre.x || region.nominal.y != centre.y) count(Rule::AttributeLocation);
      return region;
    }
  }
  return location_.around(centreOf(place), storage_);
}

template <size_t kSpots>
void PieceValues::fragmentAtCentre(const FragmentPlace& place, Interpolated* out) const {
  PixelValues<kSpots> pixel(place.x + 0.5, place.y + 0.5);
  if (needsW_) pixel.setDenominator(planes_.reciprocalW);
  for (size_t c = 0; c < inputs_.size(); ++c) {
    const LinearFunction& f = planes_.inputs[c];
    switch (inputs_[c].kind) {
      case Kind::Flat: *out++ = exactly(constants_[c]); break;
      case Kind::Linear: *out++ = toFloat(pixel.linear(f)); break;
      case Kind::Perspective: *out++ = toFloat(pixel.quotient(f)); break;
    }
  }
}

void PieceValues::fragment(const FragmentPlace& place, Interpolated* out) {
  evaluate(place, out);
  if (smoothLine_ && hasAlpha_ && rules_.error != DeliberateError::SmoothAlphaIgnored) out[3] = faded(place, out[3]);
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

void PieceValues::evaluate(const FragmentPlace& place, Interpolated* out) {
  if (varied_) return variedFragment(place, out);
  if (atCentre_ && figure_ == nullptr && !alternative_) {
    return location_.areaIsFree() ? fragmentAtCentre<5>(place, out) : fragmentAtCentre<1>(place, out);
  }
  const EvaluationRegion centre =
      smoothLine_ ? nearby(centreOf(place), centreStorage_) : location_.around(centreOf(place), centreStorage_);
  const bool triangle = figure_ == nullptr && !alternative_;
  const Denominator<4> denominator(planes_.reciprocalW, centre);  // of the many that are evaluated around the centre
  for (size_t c = 0; c < inputs_.size(); ++c) {
    const Component& component = inputs_[c];
    if (component.kind == Kind::Flat || (atPoint_ && !figure_->a.made)) {
      *out++ = exactly(constants_[c]);
    } else if (triangle && component.location == Location::Centre) {
      const LinearFunction& f = planes_.inputs[c];
      *out++ = toFloat(component.kind == Kind::Linear ? linearOver(f, centre) : quotientOver(f, denominator, centre));
    } else {
      *out++ = toFloat(inputOver(c, component.location == Location::Centre || smoothLine_ ? centre : regionOf(component, place)));
    }
  }
  if (perSample_) count(Rule::SampleShading);
  if (!builtIns_.any()) return;
  Interval depth, reciprocalW;
  if (builtIns_.observe(BuiltIn::FragCoord)) {
    const EvaluationRegion region = builtIns_.fragCoordRegion(place, location_, storage_);
    depth = depthStage_.shown(depthOver(region));
    reciprocalW = linearOver(planes_.reciprocalW, region);
    if (alternative_) reciprocalW = hullOf(reciprocalW, linearOver(alternative_->reciprocalW, region));
    // A driver may keep w and invert it again: two divisions of 2.5 ULP each. [vk:spirvenv-precision-operation]
    const double inverted = 10 * kHalfUlp * std::max(std::fabs(reciprocalW.lo), std::fabs(reciprocalW.hi));
    reciprocalW = {reciprocalW.value, reciprocalW.lo - inverted, reciprocalW.hi + inverted};
  }
  builtIns_.evaluate(place, location_, depth, reciprocalW, out);
}

void PieceValues::varyings(double x, double y, Interpolated* out) const {
  RegionStorage storage;
  const EvaluationRegion region = location_.around({x, y}, storage);
  for (size_t c = 0; c < inputs_.size(); ++c) {
    *out++ = inputs_[c].kind == Kind::Flat ? exactly(constants_[c]) : toFloat(inputOver(c, region));
  }
}

uint32_t PieceValues::coveredSamples(int32_t x, int32_t y) const {
  uint32_t mask = 0;
  for (uint32_t s = 0; s < location_.samples(); ++s) {
    const int64_t px = int64_t{x} * kSubpixelOne + location_.pattern()[s].x;
    const int64_t py = int64_t{y} * kSubpixelOne + location_.pattern()[s].y;
    bool covered = false, tie = false;
    if (figure_ != nullptr) {
      covered = figure_->shape->covers(px, py, tie);
    } else {
      covered = std::all_of(piece_->edges.begin(), piece_->edges.end(), [&](const EdgeFunction& e) { return e.covers(px, py); });
    }
    if (covered) mask |= 1U << s;
  }
  return mask;
}

void PieceValues::count(Rule rule) const {
  if (counts_ != nullptr) ++(*counts_)[rule];
}

}  // namespace rasterdiff::rasterizer
