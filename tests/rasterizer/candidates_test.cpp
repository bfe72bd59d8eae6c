// The evidence behind a verdict: who may cover a sample, why, with which values.
#include <gtest/gtest.h>

#include "rasterizer/render.hpp"
#include "scene/generators/random_triangles.hpp"
#include "scene/generators/shared_edges.hpp"
#include "tests/support/scenes.hpp"

namespace rasterdiff::rasterizer {
namespace {

using testing::Point;

Rules openRules() { return Rules::specification(Limits{}); }

std::vector<Candidate> at(const Scene& scene, uint32_t x, uint32_t y, const Rules& rules, uint32_t sample = 0) {
  const SampleQuery query{x, y, sample};
  return candidates(scene, rules, {&query, 1})->front();
}

std::vector<SampleQuery> everySample(const Scene& scene) {
  std::vector<SampleQuery> queries;
  for (uint32_t y = 0; y < scene.target.height; ++y) {
    for (uint32_t x = 0; x < scene.target.width; ++x) {
      for (uint32_t s = 0; s < scene.target.samples; ++s) queries.push_back({x, y, s});
    }
  }
  return queries;
}

const std::vector<Point> kSquare{{1.5, 1.5}, {5.5, 1.5}, {5.5, 5.5}, {1.5, 1.5}, {5.5, 5.5}, {1.5, 5.5}};

TEST(Candidates, SampleInsideHasOneCertainCandidate) {
  const auto found = at(testing::sceneOf(kSquare, 8), 4, 2, openRules());
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].primitive, 1U);
  EXPECT_EQ(found[0].coverage, Coverage::In);
  EXPECT_EQ(found[0].freedom, Freedom::None);
  EXPECT_FALSE(found[0].tieEdge);
}

TEST(Candidates, SampleFarOutsideHasNone) { EXPECT_TRUE(at(testing::sceneOf(kSquare, 8), 7, 7, openRules()).empty()); }

TEST(Candidates, SampleOnASharedEdgeHasTwoWithOppositeTieEdges) {
  const auto found = at(testing::sceneOf(kSquare, 8), 3, 3, openRules());
  ASSERT_EQ(found.size(), 2U);
  for (const Candidate& candidate : found) {
    EXPECT_EQ(candidate.coverage, Coverage::Either);
    EXPECT_EQ(candidate.freedom, Freedom::TieOwner);
    ASSERT_TRUE(candidate.tieEdge);
  }
  EXPECT_EQ((*found[0].tieEdge)[0], (*found[1].tieEdge)[1]);
  EXPECT_EQ((*found[0].tieEdge)[1], (*found[1].tieEdge)[0]);
}

TEST(Candidates, SampleOnASharedVertexIsFreeWithoutATieEdge) {
  const auto found = at(testing::sceneOf(kSquare, 8), 1, 1, openRules());
  ASSERT_EQ(found.size(), 2U);
  for (const Candidate& candidate : found) {
    EXPECT_EQ(candidate.coverage, Coverage::Either);
    EXPECT_FALSE(candidate.tieEdge) << "two edges are tied: none alone decides";
  }
}

TEST(Candidates, VertexOffTheGridFreesTheSamplesThatASnapCanReach) {
  // The left edge is between grid lines at 2.5 - 1/512: it may go to 2.5 (a tie) or beyond.
  const auto found = at(testing::sceneOf({{2.5 - 1.0 / 512, 0}, {8, 4}, {2.5 - 1.0 / 512, 8}}, 8), 2, 4, openRules());
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].coverage, Coverage::Either);
  EXPECT_EQ(found[0].freedom, Freedom::SnapRounding);
  EXPECT_EQ(at(testing::sceneOf({{2.5 - 1.5 / 256, 0}, {8, 4}, {2.5 - 1.5 / 256, 8}}, 8), 2, 4, openRules())[0].coverage, Coverage::In);
  EXPECT_TRUE(at(testing::sceneOf({{2.5 + 1.5 / 256, 0}, {8, 4}, {2.5 + 1.5 / 256, 8}}, 8), 2, 4, openRules()).empty());
}

