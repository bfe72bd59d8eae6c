// judgeOutcome: which winner and overdraw a sample may have. Small cases by hand, and all cases against brute force.
#include "harness/compare/legal_outcomes.hpp"

#include <gtest/gtest.h>

#include <random>
#include <set>
#include <vector>

#include "rasterizer/depth_test.hpp"

namespace rasterdiff::harness {
namespace {

using rasterizer::Candidate;
using rasterizer::Freedom;

constexpr SubpixelPosition kA{0, 0}, kB{256, 512}, kC{512, 0};

Candidate certain(uint32_t primitive, Bounds depth = {}) {
  Candidate candidate;
  candidate.primitive = primitive;
  candidate.depth = depth;
  return candidate;
}

Candidate maybe(uint32_t primitive, Freedom freedom = Freedom::SnapRounding, Bounds depth = {}) {
  Candidate candidate = certain(primitive, depth);
  candidate.coverage = Coverage::Either;
  candidate.freedom = freedom;
  return candidate;
}

Candidate tie(uint32_t primitive, SubpixelPosition from, SubpixelPosition to) {
  Candidate candidate = maybe(primitive, Freedom::TieOwner);
  candidate.tieEdge = {from, to};
  return candidate;
}

Outcome judge(const std::vector<Candidate>& candidates, uint32_t winner, uint32_t count) {
  return judgeOutcome(State{}, {1, 1}, false, candidates, winner, count);
}

bool legal(const std::vector<Candidate>& candidates, uint32_t winner, uint32_t count) {
  return judge(candidates, winner, count).legal;
}

State depthState(CompareOp op, bool write = true) {
  State state;
  state.depthTestEnable = true;
  state.depthWriteEnable = write;
  state.depthCompareOp = op;
  return state;
}

TEST(Outcome, NothingThereLeavesNothing) {
  EXPECT_TRUE(legal({}, 0, 0));
  EXPECT_FALSE(legal({}, 3, 1));
  EXPECT_FALSE(legal({}, 0, 1));
}

TEST(Outcome, CertainPrimitivesAllCountAndTheLastOneWins) {
  const std::vector<Candidate> both{certain(2), certain(5)};
  EXPECT_TRUE(legal(both, 5, 2));
  EXPECT_FALSE(legal(both, 2, 2));
  EXPECT_FALSE(legal(both, 5, 1));
  EXPECT_FALSE(legal(both, 5, 3));
  EXPECT_FALSE(legal(both, 0, 0));
}

TEST(Outcome, FreePrimitiveMayBeThereOrNot) {
  const std::vector<Candidate> one{certain(2), maybe(5)};
  EXPECT_TRUE(legal(one, 5, 2));
  EXPECT_TRUE(legal(one, 2, 1));
  EXPECT_FALSE(legal(one, 5, 1));
  EXPECT_FALSE(legal(one, 2, 2));
}

TEST(Outcome, NamesTheFreedomAndTheWinner) {
  const std::vector<Candidate> one{certain(2), maybe(5, Freedom::ClipVertexPosition)};
  const Outcome outcome = judge(one, 5, 2);
  EXPECT_EQ(outcome.freedom, Freedom::ClipVertexPosition);
  ASSERT_NE(outcome.winner, nullptr);
  EXPECT_EQ(outcome.winner->primitive, 5U);
  EXPECT_EQ(judge(one, 9, 1).winner, nullptr);
}

// [vk:primsrast-polygons-basic] exactly one of the two polygons at an edge owns a sample on it.
TEST(Outcome, SharedEdgeHasExactlyOneOwner) {
  const std::vector<Candidate> pair{tie(1, kA, kB), tie(2, kB, kA)};
  EXPECT_TRUE(legal(pair, 1, 1));
  EXPECT_TRUE(legal(pair, 2, 1));
  EXPECT_FALSE(legal(pair, 2, 2)) << "both";
  EXPECT_FALSE(legal(pair, 0, 0)) << "neither";
  EXPECT_EQ(judge(pair, 2, 1).freedom, Freedom::TieOwner);
}

TEST(Outcome, EdgeOfOneTriangleIsFree) {
  EXPECT_TRUE(legal({tie(1, kA, kB)}, 1, 1));
  EXPECT_TRUE(legal({tie(1, kA, kB)}, 0, 0));
}

TEST(Outcome, TrianglesOnTheSameSideOfAnEdgeAreNoPair) {
  const std::vector<Candidate> same{tie(1, kA, kB), tie(2, kA, kB)};
  EXPECT_TRUE(legal(same, 2, 2));
  EXPECT_TRUE(legal(same, 0, 0));
}

TEST(Outcome, TwoDifferentEdgesAreDecidedOnTheirOwn) {
  const std::vector<Candidate> two{tie(1, kA, kB), tie(2, kB, kA), tie(3, kA, kC), tie(4, kC, kA)};
  for (const uint32_t winner : {3U, 4U}) EXPECT_TRUE(legal(two, winner, 2));
  EXPECT_FALSE(legal(two, 4, 3));
  EXPECT_FALSE(legal(two, 2, 1));
}

TEST(Outcome, OverlaidPairCountsBesideACertainPrimitive) {
  const std::vector<Candidate> three{tie(1, kA, kB), certain(2), tie(3, kB, kA)};
  EXPECT_TRUE(legal(three, 2, 2));
  EXPECT_TRUE(legal(three, 3, 2));
  EXPECT_FALSE(legal(three, 2, 1));
  EXPECT_FALSE(legal(three, 3, 3));
}

TEST(Outcome, MorePairsThanAreDecidedStayFreeButNeverIllegal) {
  std::vector<Candidate> many;
  for (uint32_t i = 0; i < 20; ++i) {
    const SubpixelPosition a{static_cast<int32_t>(i), 0}, b{static_cast<int32_t>(i), 100};
    many.push_back(tie(2 * i + 1, a, b));
    many.push_back(tie(2 * i + 2, b, a));
  }
  EXPECT_TRUE(legal(many, 40, 20));
  EXPECT_TRUE(legal(many, 39, 20));
  EXPECT_FALSE(legal(many, 40, 41));
}

TEST(OutcomeWithDepth, TestDecidesWhereDepthsAreApart) {
  const std::vector<Candidate> two{certain(1, {0.2F, 0.3F}), certain(2, {0.6F, 0.7F})};
  const auto legalWith = [&](CompareOp op, uint32_t winner, uint32_t count) {
    return judgeOutcome(depthState(op), {1, 1}, true, two, winner, count).legal;
  };
  EXPECT_TRUE(legalWith(CompareOp::LESS, 1, 1));
  EXPECT_FALSE(legalWith(CompareOp::LESS, 2, 2));
  EXPECT_FALSE(legalWith(CompareOp::LESS, 2, 1));
  EXPECT_TRUE(legalWith(CompareOp::ALWAYS, 2, 2));
  EXPECT_TRUE(legalWith(CompareOp::NEVER, 0, 0));
  EXPECT_FALSE(legalWith(CompareOp::NEVER, 2, 1));
}

TEST(OutcomeWithDepth, OrderIsFreeWhereIntervalsMeet) {
  const std::vector<Candidate> two{certain(1, {0.2F, 0.5F}), certain(2, {0.4F, 0.7F})};
  const Outcome first = judgeOutcome(depthState(CompareOp::LESS), {1, 1}, true, two, 1, 1);
  const Outcome second = judgeOutcome(depthState(CompareOp::LESS), {1, 1}, true, two, 2, 2);
  EXPECT_TRUE(first.legal);
  EXPECT_TRUE(second.legal);
  EXPECT_EQ(second.freedom, Freedom::Evaluation) << "nobody's coverage is free: the depths are";
  EXPECT_FALSE(judgeOutcome(depthState(CompareOp::LESS), {1, 1}, true, two, 2, 1).legal);
}

TEST(OutcomeWithDepth, WithoutWriteEverybodyMeetsTheClearValue) {
  const std::vector<Candidate> two{certain(1, {0.2F, 0.3F}), certain(2, {0.6F, 0.7F})};
  EXPECT_TRUE(judgeOutcome(depthState(CompareOp::LESS, false), {1, 1}, true, two, 2, 2).legal);
  EXPECT_FALSE(judgeOutcome(depthState(CompareOp::LESS, false), {0.5F, 0.5F}, true, two, 2, 2).legal);
  EXPECT_TRUE(judgeOutcome(depthState(CompareOp::LESS, false), {0.5F, 0.5F}, true, two, 1, 1).legal);
}

// [vk:drawing-primitive-order] what a polygon mode makes of one triangle comes in any order.
TEST(OutcomeWithDepth, EdgesOfOneTriangleComeInAnyOrder) {
  State lines = depthState(CompareOp::LESS);
  lines.polygonMode = PolygonMode::LINE;
  const std::vector<Candidate> edges{certain(1, {0.2F, 0.2F}), certain(1, {0.6F, 0.6F}), certain(1, {0.8F, 0.8F})};
  const auto judgeEdges = [&](const State& state, uint32_t count) { return judgeOutcome(state, {1, 1}, true, edges, 1, count); };
  for (const uint32_t count : {1U, 2U, 3U}) {
    EXPECT_TRUE(judgeEdges(lines, count).legal) << count;
    EXPECT_EQ(judgeEdges(lines, count).freedom, Freedom::PrimitiveOrder);
  }
  EXPECT_FALSE(judgeEdges(lines, 4).legal);
  EXPECT_TRUE(judgeEdges(depthState(CompareOp::LESS), 1).legal) << "filled pieces are in order: the first is the nearest";
  EXPECT_FALSE(judgeEdges(depthState(CompareOp::LESS), 2).legal);
}

TEST(OutcomeWithDepth, EdgesOfDifferentTrianglesStayInOrder) {
  State lines = depthState(CompareOp::LESS);
  lines.polygonMode = PolygonMode::LINE;
  const std::vector<Candidate> edges{certain(1, {0.2F, 0.2F}), certain(2, {0.6F, 0.6F})};
  EXPECT_TRUE(judgeOutcome(lines, {1, 1}, true, edges, 1, 1).legal);
  EXPECT_FALSE(judgeOutcome(lines, {1, 1}, true, edges, 1, 2).legal);
}

TEST(OutcomeWithDepth, MoreEdgesThanAreOrderedStayFreeButNeverIllegal) {
  State points = depthState(CompareOp::LESS);
  points.polygonMode = PolygonMode::POINT;
  std::vector<Candidate> corners;
  for (int i = 0; i < 12; ++i) corners.push_back(certain(1, {static_cast<float>(i) / 16, static_cast<float>(i) / 16}));
  EXPECT_TRUE(judgeOutcome(points, {1, 1}, true, corners, 1, 1).legal);
  EXPECT_TRUE(judgeOutcome(points, {1, 1}, true, corners, 1, 12).legal);
  EXPECT_FALSE(judgeOutcome(points, {1, 1}, true, corners, 1, 13).legal);
}

TEST(OutcomeWithDepth, WithoutTheTestDepthIsIgnored) {
  State state = depthState(CompareOp::NEVER);
  state.depthTestEnable = false;
  EXPECT_TRUE(judgeOutcome(state, {1, 1}, true, std::vector<Candidate>{certain(1, {0.2F, 0.3F})}, 1, 1).legal);
}

// Every outcome that some choice of coverage (one owner a pair) and of depths from small sets gives, played exactly.
struct Played {
  std::set<std::pair<uint32_t, uint32_t>> outcomes;  // winner, count
};

void play(const State& state, bool hasDepth, const std::vector<Candidate>& candidates, const std::vector<bool>& covers, size_t i,
          uint32_t winner, uint32_t count, float stored, Played& played) {
  if (i == candidates.size()) {
    played.outcomes.emplace(winner, count);
    return;
  }
  if (!covers[i]) return play(state, hasDepth, candidates, covers, i + 1, winner, count, stored, played);
  const Bounds& depth = candidates[i].depth;
  for (const float z : {depth.lo, (depth.lo + depth.hi) / 2, depth.hi}) {
    const bool tests = hasDepth && state.depthTestEnable;
    if (tests && !rasterizer::depthTestPasses(state.depthCompareOp, z, stored)) {
      play(state, hasDepth, candidates, covers, i + 1, winner, count, stored, played);
    } else {
      play(state, hasDepth, candidates, covers, i + 1, candidates[i].primitive, count + 1,
           tests && state.depthWriteEnable ? z : stored, played);
    }
    if (!tests) break;
  }
}

Played playAll(const State& state, bool hasDepth, const std::vector<Candidate>& candidates) {
  Played played;
  for (unsigned mask = 0; mask < (1U << candidates.size()); ++mask) {
    std::vector<bool> covers;
    bool possible = true;
    for (size_t i = 0; i < candidates.size(); ++i) {
      covers.push_back((mask >> i & 1) != 0);
      possible = possible && (covers[i] || candidates[i].coverage == Coverage::Either);
    }
    for (size_t i = 0; i < candidates.size() && possible; ++i) {
      for (size_t j = 0; j < i; ++j) {
        const auto &a = candidates[i].tieEdge, &b = candidates[j].tieEdge;
        const bool opposite = a && b && (*a)[0] == (*b)[1] && (*a)[1] == (*b)[0];
        if (opposite && covers[i] == covers[j]) possible = false;
      }
    }
    if (possible) play(state, hasDepth, candidates, covers, 0, 0, 0, 1, played);
  }
  return played;
}

std::vector<Candidate> randomCandidates(std::mt19937& random, bool withDepth) {
  std::vector<Candidate> candidates;
  const size_t size = 1 + random() % 5;
  int pairs = 0;
  for (uint32_t i = 0; i < size; ++i) {
    const auto level = [&] { return static_cast<float>(random() % 5) / 4; };
    Bounds depth{level(), level()};
    if (depth.lo > depth.hi) std::swap(depth.lo, depth.hi);
    if (!withDepth) depth = {};
    switch (random() % 4) {
      case 0: candidates.push_back(certain(i + 1, depth)); break;
      case 1: candidates.push_back(maybe(i + 1, Freedom::SnapRounding, depth)); break;
      default:
        // At most one edge, and at most one triangle on each side of it: more than that is judged more leniently.
        candidates.push_back(pairs == 0 ? tie(i + 1, kA, kB) : pairs == 1 ? tie(i + 1, kB, kA) : maybe(i + 1));
        candidates.back().depth = depth;
        ++pairs;
    }
  }
  return candidates;
}

TEST(OutcomeBruteForce, WithoutDepthLegalIsExactlyWhatCanBePlayed) {
  std::mt19937 random(1);
  int legalOnes = 0, illegalOnes = 0;
  for (int i = 0; i < 3000; ++i) {
    const std::vector<Candidate> candidates = randomCandidates(random, false);
    const Played played = playAll(State{}, false, candidates);
    for (uint32_t winner = 0; winner <= candidates.size(); ++winner) {
      for (uint32_t count = 0; count <= candidates.size() + 1; ++count) {
        const bool expected = played.outcomes.contains({winner, count});
        EXPECT_EQ(legal(candidates, winner, count), expected) << "case " << i << ": " << winner << ", " << count;
        (expected ? legalOnes : illegalOnes) += 1;
      }
    }
  }
  EXPECT_GT(legalOnes, 5000);
  EXPECT_GT(illegalOnes, 5000);
}

TEST(OutcomeBruteForce, WithDepthNothingThatCanBePlayedIsIllegal) {
  std::mt19937 random(2);
  uint64_t playedOutcomes = 0, illegal = 0;
  for (int i = 0; i < 2000; ++i) {
    const std::vector<Candidate> candidates = randomCandidates(random, true);
    const State state = depthState(static_cast<CompareOp>(random() % 8), random() % 4 != 0);
    const Played played = playAll(state, true, candidates);
    for (uint32_t winner = 0; winner <= candidates.size(); ++winner) {
      for (uint32_t count = 0; count <= candidates.size() + 1; ++count) {
        const bool judged = judgeOutcome(state, {1, 1}, true, candidates, winner, count).legal;
        if (played.outcomes.contains({winner, count})) {
          EXPECT_TRUE(judged) << "case " << i << ": " << winner << ", " << count;
          ++playedOutcomes;
        } else {
          illegal += judged ? 0 : 1;
        }
      }
    }
  }
  EXPECT_GT(playedOutcomes, 5000U);
  EXPECT_GT(illegal, 10000U) << "intervals may be lenient, but not about everything";
}

}  // namespace
}  // namespace rasterdiff::harness
