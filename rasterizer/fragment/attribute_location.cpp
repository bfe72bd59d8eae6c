#include "rasterizer/fragment/attribute_location.hpp"

#include <bit>
#include <cmath>

namespace rasterdiff::rasterizer {
namespace {

std::array<Spot, 4> boxOf(double left, double top, double right, double bottom) {
  return {{{left, top}, {right, top}, {left, bottom}, {right, bottom}}};
}

// Keeps of a convex polygon what has sign · (coordinate - bound) >= 0.
void keep(std::vector<Spot>& polygon, std::vector<Spot>& scratch, double Spot::*axis, double sign, double bound) {
  scratch.clear();
  for (size_t i = 0; i < polygon.size(); ++i) {
    const Spot& a = polygon[i];
    const Spot& b = polygon[(i + 1) % polygon.size()];
    const double da = sign * (a.*axis - bound), db = sign * (b.*axis - bound);
    if (da >= 0) scratch.push_back(a);
    if ((da >= 0) == (db >= 0)) continue;
    const double t = da / (da - db);
    Spot crossing{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
    crossing.*axis = bound;
    scratch.push_back(crossing);
  }
  polygon.swap(scratch);
}

void clipToPixel(const FragmentPlace& place, const std::vector<RasterVertex>& polygon, RegionStorage& storage) {
  storage.polygon.clear();
  for (const RasterVertex& vertex : polygon) storage.polygon.push_back({vertex.position.x, vertex.position.y});
  keep(storage.polygon, storage.scratch, &Spot::x, 1, place.x);
  keep(storage.polygon, storage.scratch, &Spot::x, -1, place.x + 1.0);
  keep(storage.polygon, storage.scratch, &Spot::y, 1, place.y);
  keep(storage.polygon, storage.scratch, &Spot::y, -1, place.y + 1.0);
}

}  // namespace

EvaluationOffset evaluationOffset(float x, float y, const Rules& rules) {
  EvaluationOffset offset;
  const double sign = rules.error == DeliberateError::OffsetFlipped ? -1 : 1;
  offset.nominal = {sign * double{x}, sign * double{y}};
  const double steps = std::ldexp(1.0, static_cast<int>(rules.limits.subPixelInterpolationOffsetBits));
  const double left = std::floor(x * steps) / steps, right = std::ceil(x * steps) / steps;
  const double top = std::floor(y * steps) / steps, bottom = std::ceil(y * steps) / steps;
  if (rules.variation && rules.variation->offset == Variation::Offset::Down) offset.nominal = {left, top};
  if (rules.variation && rules.variation->offset == Variation::Offset::Up) offset.nominal = {right, bottom};
  offset.corners = boxOf(left, top, right, bottom);
  offset.free = rules.openValues() && (left != right || top != bottom);
  return offset;
}

AttributeLocation::AttributeLocation(std::vector<SubpixelPosition> pattern, const Rules& rules)
    : pattern_(std::move(pattern)), centroid_(rules.choices.centroid), areaIsFree_(rules.openValues() && pattern_.size() > 1),
      error_(rules.error), variation_(rules.variation) {}

EvaluationRegion AttributeLocation::around(Spot centre, RegionStorage& storage) const {
  if (error_ == DeliberateError::CentreAtCorner && samples() == 1) return {{centre.x - 0.5, centre.y - 0.5}, {}};
  if (!areaIsFree_) return {centre, {}};
  storage.box = boxOf(centre.x - 0.5, centre.y - 0.5, centre.x + 0.5, centre.y + 0.5);
  return {centre, storage.box};
}

EvaluationRegion AttributeLocation::atSample(const FragmentPlace& place) const {
  return {error_ == DeliberateError::SampleAtCentre ? centreOf(place) : sampleOf(place, place.sample, pattern_), {}};
}

uint32_t AttributeLocation::firstCovered(const FragmentPlace& place) const {
  if (error_ == DeliberateError::CentroidUncovered) return static_cast<uint32_t>(std::countr_one(place.covered));
  return place.covered == 0 ? place.sample : static_cast<uint32_t>(std::countr_zero(place.covered));
}

Spot AttributeLocation::meanOfCovered(const FragmentPlace& place) const {
  Spot sum;
  uint32_t count = 0;
  for (uint32_t s = 0; s < samples(); ++s) {
    if ((place.covered & (1U << s)) == 0) continue;
    const Spot spot = sampleOf(place, s, pattern_);
    sum = {sum.x + spot.x, sum.y + spot.y};
    ++count;
  }
  return count == 0 ? sampleOf(place, place.sample, pattern_) : Spot{sum.x / count, sum.y / count};
}

Spot AttributeLocation::nominalCentroid(const FragmentPlace& place) const {
  if (samples() == 1 || error_ == DeliberateError::CentroidIgnored) return centreOf(place);
  const uint32_t all = (1U << samples()) - 1;
  switch (centroid_) {
    case CentroidPosition::CentreOrFirst:
      if ((place.covered & all) == all) return centreOf(place);
      break;
    case CentroidPosition::First: break;
    case CentroidPosition::Mean: return meanOfCovered(place);
  }
  return sampleOf(place, firstCovered(place), pattern_);
}

Spot AttributeLocation::variedCentroid(const FragmentPlace& place) const {
  const uint32_t covered = place.covered & ((1U << samples()) - 1);
  if (samples() == 1 || covered == 0) return centreOf(place);
  const bool whole = std::popcount(covered) == static_cast<int>(samples());
  switch (variation_->centroid) {
    case Variation::Centroid::CentreOrFirst:
      return whole ? centreOf(place) : sampleOf(place, static_cast<uint32_t>(std::countr_zero(covered)), pattern_);
    case Variation::Centroid::Last: return sampleOf(place, static_cast<uint32_t>(std::bit_width(covered)) - 1, pattern_);
    case Variation::Centroid::Mean: break;
  }
  Spot mean;
  for (uint32_t s = 0; s < samples(); ++s) {
    if ((covered >> s & 1U) == 0) continue;
    const Spot spot = sampleOf(place, s, pattern_);
    mean = {mean.x + spot.x / std::popcount(covered), mean.y + spot.y / std::popcount(covered)};
  }
  return mean;
}

Spot AttributeLocation::variedCentre(const FragmentPlace& place) const {
  const Spot centre = centreOf(place);
  if (!variation_ || samples() == 1) return centre;
  if (variation_->attributesAtSamples) return sampleOf(place, place.sample, pattern_);
  return {centre.x + double{variation_->attributeX}, centre.y + double{variation_->attributeY}};
}

EvaluationRegion AttributeLocation::centroid(const FragmentPlace& place, const Primitive& primitive,
                                             RegionStorage& storage) const {
  const Spot nominal = variation_ ? variedCentroid(place) : nominalCentroid(place);
  if (!areaIsFree_) return {nominal, {}};
  if (primitive.polygon.size() < 3) return {nominal, around(centreOf(place), storage).corners};
  clipToPixel(place, primitive.polygon, storage);
  return {nominal, storage.polygon};
}

EvaluationRegion AttributeLocation::at(const FragmentPlace& place, const EvaluationOffset& offset,
                                       RegionStorage& storage) const {
  const Spot centre = centreOf(place);
  const Spot nominal{centre.x + offset.nominal.x, centre.y + offset.nominal.y};
  if (!offset.free) return {nominal, {}};
  for (size_t i = 0; i < 4; ++i) storage.box[i] = {centre.x + offset.corners[i].x, centre.y + offset.corners[i].y};
  return {nominal, storage.box};
}

}  // namespace rasterdiff::rasterizer