TEST(Candidates, CutPolygonNamesItsOwnFreedom) {
  const auto found = at(testing::sceneOf({{-8, 0}, {24, 15}, {-8, 16}}, 8), 0, 4, openRules());
  // The sloped edge passes (0.5, 3.98): the sample (0.5, 4.5) is inside of it, by 132 grid steps.
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].coverage, Coverage::In);
  const auto onCut = at(testing::sceneOf({{-8, 0.25}, {24, 16.25}, {-8, 16}}, 8), 0, 4, openRules());
  ASSERT_EQ(onCut.size(), 1U);
  EXPECT_EQ(onCut[0].coverage, Coverage::Either);
  EXPECT_EQ(onCut[0].freedom, Freedom::ClipVertexPosition);
}

TEST(Candidates, NearZeroAreaMakesTheFacingFree) {
  Scene scene = testing::sceneOf({{1.5, 4.5 + 1.0 / 512}, {6.5, 4.5 + 1.0 / 512}, {4, 4.5 + 1.0 / 1024}}, 8);
  scene.state.cullMode = CullMode::BACK;
  const auto found = at(scene, 4, 4, openRules());
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].coverage, Coverage::Either);
  EXPECT_EQ(found[0].freedom, Freedom::NearZeroArea);
}

TEST(Candidates, VertexAtTheOriginOfClipSpaceFreesTheWholeTargetOfItsPrimitive) {
  Scene scene = testing::sceneOf({{1, 1}, {6, 1}, {1, 6}}, 8);
  scene.draws[0].positions[2] = {0, 0, 0, 0};
  const auto found = at(scene, 7, 7, openRules());
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].coverage, Coverage::Either);
  EXPECT_EQ(found[0].freedom, Freedom::DivisionByZero);
}

TEST(Candidates, OutsideOfTheScissorThereAreNone) {
  Scene scene = testing::sceneOf({{-20, -20}, {40, -20}, {-20, 40}}, 8);
  scene.scissor = Rect2D{2, 2, 4, 4};
  EXPECT_TRUE(at(scene, 1, 3, openRules()).empty());
  EXPECT_EQ(at(scene, 2, 2, openRules()).size(), 1U);
  EXPECT_TRUE(at(scene, 6, 3, openRules()).empty());
}

TEST(Candidates, CarryLegalDepthsAndValues) {
  Scene scene = testing::sceneOf({{0, 0, 0}, {8, 0, 1}, {0, 8, 0}}, 8);
  scene.target.depthFormat = DepthFormat::D32_SFLOAT;
  scene.draws[0].varyings = {{"x", Interpolation::noperspective, 2, {0, 1, 8, 1, 0, 1}}, {"flat", Interpolation::flat, 1, {7, 8, 9}}};
  const auto found = at(scene, 2, 1, openRules());
  ASSERT_EQ(found.size(), 1U);
  EXPECT_LE(found[0].depth.lo, 2.5F / 8);
  EXPECT_GE(found[0].depth.hi, 2.5F / 8);
  EXPECT_LT(found[0].depth.hi - found[0].depth.lo, 1e-4F);
  ASSERT_EQ(found[0].varyings.size(), 3U);
  EXPECT_LE(found[0].varyings[0].lo, 2.5F);
  EXPECT_GE(found[0].varyings[0].hi, 2.5F);
  EXPECT_EQ(found[0].varyings[2].lo, 7);
  EXPECT_EQ(found[0].varyings[2].hi, 7);
}

TEST(Candidates, AnswerQueriesInTheirOrder) {
  const Scene scene = testing::sceneOf(kSquare, 8);
  const std::vector<SampleQuery> queries{{4, 2, 0}, {2, 4, 0}, {7, 7, 0}, {4, 2, 0}, {0, 0, 0}, {2, 4, 0}};
  const auto found = *candidates(scene, openRules(), queries);
  ASSERT_EQ(found.size(), 6U);
  EXPECT_EQ(found[0][0].primitive, 1U);
  EXPECT_EQ(found[1][0].primitive, 2U);
  EXPECT_TRUE(found[2].empty());
  EXPECT_EQ(found[3][0].primitive, 1U);
  EXPECT_TRUE(found[4].empty());
  EXPECT_EQ(found[5][0].primitive, 2U);
}

