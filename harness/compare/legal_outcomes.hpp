// Which (winner, overdraw) outcomes of one sample are legal, given every primitive that may cover it.
#pragma once

#include <span>

#include "rasterizer/render.hpp"

namespace rasterdiff::harness {

struct Outcome {
  bool legal = false;
  rasterizer::Freedom freedom = rasterizer::Freedom::None;  ///< what explains it, where it is legal
  const rasterizer::Candidate* winner = nullptr;            ///< the candidate that the outcome names; null for none
};

/// Plays all candidates in drawing order through the depth test on intervals, keeping every state that can be reached;
/// `clearDepth` is what the attachment may hold before them. Candidates with opposite tie edges cover one at a time.
/// Never calls a reachable outcome illegal.
[[nodiscard]] Outcome judgeOutcome(const State& state, Bounds clearDepth, bool hasDepth,
                                   std::span<const rasterizer::Candidate> candidates, uint32_t winner, uint32_t count);

}  // namespace rasterdiff::harness
