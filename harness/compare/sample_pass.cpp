#include "harness/compare/sample_pass.hpp"

#include <algorithm>
#include <cstring>
#include <optional>

#include "harness/compare/ulp.hpp"
#include "harness/compare/value_tally.hpp"

namespace rasterdiff::harness {
namespace {

using rasterizer::Candidate;
using rasterizer::SampleQuery;

constexpr size_t kStretch = 128;  // samples
static_assert(kStretch % kTallyStep == 0);

template <class T>
bool alike(const Plane<T>& a, const Plane<T>& b) {
  return a.data.size() == b.data.size() && a.samples == b.samples && a.components == b.components && a.width == b.width;
}

}  // namespace

bool alike(const Frame& a, const Frame& b) {
  if (!alike(a.primitive, b.primitive) || !alike(a.count, b.count) || a.depth.has_value() != b.depth.has_value() ||
      a.varyings.size() != b.varyings.size() || a.resolved.size() != b.resolved.size()) {
    return false;
  }
  for (size_t v = 0; v < a.resolved.size(); ++v) {
    if (!alike(a.resolved[v].values, b.resolved[v].values)) return false;
  }
  for (size_t v = 0; v < a.varyings.size(); ++v) {
    if (!alike(a.varyings[v].values, b.varyings[v].values)) return false;
  }
  return true;
}

bool mayOverlapItself(const Scene& scene, const rasterizer::Rules& rules) {
  return rules.openValues() && scene.state.polygonMode != PolygonMode::FILL;
}

std::vector<ValuePlanes> valuePlanesOf(const Frame& reference, const Frame& actual) {
  std::vector<ValuePlanes> planes;
  if (reference.depth) planes.push_back({&*reference.depth, &*actual.depth, &*reference.depthBounds});
  for (size_t v = 0; v < reference.varyings.size(); ++v) {
    planes.push_back({&reference.varyings[v].values, &actual.varyings[v].values, &*reference.varyings[v].bounds});
  }
  return planes;
}

Bounds hull(Bounds a, Bounds b) { return {std::min(a.lo, b.lo), std::max(a.hi, b.hi)}; }

SamplePass::SamplePass(const Frame& reference, const Frame& actual, bool mayOverlapItself)
    : reference_(reference), actual_(actual), planes_(valuePlanesOf(reference, actual)), mayOverlapItself_(mayOverlapItself) {
  if (reference.depth) values.emplace_back("depth");
  for (const VaryingPlane& varying : reference.varyings) values.emplace_back(varying.name);
  for (const VaryingPlane& plane : reference.resolved) values.emplace_back(plane.name + ".resolved");
}

void SamplePass::run(size_t first, size_t end) {
  for (; first + kStretch <= end; first += kStretch) {
    if (!runStretch(first)) runOneByOne(first, first + kStretch);
  }
  runOneByOne(first, end);
}

void SamplePass::append(const SamplePass& later) {
  same += later.same;
  coveredSamples += later.coveredSamples;
  for (size_t plane = 0; plane < values.size(); ++plane) values[plane].append(later.values[plane]);
  questions.insert(questions.end(), later.questions.begin(), later.questions.end());
  overlaps.insert(overlaps.end(), later.overlaps.begin(), later.overlaps.end());
}

// False, and nothing is counted, where coverage is not the same or values may be a question.
bool SamplePass::runStretch(size_t first) {
  const std::optional<uint32_t> drawn =
      drawnIfAlike(reference_.primitive.data.data() + first, actual_.primitive.data.data() + first,
                   reference_.count.data.data() + first, actual_.count.data.data() + first, kStretch);
  if (!drawn) return false;
  for (size_t plane = 0; mayOverlapItself_ && plane < planes_.size(); ++plane) {
    const size_t components = planes_[plane].expected->components, from = first * components;
    const void *expected = planes_[plane].expected->data.data() + from, *actual = planes_[plane].actual->data.data() + from;
    if (std::memcmp(expected, actual, kStretch * components * sizeof(float)) != 0) return false;
  }
  same += kStretch;
  coveredSamples += *drawn;
  for (size_t plane = 0; plane < planes_.size(); ++plane) addValues(plane, first, *drawn);
  return true;
}

// Values of a stretch in which coverage is the same.
void SamplePass::addValues(size_t plane, size_t first, size_t drawn) {
  const auto& [expected, actual, legal] = planes_[plane];
  const size_t components = expected->components, from = first * components;
  const uint32_t* primitives = reference_.primitive.data.data() + first;
  ValueRun run{expected->data.data() + from, actual->data.data() + from, legal->data.data() + from, nullptr, kStretch * components};
  if (drawn < kStretch && components == 1) {
    run.drawn = primitives;
  } else if (drawn < kStretch) {
    drawnValues_.resize(run.values);
    for (size_t i = 0; i < kStretch; ++i) std::fill_n(drawnValues_.begin() + static_cast<std::ptrdiff_t>(i * components), components, primitives[i]);
    run.drawn = drawnValues_.data();
  }
  const auto placeOfValue = [&](size_t i) {
    const SampleQuery place = placeOf(first + i / components);
    return ValueAccumulator::Place{place.x, place.y, place.sample, static_cast<uint32_t>(i % components)};
  };
  ValueAccumulator& sum = values[plane];
  const std::optional<ValueTally> tally = tallyValues(run);
  if (!tally) {
    for (size_t i = 0; i < run.values; ++i) {
      if (primitives[i / components] != 0) {
        sum.add(placeOfValue(i), run.expected[i], run.actual[i], run.legal[i]);
      } else {
        sum.addUndrawn(placeOfValue(i), run.expected[i], run.actual[i], run.legal[i]);
      }
    }
    return;
  }
  if (!sum.addTally(*tally, drawn * components)) return;
  size_t worst = 0;  // the first of those with the largest distance
  while (std::memcmp(run.expected + worst, run.actual + worst, sizeof(float)) == 0 ||
         ulpDistance(run.expected[worst], run.actual[worst]) != tally->maxUlp) {
    ++worst;
  }
  sum.setWorst(placeOfValue(worst), run.expected[worst], run.actual[worst], run.legal[worst]);
}

void SamplePass::runOneByOne(size_t first, size_t end) {
  for (size_t i = first; i < end; ++i) {
    const uint32_t winner = reference_.primitive.data[i];
    if (winner != 0) ++coveredSamples;
    const bool alike = winner == actual_.primitive.data[i] && reference_.count.data[i] == actual_.count.data[i];
    if (alike) ++same;
    if (alike && planes_.empty()) continue;
    const SampleQuery place = placeOf(i);
    if (winner == actual_.primitive.data[i]) {
      if (winner != 0 && mayOverlapItself_ && !valuesFit(i)) {
        overlaps.push_back(place);
      } else {
        compareValues(place, i, winner != 0);
      }
    }
    if (!alike) questions.push_back(place);
  }
}

void SamplePass::compareValues(const SampleQuery& place, size_t index, bool drawn, const Candidate* also) {
  size_t varying = 0;
  for (size_t plane = 0; plane < planes_.size(); ++plane) {
    const auto& [expected, actual, legal] = planes_[plane];
    const bool depth = plane == 0 && reference_.depth.has_value();
    const size_t components = expected->components;
    for (size_t c = 0; c < components; ++c) {
      const size_t at = index * components + c;
      Bounds bounds = legal->data[at];
      if (also != nullptr) bounds = hull(bounds, depth ? also->depth : also->varyings[varying++]);
      const ValueAccumulator::Place valuePlace{place.x, place.y, place.sample, static_cast<uint32_t>(c)};
      if (drawn) {
        values[plane].add(valuePlace, expected->data[at], actual->data[at], bounds);
      } else {
        values[plane].addUndrawn(valuePlace, expected->data[at], actual->data[at], bounds);
      }
    }
  }
}

bool SamplePass::valuesFit(size_t index) const {
  for (const auto& [expected, actual, legal] : planes_) {
    const size_t components = expected->components;
    for (size_t at = index * components; at < (index + 1) * components; ++at) {
      if (!(actual->data[at] >= legal->data[at].lo && actual->data[at] <= legal->data[at].hi)) return false;
    }
  }
  return true;
}

SampleQuery SamplePass::placeOf(size_t index) const {
  const auto pixel = static_cast<uint32_t>(index / reference_.samples);
  return {pixel % reference_.width, pixel / reference_.width, static_cast<uint32_t>(index % reference_.samples)};
}

}  // namespace rasterdiff::harness
