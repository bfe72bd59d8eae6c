// The engine of inference: candidate rules meet the driver on experiments, and those that are contradicted go.
//
// A group is a set of choices that must be found together, because one experiment shows them all at once. Its candidates
// are all combinations of answers; every scene is drawn once by the driver and once by the reference under each candidate
// that is left. In the end each answer is weighed against its rivals: how often did the driver contradict them?
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "harness/infer/evidence.hpp"
#include "harness/infer/finding.hpp"
#include "harness/subject.hpp"
#include "scene/generators/prng.hpp"

namespace rasterdiff::harness {

/// `contenders`: candidates that are still possible, and (always where there is one only) rivals of the first one; a scene is worth drawing if it tells
/// some of them apart. None: nothing to ask in this round.
using Proposal =
    std::function<std::optional<Scene>(Prng& random, uint32_t round, std::span<const rasterizer::Rules> contenders)>;

struct Group {
  std::vector<rasterizer::Choice> choices;
  uint32_t rounds = 0;
  Proposal propose;
  double tolerance = 0;  ///< of values, instead of their intervals
  /// Completes a candidate by what follows from it (none: nothing does).
  std::function<void(rasterizer::Choices&)> complete{};
};

struct GroupOutcome {
  rasterizer::Choices choices{};    ///< the first candidate that is left, or was left last
  std::vector<Finding> findings{};  ///< one a choice
  std::vector<Observation> observations{};
};

/// `finishedScenes` is called after every experiment. Error: the driver's own (lost, timed out); what it does not offer
/// is no error but a finding.
[[nodiscard]] Result<GroupOutcome> eliminate(Subject& subject, const rasterizer::Rules& known, const Group& group,
                                             uint64_t seed, const std::function<void()>& finishedScene);

/// Answers that experiments can tell apart: of several combinations that always draw the same on a device with these limits,
/// the first.
[[nodiscard]] rasterizer::Choices canonical(rasterizer::Choices choices, const Limits& limits);

}  // namespace rasterdiff::harness
