#include "rasterizer/interpolation.hpp"

#include <algorithm>
#include <cmath>

#include "rasterizer/choice_table.hpp"
#include "rasterizer/depth/largest_depth.hpp"
#include "rasterizer/fragment/plane_corners.hpp"
#include "rasterizer/lines/smooth_line.hpp"
#include "rasterizer/sample_pattern.hpp"
#include "rasterizer/shape.hpp"
#include "rasterizer/uncut_triangle.hpp"

namespace rasterdiff::rasterizer {
namespace {

// Of a polygon that nine planes and the four sides of a pixel may have cut.
constexpr size_t kMostCorners = 32;

// May, or must, the planes of cut triangles be those of the uncut ones?
bool takesUncut(const Rules& rules) {
  const bool varies = rules.variation && rules.variation->uncutCorners;
  return rules.open || varies || isOpen(rules, Choice::PlanePositions) || rules.choices.planePositions == PlanePositions::SnappedUncut;
}

// In every legal evaluation, not only in an exact one: z / w of different numbers may be equal, and differ once rounded.
bool haveEqualDepths(const std::array<const RasterVertex*, 3>& v) {
  return std::ranges::all_of(v, [&](const RasterVertex* a) { return !a->made && a->position.z == v[0]->position.z && a->reciprocalW == v[0]->reciprocalW; });
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
  const PlaneCorners placed = planeCorners(PlanePlaces(rules_), v);
  return {placed.corners, placed.deviation};
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
  if (rules_.open && plane.isUndetermined() && !haveEqualDepths(v)) planes.depth.constantRadius = kUnbounded;
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
  BiasInputs inputs{slope, largestDepth(v)};
  if (primitive.cut && rules_.open) {
    // The bias of a cut polygon is one number; of its pieces, if a device treats them as triangles, one each.
    for (const RasterVertex& vertex : primitive.polygon) {
      inputs.largestDepth.hi = std::max(inputs.largestDepth.hi, std::fabs(vertex.position.z) + vertex.depthError);
    }
  }
  if (rules_.choices.depthBiasExponent == DepthBiasExponent::FirstDifferences && !rules_.open) {
    inputs.largestDepth = largestByFirstDifferences(primitive);
  }
  depthStage_.setBias(inputs);
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
  if (figure_ == nullptr && plainDepth_ && !uncut_) return roundedDepth(linearOver(planes_.depth, there));
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

template <size_t kCorners>
void PieceValues::fragmentAtCentre(const FragmentPlace& place, Interpolated* out) const {
  const PixelRegion<kCorners> pixel = pixelRegion<kCorners>(centreOf(place));
  const Denominator<kCorners> denominator(planes_.reciprocalW, pixel);
  for (size_t c = 0; c < inputs_.size(); ++c) {
    const LinearFunction& f = planes_.inputs[c];
    switch (inputs_[c].kind) {
      case Kind::Flat: *out++ = exactly(constants_[c]); break;
      case Kind::Linear: *out++ = toFloat(linearOver(f, pixel)); break;
      case Kind::Perspective: *out++ = toFloat(quotientOver(f, denominator, pixel)); break;
    }
  }
}

void PieceValues::fragment(const FragmentPlace& place, Interpolated* out) {
  evaluate(place, out);
  if (smoothLine_ && hasAlpha_ && rules_.error != DeliberateError::SmoothAlphaIgnored) out[3] = faded(place, out[3]);
}

void PieceValues::evaluate(const FragmentPlace& place, Interpolated* out) {
  if (varied_) return variedFragment(place, out);
  if (atCentre_ && figure_ == nullptr && !alternative_) {
    return location_.areaIsFree() ? fragmentAtCentre<4>(place, out) : fragmentAtCentre<0>(place, out);
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
      covered = piece_->covers(px, py);
    }
    if (covered) mask |= 1U << s;
  }
  return mask;
}

void PieceValues::count(Rule rule) const {
  if (counts_ != nullptr) ++(*counts_)[rule];
}

}  // namespace rasterdiff::rasterizer
