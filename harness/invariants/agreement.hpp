// How frames are compared with each other: sample by sample, or byte by byte.
#pragma once

#include <functional>

#include "harness/invariants/invariant.hpp"

namespace rasterdiff::harness::invariants {

/// What is wrong with a sample, given its index in the planes of primitives and counts; empty: nothing.
using SampleCheck = std::function<std::string(size_t index, uint32_t x, uint32_t y)>;

[[nodiscard]] Agreement checkSamples(const Frame& frame, const SampleCheck& check);

/// The same primitive and count at every sample.
[[nodiscard]] Agreement sameCoverage(const Frame& a, const Frame& b);

/// The same bits in every plane that both have.
[[nodiscard]] Agreement sameBytes(const Frame& a, const Frame& b);

/// A case of two scenes.
[[nodiscard]] Case pairOf(Scene a, Scene b, Agreement (*agree)(const Frame&, const Frame&));

/// A valid random scene of a family of the hunt.
[[nodiscard]] Scene validScene(std::string_view family, Prng& random, const Limits& limits);

}  // namespace rasterdiff::harness::invariants
