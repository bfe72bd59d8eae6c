// The groups of choices that are found together, and the experiments for each.
#pragma once

#include "harness/infer/elimination.hpp"
#include "harness/infer/sample_sweep.hpp"

namespace rasterdiff::harness {

struct Question {
  std::string_view what;  ///< "subpixel grid", for progress
  Group group;
};

/// Who owns samples on edges; sample locations follow from the sweeps under each answer.
[[nodiscard]] Question tieQuestion(const Limits& limits, std::vector<SampleSweep> sweeps);

/// All other questions, in an order in which each needs only what was found before it.
[[nodiscard]] std::vector<Question> furtherQuestions(const Limits& limits);

}  // namespace rasterdiff::harness
