// A lane: a few dozen scenes in a row, decided by a seed, the corpus it starts from and what is known already. Lanes do
// not see each other, so that any number of processes gives the same result.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "harness/hunt/corpus.hpp"
#include "harness/hunt/judge.hpp"
#include "harness/hunt/random_scene.hpp"

namespace rasterdiff::harness::hunt {

/// What a finding is called: the kind of wrong answer and the traits of its scene.
struct Signature {
  std::string kind;
  Traits traits;
  friend bool operator==(const Signature&, const Signature&) = default;
};

/// A scene that shows a difference, as it was found.
struct Raw {
  Scene scene;
  Signature signature;
  Verdict verdict = Verdict::Differs;
};

struct Tally {
  uint64_t scenes = 0, skipped = 0, same = 0, allowed = 0, differing = 0, lost = 0;
  uint64_t samples = 0, values = 0;
  rasterizer::RuleCounts decided;
  Tally& operator+=(const Tally& other);
};

struct LaneOptions {
  const Family* family = nullptr;
  Limits limits;
  uint64_t seed = 1;
  uint64_t lane = 0;
  uint32_t scenes = 32;
  std::span<const Signature> avoid{};  ///< found already: scenes that would show it again are mostly made anew
};

struct LaneResult {
  std::vector<Kept> kept;  ///< scenes that showed a pair first
  std::vector<Raw> raw;    ///< one a signature
  Tally tally;
};

/// Ends early where the driver was lost: the process is then of no more use to another lane.
[[nodiscard]] LaneResult searchLane(const Corpus& corpus, const LaneOptions& options, const Judge& judge);

}  // namespace rasterdiff::harness::hunt
