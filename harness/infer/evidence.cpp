#include "harness/infer/evidence.hpp"

#include <cmath>

namespace rasterdiff::harness {
namespace {

bool outside(float actual, float expected, Bounds legal, double tolerance) {
  if (tolerance > 0) return !(std::fabs(double{actual} - expected) <= tolerance);
  return !(actual >= legal.lo && actual <= legal.hi);
}

/// Values of one sample.
class ValueCheck {
 public:
  ValueCheck(const Frame& expected, const Frame& actual, double tolerance)
      : expected_(expected), actual_(actual), tolerance_(tolerance) {}

  [[nodiscard]] bool contradicts(size_t sample) const {
    if (expected_.depth &&
        outside(actual_.depth->data[sample], expected_.depth->data[sample], expected_.depthBounds->data[sample], 0)) {
      return true;
    }
    for (size_t v = 0; v < expected_.varyings.size(); ++v) {
      if (plane(expected_.varyings[v], actual_.varyings[v], sample, tolerance_)) return true;
    }
    return false;
  }

  static bool plane(const VaryingPlane& expected, const VaryingPlane& actual, size_t place, double tolerance) {
    const size_t components = expected.values.components;
    for (size_t i = place * components; i < (place + 1) * components; ++i) {
      if (outside(actual.values.data[i], expected.values.data[i], expected.bounds->data[i], tolerance)) return true;
    }
    return false;
  }

 private:
  const Frame& expected_;
  const Frame& actual_;
  double tolerance_;
};

}  // namespace

Result<uint64_t> contradictions(const Observation& observation, const rasterizer::Rules& rules, double tolerance) {
  const Result<Frame> expected = rasterizer::render(observation.scene, rules);
  if (!expected) return tl::unexpected(expected.error());
  const Frame& actual = observation.actual;
  const ValueCheck values(*expected, actual, tolerance);
  uint64_t count = 0;
  for (size_t i = 0; i < actual.primitive.data.size(); ++i) {
    const uint32_t primitive = expected->primitive.data[i];
    const bool same = primitive == actual.primitive.data[i] && expected->count.data[i] == actual.count.data[i];
    if (!same || (primitive != 0 && values.contradicts(i))) ++count;
  }
  for (size_t v = 0; v < expected->resolved.size(); ++v) {
    const Plane<float>& means = expected->resolved[v].values;
    for (size_t pixel = 0; pixel < size_t{means.width} * means.height; ++pixel) {
      if (ValueCheck::plane(expected->resolved[v], actual.resolved[v], pixel, tolerance)) ++count;
    }
  }
  return count;
}

bool differ(const Frame& a, const Frame& b) {
  if (a.primitive.data != b.primitive.data || a.count.data != b.count.data) return true;
  if (a.depth && a.depth->data != b.depth->data) return true;
  for (size_t v = 0; v < a.varyings.size(); ++v) {
    if (a.varyings[v].values.data != b.varyings[v].values.data) return true;
  }
  return false;
}

}  // namespace rasterdiff::harness
