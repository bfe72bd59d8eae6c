#include "harness/report/sample_mark.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace rasterdiff::harness {
namespace {

/// How far inside its legal interval a value lies: an error below a tenth, below a half, up to the whole of the way.
SampleMark markOfValue(float expected, float actual, const Bounds& bounds) {
  if (!(actual >= bounds.lo && actual <= bounds.hi)) return SampleMark::Differs;
  const double room = actual > expected ? double{bounds.hi} - expected : double{expected} - bounds.lo;
  const double share = room > 0 ? std::abs(double{actual} - expected) / room : 0;
  return share < 0.1 ? SampleMark::ValueClose : share < 0.5 ? SampleMark::ValueHalfway : SampleMark::ValueFar;
}

/// Same bits, else by the bounds. Planes without bounds allow nothing but the same bits.
SampleMark markOfValues(const Plane<float>& expected, const std::optional<Plane<Bounds>>& bounds, const Plane<float>& actual,
                  size_t sample) {
  SampleMark mark = SampleMark::Same;
  for (uint32_t c = 0; c < expected.components; ++c) {
    const size_t at = sample * expected.components + c;
    if (std::bit_cast<uint32_t>(expected.data[at]) == std::bit_cast<uint32_t>(actual.data[at])) continue;
    if (!bounds) return SampleMark::Differs;
    mark = std::max(mark, markOfValue(expected.data[at], actual.data[at], bounds->data[at]));
  }
  return mark;
}

}  // namespace

SampleMark SampleMarker::markOf(size_t sample) const {
  if (reference_.primitive.data[sample] != actual_.primitive.data[sample] ||
      reference_.count.data[sample] != actual_.count.data[sample]) {
    if (onlyAllowed_) return SampleMark::Allowed;
    if (onlyDiffers_ || !reference_.coverage) return SampleMark::Differs;
    return reference_.coverage->data[sample] == Coverage::Either ? SampleMark::Allowed : SampleMark::Differs;
  }
  if (reference_.primitive.data[sample] == 0) return SampleMark::Empty;
  SampleMark mark = SampleMark::Same;
  if (reference_.depth && actual_.depth) {
    mark = markOfValues(*reference_.depth, reference_.depthBounds, *actual_.depth, sample);
  }
  const size_t varyings = std::min(reference_.varyings.size(), actual_.varyings.size());
  for (size_t v = 0; v < varyings; ++v) {
    const VaryingPlane& expected = reference_.varyings[v];
    mark = std::max(mark, markOfValues(expected.values, expected.bounds, actual_.varyings[v].values, sample));
  }
  return mark;
}

SampleMark SampleMarker::markOfResolved(size_t pixel) const {
  SampleMark mark = SampleMark::Empty;
  const size_t planes = std::min(reference_.resolved.size(), actual_.resolved.size());
  for (size_t v = 0; v < planes; ++v) {
    const VaryingPlane& expected = reference_.resolved[v];
    const SampleMark value = markOfValues(expected.values, expected.bounds, actual_.resolved[v].values, pixel);
    if (value != SampleMark::Same) mark = std::max(mark, value);
  }
  return mark;
}

}  // namespace rasterdiff::harness
