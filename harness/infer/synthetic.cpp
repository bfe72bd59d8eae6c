#include "harness/infer/synthetic.hpp"

#include <algorithm>

#include "harness/infer/elimination.hpp"
#include "harness/profile/sample_tables.hpp"

namespace rasterdiff::harness {
namespace {

using rasterizer::Choice;
using rasterizer::SampleTables;

// Different places on the grid of 1/16 pixel, for the sample counts that are offered.
SampleTables someTables(Prng& random, const Limits& limits) {
  SampleTables tables = standardTables();
  for (const uint32_t samples : {1U, 2U, 4U, 8U, 16U}) {
    if ((limits.framebufferSampleCounts & samples) == 0) continue;
    const std::span<SampleTables::Offset> offsets = tables.of(samples);
    for (uint32_t s = 0; s < samples; ++s) {
      const auto taken = [&] { return std::find(offsets.begin(), offsets.begin() + s, offsets[s]) != offsets.begin() + s; };
      do {
        offsets[s] = {static_cast<uint8_t>(random.below(16) * 16), static_cast<uint8_t>(random.below(16) * 16)};
      } while (taken());
    }
  }
  return tables;
}

}  // namespace

rasterizer::Rules syntheticRules(uint64_t seed) {
  Prng random(seed);
  rasterizer::Rules rules;
  rules.name = "synthetic";
  for (const rasterizer::ChoiceInfo& row : rasterizer::choiceTable()) {
    const bool firstIsNone = row.choice == Choice::SubPixelBits || row.choice == Choice::ResolveArithmetic;
    const auto answers = static_cast<uint32_t>(row.answers.size());
    row.set(rules.choices, firstIsNone ? 1 + random.below(answers - 1) : random.below(answers));
  }
  if (random.chance(50)) rules.choices.sampleLocations = someTables(random, rules.limits);
  rules.choices = canonical(rules.choices, rules.limits);
  rules.limits.subPixelPrecisionBits = 4 + random.below(5);
  rules.limits.lineWidthMax = 8;
  rules.limits.pointSizeMax = 64;
  return rules;
}

}  // namespace rasterdiff::harness
