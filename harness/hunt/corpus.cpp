#include "harness/hunt/corpus.hpp"

#include <algorithm>
#include <limits>

namespace rasterdiff::harness::hunt {
namespace {

constexpr size_t kRules = static_cast<size_t>(rasterizer::Rule::Count_);
constexpr size_t kFacts = Traits{}.size() + kRules;
static_assert(kFacts * kFacts <= std::numeric_limits<Pair>::max());

}  // namespace

std::vector<Pair> pairsOf(const Traits& traits, const rasterizer::RuleCounts& counts) {
  std::vector<size_t> facts;
  for (size_t t = 0; t < traits.size(); ++t) {
    if (traits[t]) facts.push_back(t);
  }
  for (size_t r = 0; r < kRules; ++r) {
    if (counts.decided[r] > 0) facts.push_back(traits.size() + r);
  }
  std::vector<Pair> pairs;
  for (size_t a = 0; a < facts.size(); ++a) {
    for (size_t b = a; b < facts.size(); ++b) pairs.push_back(static_cast<Pair>(facts[a] * kFacts + facts[b]));
  }
  return pairs;
}

Corpus::Corpus() : seen_(kFacts * kFacts, 0) {}

bool Corpus::offer(Kept candidate) {
  size_t fresh = 0;
  for (const Pair pair : candidate.pairs) {
    if (pair >= seen_.size()) return false;
    if (seen_[pair]++ == 0) ++fresh;
  }
  pairs_ += fresh;
  if (fresh == 0) return false;
  kept_.push_back(std::move(candidate));
  return true;
}

uint32_t Corpus::rarity(const Kept& kept) const {
  uint32_t least = std::numeric_limits<uint32_t>::max();
  for (const Pair pair : kept.pairs) least = std::min(least, seen_[pair]);
  return least;
}

const Kept* Corpus::pick(Prng& random) const {
  if (kept_.empty()) return nullptr;
  const Kept* best = nullptr;
  constexpr int kContestants = 3;
  for (int i = 0; i < kContestants; ++i) {
    const Kept& contestant = kept_[random.below(kept_.size())];
    if (best == nullptr || rarity(contestant) < rarity(*best)) best = &contestant;
  }
  return best;
}

}  // namespace rasterdiff::harness::hunt
