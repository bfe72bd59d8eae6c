// What is measured rather than chosen: sample locations against moved ones, places of inputs, errors of values in ULPs.
#pragma once

#include <functional>
#include <span>

#include "harness/infer/evidence.hpp"
#include "harness/infer/finding.hpp"
#include "harness/subject.hpp"

namespace rasterdiff::harness {

/// How often observations with this sample count contradict each sample moved by 1/16 pixel: the least of all.
[[nodiscard]] Result<SampleFinding> weighSamples(const rasterizer::Rules& rules, uint32_t samples,
                                                 std::span<const Observation> observations);

struct ValueMeasures {
  bool decided = false;   ///< some multisampled input was observed
  uint64_t outside = 0;   ///< samples with an input evaluated elsewhere than the rules say
  std::vector<ErrorMeasure> errors{};
};

/// Draws inputs of every kind. Error: the driver's own.
[[nodiscard]] Result<ValueMeasures> measureValues(Subject& subject, const rasterizer::Rules& rules, uint64_t seed,
                                                  const std::function<void()>& finishedScene);

}  // namespace rasterdiff::harness
