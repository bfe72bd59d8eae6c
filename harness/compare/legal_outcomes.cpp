#include "harness/compare/legal_outcomes.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "rasterizer/depth_test.hpp"

namespace rasterdiff::harness {
namespace {

using rasterizer::Candidate;
using rasterizer::Freedom;

// What a sample may hold after some primitives: who won, what depth is stored, how many wrote.
struct SampleState {
  uint32_t winner = 0;
  Bounds stored;
  uint32_t fewest = 0, most = 0;
};

void addState(std::vector<SampleState>& states, const SampleState& state) {
  for (SampleState& known : states) {
    if (known.winner != state.winner) continue;
    known.stored = {std::min(known.stored.lo, state.stored.lo), std::max(known.stored.hi, state.stored.hi)};
    known.fewest = std::min(known.fewest, state.fewest);
    known.most = std::max(known.most, state.most);
    return;
  }
  states.push_back(state);
}

bool reachable(const State& state, Bounds clear, bool hasDepth, std::span<const Candidate> candidates,
               std::span<const Coverage> coverage, uint32_t winner, uint32_t count) {
  std::vector<SampleState> states{{0, clear, 0, 0}};
  const bool tests = hasDepth && state.depthTestEnable;
  for (size_t i = 0; i < candidates.size(); ++i) {
    if (coverage[i] == Coverage::Out) continue;
    const Candidate& candidate = candidates[i];
    std::vector<SampleState> next;
    for (const SampleState& before : states) {
      const bool mayPass = !tests || rasterizer::depthTestMayPass(state.depthCompareOp, candidate.depth, before.stored);
      const bool mayFail = tests && rasterizer::depthTestMayFail(state.depthCompareOp, candidate.depth, before.stored);
      if (coverage[i] == Coverage::Either || mayFail) addState(next, before);
      if (mayPass) {
        SampleState after{candidate.primitive, before.stored, before.fewest + 1, before.most + 1};
        if (tests && state.depthWriteEnable) after.stored = candidate.depth;
        addState(next, after);
      }
    }
    states = std::move(next);
  }
  return std::any_of(states.begin(), states.end(), [&](const SampleState& s) {
    return s.winner == winner && s.fewest <= count && count <= s.most;
  });
}

// Pairs of candidates on the two sides of one edge.
std::vector<std::pair<size_t, size_t>> sharedTies(std::span<const Candidate> candidates) {
  std::vector<std::pair<size_t, size_t>> pairs;
  std::vector<bool> used(candidates.size());
  for (size_t i = 0; i < candidates.size(); ++i) {
    for (size_t j = i + 1; j < candidates.size() && !used[i]; ++j) {
      const auto& a = candidates[i].tieEdge;
      const auto& b = candidates[j].tieEdge;
      if (used[j] || !a || !b || (*a)[0] != (*b)[1] || (*a)[1] != (*b)[0]) continue;
      pairs.emplace_back(i, j);
      used[i] = used[j] = true;
    }
  }
  return pairs;
}

// Without a depth test: all that cover count, and the last of them wins. Exact for any number of ties, in linear time.
class InDrawingOrder {
 public:
  InDrawingOrder(std::span<const Candidate> candidates, std::span<const std::pair<size_t, size_t>> ties)
      : candidates_(candidates), partner_(candidates.size(), candidates.size()) {
    for (const auto& [a, b] : ties) {
      partner_[a] = b;
      partner_[b] = a;
    }
  }

  [[nodiscard]] bool reaches(uint32_t winner, uint32_t count) const {
    if (winner == 0) return reachesWithLast(none(), count);
    for (size_t i = 0; i < candidates_.size(); ++i) {
      if (candidates_[i].primitive == winner && candidates_[i].coverage != Coverage::Out && reachesWithLast(i, count)) return true;
    }
    return false;
  }

 private:
  [[nodiscard]] size_t none() const { return candidates_.size(); }

  // `last` covers, or nothing does; nothing after it does; one of each pair does.
  [[nodiscard]] bool reachesWithLast(size_t last, uint32_t count) const {
    const auto isOut = [&](size_t i) { return last == none() || i > last; };
    uint32_t fewest = 0, most = 0;
    for (size_t i = 0; i < candidates_.size(); ++i) {
      const size_t partner = partner_[i];
      const bool paired = partner != none();
      if (isOut(i)) {
        if (paired ? isOut(partner) : candidates_[i].coverage == Coverage::In) return false;
        continue;
      }
      if (candidates_[i].coverage == Coverage::Out || (paired && i != last && partner == last)) continue;
      if (paired && i != last && !isOut(partner) && partner < i) continue;  // counted with its partner
      ++most;
      if (i == last || paired || candidates_[i].coverage == Coverage::In) ++fewest;
    }
    return fewest <= count && count <= most;
  }

  std::span<const Candidate> candidates_;
  std::vector<size_t> partner_;  ///< none(): not on a shared edge
};

Freedom explanation(std::span<const Candidate> candidates) {
  Freedom freedom = Freedom::None;
  for (const Candidate& candidate : candidates) freedom = std::max(freedom, candidate.freedom);
  // Nobody's coverage is free: the order by depth was.
  return freedom == Freedom::None ? Freedom::Evaluation : freedom;
}

}  // namespace

Outcome judgeOutcome(const State& state, Bounds clearDepth, bool hasDepth, std::span<const Candidate> candidates,
                     uint32_t winner, uint32_t count) {
  Outcome outcome;
  std::vector<Coverage> coverage;
  for (const Candidate& candidate : candidates) {
    coverage.push_back(candidate.coverage);
    if (candidate.primitive == winner) outcome.winner = &candidate;
  }
  const std::vector<std::pair<size_t, size_t>> pairs = sharedTies(candidates);
  if (!hasDepth || !state.depthTestEnable) {
    outcome.legal = InDrawingOrder(candidates, pairs).reaches(winner, count);
    if (outcome.legal) outcome.freedom = explanation(candidates);
    return outcome;
  }
  constexpr size_t kMostPairs = 16;  // 65,536 assignments; further pairs stay free
  const size_t decided = std::min(pairs.size(), kMostPairs);
  for (uint32_t assignment = 0; assignment < (1U << decided) && !outcome.legal; ++assignment) {
    for (size_t k = 0; k < decided; ++k) {
      const bool first = (assignment & (1U << k)) != 0;
      coverage[pairs[k].first] = first ? Coverage::In : Coverage::Out;
      coverage[pairs[k].second] = first ? Coverage::Out : Coverage::In;
    }
    outcome.legal = reachable(state, clearDepth, hasDepth, candidates, coverage, winner, count);
  }
  if (outcome.legal) outcome.freedom = explanation(candidates);
  return outcome;
}

}  // namespace rasterdiff::harness
