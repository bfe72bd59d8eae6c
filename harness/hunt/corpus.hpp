// The scenes that showed something first, keyed by pairs of facts: rules that decided and traits of the scene. What is
// rare is mutated first.
#pragma once

#include <cstdint>
#include <vector>

#include "harness/hunt/traits.hpp"
#include "rasterizer/rule_counts.hpp"
#include "scene/generators/prng.hpp"

namespace rasterdiff::harness::hunt {

/// A pair of facts. Facts are numbered: traits first, then counted rules.
using Pair = uint16_t;

/// Every pair of the scene's traits and the rules that decided something in it.
[[nodiscard]] std::vector<Pair> pairsOf(const Traits& traits, const rasterizer::RuleCounts& counts);

struct Kept {
  Scene scene;
  std::vector<Pair> pairs;
};

class Corpus {
 public:
  Corpus();

  /// Counts the pairs; keeps the scene if one of them is new. Returns whether it was kept.
  bool offer(Kept candidate);
  /// One of the kept scenes, those with rare pairs more often; null if there is none.
  [[nodiscard]] const Kept* pick(Prng& random) const;
  [[nodiscard]] const std::vector<Kept>& kept() const { return kept_; }
  /// Number of different pairs that were offered.
  [[nodiscard]] size_t pairs() const { return pairs_; }

 private:
  [[nodiscard]] uint32_t rarity(const Kept& kept) const;

  std::vector<uint32_t> seen_;  ///< by pair
  std::vector<Kept> kept_;
  size_t pairs_ = 0;
};

}  // namespace rasterdiff::harness::hunt
