#include "harness/invariants/agreement.hpp"

#include <fmt/format.h>

#include <cstring>

#include "harness/hunt/random_scene.hpp"

namespace rasterdiff::harness::invariants {
namespace {

/// The first value of a plane that is not the same bits, as a broken agreement.
template <class T>
bool samePlane(const Plane<T>& a, const Plane<T>& b, const std::string& name, Agreement& agreement) {
  if (agreement.broken) return false;
  if (a.data.size() != b.data.size()) {
    agreement.broken = Broken{0, 0, 0, fmt::format("{} has another size", name)};
    return false;
  }
  for (size_t i = 0; i < a.data.size(); ++i) {
    if (std::memcmp(&a.data[i], &b.data[i], sizeof(T)) == 0) continue;
    const size_t sample = i / a.components, pixel = sample / a.samples;
    agreement.broken = Broken{static_cast<uint32_t>(pixel % a.width), static_cast<uint32_t>(pixel / a.width), static_cast<uint32_t>(sample % a.samples),
                              fmt::format("{} is {} and {}", name, a.data[i], b.data[i])};
    return false;
  }
  return true;
}

}  // namespace

Agreement checkSamples(const Frame& frame, const SampleCheck& check) {
  Agreement agreement{frame.primitive.data.size(), {}};
  for (uint32_t y = 0; y < frame.height; ++y) {
    for (uint32_t x = 0; x < frame.width; ++x) {
      for (uint32_t s = 0; s < frame.samples; ++s) {
        std::string wrong = check(frame.primitive.index(x, y, s), x, y);
        if (wrong.empty()) continue;
        agreement.broken = Broken{x, y, s, std::move(wrong)};
        return agreement;
      }
    }
  }
  return agreement;
}

Agreement sameCoverage(const Frame& a, const Frame& b) {
  Agreement agreement{a.primitive.data.size(), {}};
  samePlane(a.primitive, b.primitive, "primitive", agreement);
  samePlane(a.count, b.count, "count", agreement);
  return agreement;
}

Agreement sameBytes(const Frame& a, const Frame& b) {
  Agreement agreement = sameCoverage(a, b);
  if (a.depth && b.depth) samePlane(*a.depth, *b.depth, "depth", agreement);
  for (size_t v = 0; v < std::min(a.varyings.size(), b.varyings.size()); ++v) {
    samePlane(a.varyings[v].values, b.varyings[v].values, a.varyings[v].name, agreement);
  }
  for (size_t v = 0; v < std::min(a.resolved.size(), b.resolved.size()); ++v) {
    samePlane(a.resolved[v].values, b.resolved[v].values, a.resolved[v].name + ".resolved", agreement);
  }
  return agreement;
}

Case pairOf(Scene a, Scene b, Agreement (*agree)(const Frame&, const Frame&)) {
  Case result;
  result.scenes = {std::move(a), std::move(b)};
  result.agree = [agree](std::span<const Frame> frames) { return agree(frames[0], frames[1]); };
  return result;
}

Scene validScene(std::string_view family, Prng& random, const Limits& limits) {
  const hunt::Family* known = hunt::familyByName(family);
  for (;;) {
    Scene scene = hunt::randomScene(*known, limits, random);
    if (validate(scene)) return scene;
  }
}

}  // namespace rasterdiff::harness::invariants
