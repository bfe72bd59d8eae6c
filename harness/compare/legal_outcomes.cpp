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

// Plays candidates through the depth test on intervals, keeping every state that a sample may be in.
class Play {
 public:
  Play(const State& state, bool hasDepth, std::span<const Candidate> candidates, std::span<const Coverage> coverage)
      : state_(state), tests_(hasDepth && state.depthTestEnable), candidates_(candidates), coverage_(coverage) {}

  [[nodiscard]] std::vector<SampleState> run(Bounds clear) const {
    std::vector<SampleState> states{{0, clear, 0, 0}};
    for (size_t first = 0; first < candidates_.size();) {
      size_t end = first + 1;
      while (mayMakeSeveral() && end < candidates_.size() && candidates_[end].primitive == candidates_[first].primitive) ++end;
      states = end - first > kMostOrdered ? afterAny(states, first, end) : afterAll(states, first, end);
      first = end;
    }
    return states;
  }

 private:
  static constexpr size_t kMostOrdered = 8;  // 256 subsets

  // [vk:drawing-primitive-order] what a polygon mode makes of one triangle comes in any order.
  [[nodiscard]] bool mayMakeSeveral() const { return state_.polygonMode != PolygonMode::FILL; }

  void step(const std::vector<SampleState>& states, size_t i, std::vector<SampleState>& next) const {
    const Candidate& candidate = candidates_[i];
    for (const SampleState& before : states) {
      if (coverage_[i] == Coverage::Out) {
        addState(next, before);
        continue;
      }
      const bool mayPass = !tests_ || rasterizer::depthTestMayPass(state_.depthCompareOp, candidate.depth, before.stored);
      const bool mayFail = tests_ && rasterizer::depthTestMayFail(state_.depthCompareOp, candidate.depth, before.stored);
      if (coverage_[i] == Coverage::Either || mayFail) addState(next, before);
      if (mayPass) {
        SampleState after{candidate.primitive, before.stored, before.fewest + 1, before.most + 1};
        if (tests_ && state_.depthWriteEnable) after.stored = candidate.depth;
        addState(next, after);
      }
    }
  }

  // Candidates [first, end) in every order: the states after each subset of them.
  [[nodiscard]] std::vector<SampleState> afterAll(const std::vector<SampleState>& states, size_t first, size_t end) const {
    std::vector<std::vector<SampleState>> after(size_t{1} << (end - first));
    after[0] = states;
    for (size_t subset = 0; subset + 1 < after.size(); ++subset) {
      for (size_t i = first; i < end; ++i) {
        const size_t with = subset | size_t{1} << (i - first);
        if (with != subset) step(after[subset], i, after[with]);
      }
    }
    return std::move(after.back());
  }

  // More than can be ordered one by one: any number of them may have passed, and any may have been the last.
  [[nodiscard]] std::vector<SampleState> afterAny(const std::vector<SampleState>& states, size_t first, size_t end) const {
    std::vector<SampleState> next = states;
    for (const SampleState& before : states) {
      SampleState after{candidates_[first].primitive, before.stored, before.fewest + 1, before.most + static_cast<uint32_t>(end - first)};
      for (size_t i = first; i < end && tests_ && state_.depthWriteEnable; ++i) {
        after.stored = {std::min(after.stored.lo, candidates_[i].depth.lo), std::max(after.stored.hi, candidates_[i].depth.hi)};
      }
      addState(next, after);
    }
    return next;
  }

  const State& state_;
  const bool tests_;
  std::span<const Candidate> candidates_;
  std::span<const Coverage> coverage_;
};

bool reachable(const State& state, Bounds clear, bool hasDepth, std::span<const Candidate> candidates,
               std::span<const Coverage> coverage, uint32_t winner, uint32_t count) {
  const std::vector<SampleState> states = Play(state, hasDepth, candidates, coverage).run(clear);
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

// Nobody's coverage is free: the order in which one triangle's lines or points come was, or the order by depth.
Freedom explanation(const State& state, std::span<const Candidate> candidates) {
  Freedom freedom = Freedom::None;
  bool several = false;
  for (size_t i = 0; i < candidates.size(); ++i) {
    freedom = std::max(freedom, candidates[i].freedom);
    several = several || (i > 0 && candidates[i].primitive == candidates[i - 1].primitive);
  }
  if (freedom != Freedom::None) return freedom;
  return several && state.polygonMode != PolygonMode::FILL ? Freedom::PrimitiveOrder : Freedom::Evaluation;
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
    if (outcome.legal) outcome.freedom = explanation(state, candidates);
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
  if (outcome.legal) outcome.freedom = explanation(state, candidates);
  return outcome;
}

}  // namespace rasterdiff::harness
