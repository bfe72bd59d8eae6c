#include "rasterizer/fragment/built_in_values.hpp"

#include <algorithm>
#include <cmath>

#include "scene/built_ins.hpp"

namespace rasterdiff::rasterizer {
namespace {

// May a legal placement of the corners change the sign of the polygon's area? [vk:primsrast-polygons-basic]
bool facingIsFree(const std::vector<RasterVertex>& polygon) {
  double area = 0, perimeter = 0, deviation = 0;
  for (size_t i = 0; i < polygon.size(); ++i) {
    const RasterVertex& a = polygon[i];
    const RasterVertex& b = polygon[(i + 1) % polygon.size()];
    area += a.position.x * b.position.y - a.position.y * b.position.x;
    perimeter += std::fabs(b.position.x - a.position.x) + std::fabs(b.position.y - a.position.y);
    deviation = std::max(deviation, a.deviation);
  }
  // Moving every corner by at most δ changes twice the area by at most δ · perimeter (L1) + 4 n δ².
  return deviation > 0 && std::fabs(area) <= deviation * perimeter + 4 * static_cast<double>(polygon.size()) * deviation * deviation;
}

// Of a triangle that is drawn as lines or points: its corners as they would be without clipping.
std::vector<RasterVertex> cornersOf(const Primitive& primitive, double deviation) {
  std::vector<RasterVertex> corners(3);
  for (size_t i = 0; i < 3; ++i) {
    const ClipPosition& p = primitive.clip[i];
    const double clip[4] = {p.x, p.y, p.z, p.w};
    corners[i].position = toFramebuffer(clip, primitive.viewport);
    corners[i].deviation = deviation;
  }
  return corners;
}

LinearFunction acrossPoint(double centre, double size, double deviation, double sign) {
  LinearFunction f;
  f.value = 0.5;
  f.constantRadius = deviation / size + 3 * kHalfUlp;
  // Reciprocal, product with the centre, two sums; anchored at the origin.
  f.radiusPerX = 6 * kHalfUlp / size;
  f.farX = std::fabs(centre);
  f.dx = sign / size;
  f.x0 = centre;
  return f;
}

}  // namespace

BuiltInValues::BuiltInValues(const Scene& scene, const Rules& rules, RuleCounts* counts)
    : observed_(scene.builtIns), rules_(rules), shading_(sampleShading(scene)), sampleMask_(scene.state.sampleMask),
      height_(scene.target.height),
      counts_(counts), coverage_(scene.state) {
  for (const BuiltIn builtIn : observed_) components_ += builtInComponents(builtIn);
}

bool BuiltInValues::observe(BuiltIn builtIn) const {
  return std::find(observed_.begin(), observed_.end(), builtIn) != observed_.end();
}

void BuiltInValues::setUp(const Primitive& primitive, const SetupTriangle& piece) {
  if (!any()) return;
  coverage_.setUp(primitive, nullptr);
  isPoint_ = false;
  if (!observe(BuiltIn::FrontFacing)) return;
  const bool front = piece.frontFacing != (rules_.error == DeliberateError::FrontFacingInverted);
  facing_ = exactly(front ? 1 : 0);
  if (rules_.open && facingIsFree(primitive.polygon)) facing_.bounds = {0, 1};
}

void BuiltInValues::setUp(const Primitive& primitive, const Figure& figure) {
  if (!any()) return;
  coverage_.setUp(primitive, &figure);
  bool front = figure.frontFacing != (rules_.error == DeliberateError::FrontFacingInverted);
  if (rules_.error == DeliberateError::LinesBackFacing && primitive.assembled.count < 3) front = false;
  facing_ = exactly(front ? 1 : 0);
  if (rules_.open && primitive.assembled.count == 3 && facingIsFree(cornersOf(primitive, figure.a.deviation))) {
    facing_.bounds = {0, 1};
  }
  isPoint_ = primitive.assembled.count == 1;
  if (!isPoint_) return;
  const RasterVertex& vertex = figure.a;
  const double sign = rules_.error == DeliberateError::PointCoordUp ? -1 : 1;
  const auto across = [&](double centre, double direction) {
    const auto of = [&](float size) { return acrossPoint(centre, double{size}, vertex.deviation, direction); };
    return AcrossPoint{of(figure.size), of(figure.smallest), of(figure.largest)};
  };
  pointS_ = across(vertex.position.x, 1), pointT_ = across(vertex.position.y, sign);
}

// At a place it is monotonic in the size.
Interval BuiltInValues::AcrossPoint::over(const EvaluationRegion& region) const {
  Interval all = linearOver(own, region);
  if (least.dx == most.dx) return all;
  for (const LinearFunction* other : {&least, &most}) {
    const Interval here = linearOver(*other, region);
    all.lo = std::min(all.lo, here.lo), all.hi = std::max(all.hi, here.hi);
  }
  return all;
}

Spot BuiltInValues::nominalSpot(const FragmentPlace& place, const AttributeLocation& location) const {
  if (!shading_.perSample) return centreOf(place);
  return sampleOf(place, rules_.error == DeliberateError::SampleIdZero ? 0 : place.sample, location.pattern());
}

EvaluationRegion BuiltInValues::fragCoordRegion(const FragmentPlace& place, const AttributeLocation& location,
                                                RegionStorage& storage) const {
  const Spot nominal = nominalSpot(place, location);
  if (!location.areaIsFree()) return {nominal, {}};
  if (!shading_.certain || !shading_.enabled) return {nominal, location.around(centreOf(place), storage).corners};
  storage.box.fill(centreOf(place));
  storage.box[1] = sampleOf(place, place.sample, location.pattern());
  return {nominal, std::span<const Spot>(storage.box).first(2)};
}

void BuiltInValues::fragCoord(const FragmentPlace& place, const AttributeLocation& location, const Interval& depth,
                              const Interval& reciprocalW, Interpolated* out) const {
  const Spot nominal = nominalSpot(place, location);
  Interval x{nominal.x, nominal.x, nominal.x}, y{nominal.y, nominal.y, nominal.y};
  if (rules_.openValues() && !shading_.certain) {
    // With sample shading at one of the samples of the invocation, and which samples those are is free; without, at the
    // centre, which lies between the samples.
    const auto include = [&](uint32_t sample) {
      const Spot spot = sampleOf(place, sample, location.pattern());
      x = {x.value, std::min(x.lo, spot.x), std::max(x.hi, spot.x)};
      y = {y.value, std::min(y.lo, spot.y), std::max(y.hi, spot.y)};
    };
    const Spot centre = centreOf(place);
    x.lo = x.hi = centre.x;
    y.lo = y.hi = centre.y;
    if (!shading_.enabled) include(place.sample);
    for (uint32_t s = 0; shading_.enabled && s < location.samples(); ++s) include(s);
  }
  if (rules_.error == DeliberateError::FragCoordInteger) {
    x.value = place.x;
    y.value = place.y;
  }
  if (rules_.error == DeliberateError::FragCoordYUp) y.value = height_ - y.value;
  if (rules_.error == DeliberateError::FragCoordNotAtSample) {
    x.value = centreOf(place).x;
    y.value = centreOf(place).y;
  }
  out[0] = toFloat(x);
  out[1] = toFloat(y);
  out[2] = toFloat(depth);
  out[3] = toFloat(reciprocalW);
  if (rules_.error == DeliberateError::FragCoordW) out[3].value = static_cast<float>(1 / reciprocalW.value);
}

void BuiltInValues::pointCoord(const FragmentPlace& place, const AttributeLocation& location, Interpolated* out) const {
  if (!isPoint_) {
    // [vk:interfaces-builtin-variables-pointcoord] undefined for all but points, a triangle drawn as points too.
    out[0] = out[1] = toFloat({0, -kUnbounded, kUnbounded});
    return;
  }
  const Spot nominal = nominalSpot(place, location);
  RegionStorage storage;
  const EvaluationRegion region{nominal, location.around(centreOf(place), storage).corners};
  const auto flipped = [](const Spot& spot) { return Spot{spot.y, spot.x}; };
  RegionStorage turned;
  for (size_t i = 0; i < region.corners.size(); ++i) turned.box[i] = flipped(region.corners[i]);
  out[0] = toFloat(pointS_.over(region));
  out[1] = toFloat(pointT_.over(EvaluationRegion{flipped(nominal), std::span<const Spot>(turned.box).first(region.corners.size())}));
}

Interpolated BuiltInValues::sampleMask(const FragmentPlace& place, const AttributeLocation& location) {
  const uint32_t own = 1U << place.sample, all = (1U << location.samples()) - 1;
  uint32_t mask = shading_.perSample ? own : (place.covered & all) | own;
  uint32_t certain = mask, possible = mask;
  if (rules_.openValues() && !shading_.certain) {
    // An invocation shades this sample, and perhaps others of the fragment.
    certain = own;
    possible = (place.covered & all) | own;
  }
  if (rules_.open && !(shading_.enabled && shading_.certain)) {
    const CoverageFreedom::Masks masks = coverage_.masks(place, location.pattern());
    // Once for all samples of the fragment, the one that it was evaluated for may be the one that is free.
    certain &= masks.certain | (shading_.perSample ? own : 0);
    possible |= masks.possible & sampleMask_ & all;
  }
  if (mask != all) count(Rule::CoverageMask);
  if (rules_.error == DeliberateError::SampleMaskInFull) mask = all;
  if (rules_.error == DeliberateError::SampleMaskInOwnBit) mask = own;
  if (rules_.error == DeliberateError::CoverageMaskShifted) mask = (mask << 1) & all;
  if (rules_.error == DeliberateError::CoverageMaskReversed) {
    uint32_t reversed = 0;
    for (uint32_t s = 0; s < location.samples(); ++s) reversed |= ((mask >> s) & 1U) << (location.samples() - 1 - s);
    mask = reversed;
  }
  return {static_cast<float>(mask), {static_cast<float>(certain), static_cast<float>(possible)}};
}

void BuiltInValues::evaluate(const FragmentPlace& place, const AttributeLocation& location, const Interval& depth,
                             const Interval& reciprocalW, Interpolated* out) {
  const uint32_t shown = rules_.error == DeliberateError::SampleIdZero ? 0 : place.sample;
  for (const BuiltIn builtIn : observed_) {
    switch (builtIn) {
      case BuiltIn::FragCoord:
        fragCoord(place, location, depth, reciprocalW, out);
        count(Rule::FragCoord);
        break;
      case BuiltIn::FrontFacing:
        *out = facing_;
        count(Rule::FrontFacing);
        break;
      case BuiltIn::PointCoord:
        pointCoord(place, location, out);
        if (isPoint_) count(Rule::PointCoord);
        break;
      case BuiltIn::SampleMask:
        *out = sampleMask(place, location);
        count(Rule::SampleMaskIn);
        break;
      case BuiltIn::SampleId: *out = exactly(static_cast<float>(shown)); break;
      case BuiltIn::SamplePosition:
        out[0] = exactly(static_cast<float>(location.pattern()[shown].x) / kSubpixelOne);
        out[1] = exactly(static_cast<float>(location.pattern()[shown].y) / kSubpixelOne);
        break;
    }
    out += builtInComponents(builtIn);
  }
}

void BuiltInValues::count(Rule rule) const {
  if (counts_ != nullptr) ++(*counts_)[rule];
}

}  // namespace rasterdiff::rasterizer
