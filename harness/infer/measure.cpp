#include "harness/infer/measure.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "harness/compare/ulp.hpp"
#include "harness/infer/experiments.hpp"
#include "harness/profile/sample_tables.hpp"

namespace rasterdiff::harness {
namespace {

using rasterizer::Rules;
using rasterizer::SampleTables;

SampleTables tablesOf(const Rules& rules) {
  return rules.choices.sampleLocations.value_or(standardTables());
}

// Draws one scene; nothing if the device does not offer it.
Result<std::optional<Observation>> observe(Subject& subject, Scene scene) {
  Result<Frame> frame = subject.render(scene);
  if (!frame && frame.error().code == ErrorCode::NotOffered) return std::nullopt;
  if (!frame) return tl::unexpected(frame.error());
  return Observation{std::move(scene), std::move(*frame)};
}

class Errors {
 public:
  Errors(std::string name) { measure_.name = std::move(name); }

  void add(float expected, float actual) {
    const double distance = ulpDistance(expected, actual);
    ++measure_.values;
    if (distance == 0) ++measure_.exact;
    if (!std::isfinite(distance)) return;
    measure_.maxUlp = std::max(measure_.maxUlp, distance);
    sum_ += distance;
  }
  [[nodiscard]] ErrorMeasure take() {
    measure_.meanUlp = measure_.values == 0 ? 0 : sum_ / static_cast<double>(measure_.values);
    return measure_;
  }

 private:
  ErrorMeasure measure_;
  double sum_ = 0;
};

// Where both sides have the same primitive.
void addErrors(const Frame& expected, const Frame& actual, Errors& smooth, Errors& linear, Errors& depth) {
  for (size_t i = 0; i < expected.primitive.data.size(); ++i) {
    const uint32_t primitive = expected.primitive.data[i];
    if (primitive == 0 || actual.primitive.data[i] != primitive) continue;
    depth.add(expected.depth->data[i], actual.depth->data[i]);
    for (size_t v = 0; v < 2; ++v) {
      const size_t components = expected.varyings[v].values.components;
      for (size_t c = 0; c < components; ++c) {
        const size_t at = i * components + c;
        (v == 0 ? smooth : linear).add(expected.varyings[v].values.data[at], actual.varyings[v].values.data[at]);
      }
    }
  }
}

}  // namespace

Result<SampleFinding> weighSamples(const Rules& rules, uint32_t samples, std::span<const Observation> observations) {
  const SampleTables tables = tablesOf(rules);
  SampleFinding finding;
  finding.samples = samples;
  finding.offsets.assign(tables.of(samples).begin(), tables.of(samples).end());
  const SampleTables standard = standardTables();
  finding.standard = std::ranges::equal(tables.of(samples), standard.of(samples));
  std::optional<uint64_t> least;
  for (uint32_t s = 0; s < samples; ++s) {
    for (const auto& [dx, dy] : {std::pair{-16, 0}, {16, 0}, {0, -16}, {0, 16}}) {
      const SampleTables::Offset& offset = finding.offsets[s];
      const int x = offset.x + dx, y = offset.y + dy;
      if (x < 0 || y < 0 || x > 255 || y > 255) continue;
      Rules moved = rules;
      moved.choices.sampleLocations = tables;
      moved.choices.sampleLocations->of(samples)[s] = {static_cast<uint8_t>(x), static_cast<uint8_t>(y)};
      uint64_t wrong = 0;
      for (const Observation& observation : observations) {
        if (observation.scene.target.samples != samples) continue;
        const Result<uint64_t> here = contradictions(observation, moved);
        if (!here) return tl::unexpected(here.error());
        wrong += *here;
      }
      least = std::min(least.value_or(wrong), wrong);
    }
  }
  finding.decidingEvents = least.value_or(0);
  return finding;
}

Result<ValueMeasures> measureValues(Subject& subject, const Rules& found, uint64_t seed,
                                    const std::function<void()>& finishedScene) {
  constexpr double kPlaceTolerance = 1.0 / 64;  // pixels
  constexpr int kErrorScenes = 6;
  ValueMeasures result;
  Prng random(seed);
  Rules rules = found;
  rules.openChoices = 0;
  rules.choices.valuesOpen = false;
  const uint32_t samples = sampleCounts(subject.limits()).back();
  for (const Interpolation interpolation :
       {Interpolation::smooth, Interpolation::noperspective, Interpolation::centroid, Interpolation::sample}) {
    for (const bool perspective : {false, true}) {
      if (samples == 1) continue;
      const auto observation = observe(subject, placeScene(random, samples, interpolation, perspective));
      if (!observation) return tl::unexpected(observation.error());
      if (!*observation) continue;
      const Result<uint64_t> wrong = contradictions(**observation, rules, kPlaceTolerance);
      if (!wrong) return tl::unexpected(wrong.error());
      result.decided = true;
      result.outside += *wrong;
      finishedScene();
    }
  }
  Errors smooth("smooth"), linear("noperspective"), depth("depth");
  for (int i = 0; i < kErrorScenes; ++i) {
    const auto observation = observe(subject, valueScene(random));
    if (!observation) return tl::unexpected(observation.error());
    if (!*observation) continue;
    const Result<Frame> expected = rasterizer::render((*observation)->scene, rules);
    if (!expected) return tl::unexpected(expected.error());
    addErrors(*expected, (*observation)->actual, smooth, linear, depth);
    finishedScene();
  }
  for (Errors* errors : {&smooth, &linear, &depth}) result.errors.push_back(errors->take());
  return result;
}

}  // namespace rasterdiff::harness
