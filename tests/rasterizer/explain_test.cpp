// explain() against numbers that can be worked out by hand, and against the frame.
#include "rasterizer/explain.hpp"

#include <gtest/gtest.h>

#include "tests/support/scenes.hpp"

namespace rasterdiff::rasterizer {
namespace {

Rules openRules() { return Rules::specification(Limits{}); }

TEST(Explain, GivesTheExactEdgeValues) {
  // Right triangle (1,1) (7,1) (1,7), clockwise on the screen; sample (2.5, 3.5).
  const Scene scene = testing::sceneOf({{1, 1}, {7, 1}, {1, 7}}, 8);
  const SampleExplanation e = *explain(scene, testing::referenceRules(), {2, 3, 0});
  EXPECT_EQ(e.position, (SubpixelPosition{640, 896}));
  EXPECT_EQ(e.owner, 1U);
  EXPECT_TRUE(e.insideScissor);
  ASSERT_EQ(e.primitives.size(), 1U);
  const PrimitiveExplanation& p = e.primitives[0];
  EXPECT_EQ(p.snapped[0], (SubpixelPosition{256, 256}));
  EXPECT_EQ(p.snapped[1], (SubpixelPosition{1792, 256}));
  EXPECT_EQ(p.snapped[2], (SubpixelPosition{256, 1792}));
  EXPECT_EQ(p.doubleArea, 1536 * 1536);
  EXPECT_FALSE(p.frontFacing) << "clockwise, and counter-clockwise is front";
  EXPECT_FALSE(p.clipped);
  EXPECT_TRUE(p.covered);
  EXPECT_EQ(p.decidedBy, Rule::SampleCoverage);
  // Top edge: 6 pixels long, the sample 2.5 below; hypotenuse: 8 - 2.5 - 3.5 = 2 inside times 6; left edge 1.5.
  EXPECT_EQ(p.edges[0].value, 1536 * 640);
  EXPECT_EQ(p.edges[1].value, 1536 * 512);
  EXPECT_EQ(p.edges[2].value, 1536 * 384);
  EXPECT_TRUE(p.edges[0].ownsTies);
  EXPECT_FALSE(p.edges[1].ownsTies);
  EXPECT_TRUE(p.edges[2].ownsTies);
  for (const EdgeExplanation& edge : p.edges) {
    EXPECT_EQ(edge.lowest, edge.value);
    EXPECT_EQ(edge.highest, edge.value);
  }
}

TEST(Explain, NamesTheRuleThatDecided) {
  Scene scene = testing::sceneOf({{1.5, 1.5}, {5.5, 1.5}, {1.5, 5.5}}, 8);
  const auto ruleAt = [&](uint32_t x, uint32_t y) { return explain(scene, testing::referenceRules(), {x, y, 0})->primitives.at(0).decidedBy; };
  EXPECT_EQ(ruleAt(2, 2), Rule::SampleCoverage);
  EXPECT_EQ(ruleAt(3, 1), Rule::TieBreak);
  EXPECT_EQ(ruleAt(3, 3), Rule::TieBreak);
  scene.scissor = Rect2D{0, 0, 2, 8};
  EXPECT_EQ(ruleAt(2, 2), Rule::Scissor);
  scene.scissor.reset();
  scene.state.cullMode = CullMode::FRONT_AND_BACK;
  EXPECT_EQ(ruleAt(2, 2), Rule::Culling);
}

// [vk:vertexpostproc-coord-transform] it has no place on the screen, and may be anywhere.
TEST(Explain, NamesThePrimitiveThatDividesByZeroAndItsFreedom) {
  Scene scene = testing::sceneOf({{1, 1}, {6, 1}, {1, 6}}, 8);
  scene.draws[0].positions[2] = {0, 0, 0, 0};
  const SampleExplanation e = *explain(scene, openRules(), {7, 7, 0});
  ASSERT_EQ(e.primitives.size(), 1U);
  EXPECT_EQ(e.primitives[0].primitive, 1U);
  EXPECT_TRUE(e.primitives[0].unprojectable);
  EXPECT_EQ(e.primitives[0].coverage, Coverage::Either);
  EXPECT_EQ(e.primitives[0].freedom, Freedom::DivisionByZero);
  EXPECT_EQ(e.primitives[0].decidedBy, Rule::Division);
  EXPECT_TRUE(e.rejections.empty());
}

// A triangle that leaves the view volume is rejected by its facing if clipping leaves something of it, otherwise by the volume.
TEST(Explain, NamesWhatRejectedAPrimitiveThatLeavesTheViewVolume) {
  Scene scene = testing::sceneOf({{-4, 1}, {6, 1}, {1, 6}}, 8);
  scene.state.polygonMode = PolygonMode::LINE;
  const auto rejectedBy = [&] { return explain(scene, testing::referenceRules(), {1, 1, 0})->rejections.at(0).rule; };
  scene.state.cullMode = CullMode::FRONT_AND_BACK;
  EXPECT_EQ(rejectedBy(), Rule::Culling);
  scene.draws[0].positions = testing::sceneOf({{-4, 2}, {2, -4}, {-4, -4}}, 8).draws[0].positions;
  EXPECT_EQ(rejectedBy(), Rule::ViewVolume);
}

TEST(Explain, TieOwnersMatchTheFrame) {
  const Scene scene = testing::sceneOf({{1.5, 1.5}, {5.5, 1.5}, {5.5, 5.5}, {1.5, 1.5}, {5.5, 5.5}, {1.5, 5.5}}, 8);
  const SampleExplanation e = *explain(scene, testing::referenceRules(), {3, 3, 0});
  ASSERT_EQ(e.primitives.size(), 2U);
  EXPECT_EQ(e.owner, 1U);
  EXPECT_TRUE(e.primitives[0].covered);
  EXPECT_FALSE(e.primitives[1].covered);
}

// [choice:drawing-region] a sample outside of the scissor that the profile draws nevertheless.
TEST(Explain, DrawsSamplesThatLeakThroughTheScissor) {
  Scene scene = testing::sceneOf({{0, 0}, {8, 0}, {0, 8}}, 8);
  scene.target.samples = 4;
  scene.scissor = Rect2D{2, 0, 4, 8};
  Rules rules = testing::referenceRules();
  for (const bool leaky : {false, true}) {
    rules.choices.drawingRegion = leaky ? DrawingRegionRule::RoundedViewport : DrawingRegionRule::Scissor;
    for (uint32_t sample = 0; sample < 4; ++sample) {
      const SampleExplanation e = *explain(scene, rules, {1, 3, sample});
      EXPECT_FALSE(e.insideScissor);
      const bool rightHalf = e.position.x >= 256 + 128;
      ASSERT_EQ(e.primitives.size(), 1U);
      EXPECT_EQ(e.primitives[0].covered, leaky && rightHalf);
      EXPECT_EQ(e.owner, leaky && rightHalf ? 1U : 0U);
      EXPECT_EQ(e.primitives[0].fate.end, leaky && rightHalf ? FragmentFate::End::Written : FragmentFate::End::OutsideScissor);
    }
  }
}

TEST(Explain, UnderOpenRulesShowsTheRangeOfEachEdge) {
  const Scene scene = testing::sceneOf({{2.5 - 1.0 / 512, 0}, {8, 4}, {2.5 - 1.0 / 512, 8}}, 8);
  const SampleExplanation e = *explain(scene, openRules(), {2, 4, 0});
  ASSERT_EQ(e.primitives.size(), 1U);
  EXPECT_EQ(e.primitives[0].coverage, Coverage::Either);
  EXPECT_EQ(e.primitives[0].freedom, Freedom::SnapRounding);
  int wide = 0;
  for (const EdgeExplanation& edge : e.primitives[0].edges) {
    EXPECT_LE(edge.lowest, edge.value);
    EXPECT_GE(edge.highest, edge.value);
    wide += edge.lowest < edge.highest ? 1 : 0;
  }
  EXPECT_EQ(wide, 3);
}

TEST(Explain, ClippedTriangleShowsItsPieces) {
  const Scene scene = testing::sceneOf({{-8, 2}, {6, 2}, {6, 7}}, 8);
  const SampleExplanation e = *explain(scene, testing::referenceRules(), {5, 4, 0});
  ASSERT_GE(e.primitives.size(), 1U);
  int covering = 0;
  for (const PrimitiveExplanation& piece : e.primitives) {
    EXPECT_EQ(piece.primitive, 1U);
    EXPECT_TRUE(piece.clipped);
    covering += piece.covered ? 1 : 0;
  }
  EXPECT_EQ(covering, 1);
}

TEST(Explain, GivesTheDepthAtTheSample) {
  Scene scene = testing::sceneOf({{0, 0, 0}, {16, 0, 1}, {0, 16, 0}}, 8, 4);
  scene.target.depthFormat = DepthFormat::D32_SFLOAT;
  EXPECT_NEAR(explain(scene, testing::referenceRules(), {3, 4, 1})->primitives.at(0).depth, (3 + 14.0 / 16) / 16, 1e-7);
}

TEST(Explain, SampleOutsideOfTheTargetIsRefused) {
  const auto e = explain(testing::sceneOf({{1, 1}, {7, 1}, {1, 7}}, 8), testing::referenceRules(), {8, 0, 0});
  ASSERT_FALSE(e);
  EXPECT_EQ(e.error().code, ErrorCode::BadInput);
}

}  // namespace
}  // namespace rasterdiff::rasterizer