TEST(Candidates, SampleOutsideOfTheTargetIsRefused) {
  for (const SampleQuery query : {SampleQuery{8, 0, 0}, SampleQuery{0, 8, 0}, SampleQuery{0, 0, 1}}) {
    const auto found = candidates(testing::sceneOf(kSquare, 8), openRules(), {&query, 1});
    ASSERT_FALSE(found);
    EXPECT_EQ(found.error().code, ErrorCode::BadInput);
  }
}

// Under closed rules the candidates of a sample are just the primitives that the frame counted there, the last one wins.
void expectThoseOfTheFrame(const Scene& scene, const Rules& rules) {
  const Frame frame = *render(scene, rules);
  const auto queries = everySample(scene);
  const auto found = *candidates(scene, rules, queries);
  for (size_t i = 0; i < queries.size(); ++i) {
    ASSERT_EQ(found[i].size(), frame.count.data[i]);
    ASSERT_EQ(found[i].empty() ? 0 : found[i].back().primitive, frame.primitive.data[i]);
  }
}

TEST(Candidates, AgreeWithTheFrameUnderClosedRules) {
  for (const bool perspective : {false, true}) expectThoseOfTheFrame(randomTriangles({3, 200, Grid::Half, 4, perspective, 32, false}), testing::referenceRules());
}

// [choice:drawing-region] also where borders let samples through, or the viewport cuts.
TEST(Candidates, AgreeWithTheFrameInADrawingRegionThatLeaks) {
  Rules rules = testing::referenceRules();
  rules.choices.drawingRegion = DrawingRegionRule::RoundedViewport;
  for (const PrimitiveTopology topology : {PrimitiveTopology::TRIANGLE_LIST, PrimitiveTopology::POINT_LIST}) {
    Scene scene = randomTriangles({4, 200, Grid::Half, 4, false, 32, false});
    scene.state.topology = topology;
    scene.scissor = Rect2D{5, 7, 20, 20};
    expectThoseOfTheFrame(scene, rules);
    scene.scissor.reset();
    scene.viewport.x += 3, scene.viewport.width -= 8;
    expectThoseOfTheFrame(scene, rules);
  }
}

// Under open rules every nominal cover is a candidate, In agrees with the plane, and Out means that none is In.
TEST(Candidates, AgreeWithTheThreeValuedPlane) {
  for (const Grid grid : {Grid::Half, Grid::Free}) {
    const Scene scene = randomTriangles({5, 100, grid, 1, true, 64, false});
    const Frame frame = *render(scene, openRules());
    const auto queries = everySample(scene);
    const auto found = *candidates(scene, openRules(), queries);
    for (size_t i = 0; i < queries.size(); ++i) {
      bool in = false, nominal = frame.primitive.data[i] == 0;
      for (const Candidate& candidate : found[i]) {
        in = in || candidate.coverage == Coverage::In;
        nominal = nominal || candidate.primitive == frame.primitive.data[i];
        EXPECT_EQ(candidate.coverage == Coverage::In, candidate.freedom == Freedom::None);
      }
      EXPECT_EQ(in, frame.coverage->data[i] == Coverage::In);
      EXPECT_TRUE(nominal);
      if (frame.coverage->data[i] == Coverage::Out) {
        EXPECT_TRUE(found[i].empty());
      }
    }
  }
}

// [vk:primsrast-polygons-basic] In a closed mesh, every free sample that is not on a vertex has its pair.
TEST(Candidates, PairUpOnTheSharedEdgesOfAMesh) {
  const Scene scene = sharedEdges({4, SharedMesh::Grid, Grid::Half, 1, 64, 12});
  const auto queries = everySample(scene);
  const auto found = *candidates(scene, openRules(), queries);
  int pairs = 0;
  for (const std::vector<Candidate>& sample : found) {
    if (sample.size() != 2 || !sample[0].tieEdge || !sample[1].tieEdge) continue;
    EXPECT_EQ((*sample[0].tieEdge)[0], (*sample[1].tieEdge)[1]);
    EXPECT_EQ((*sample[0].tieEdge)[1], (*sample[1].tieEdge)[0]);
    ++pairs;
  }
  EXPECT_GT(pairs, 100);
}

}  // namespace
}  // namespace rasterdiff::rasterizer
