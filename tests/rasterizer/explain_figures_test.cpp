// explain() of points, lines, and what happens after rasterization, against numbers that can be worked out by hand.
#include <gtest/gtest.h>

#include "rasterizer/explain.hpp"
#include "tests/support/scenes.hpp"

namespace rasterdiff::rasterizer {
namespace {

using Kind = PrimitiveExplanation::Kind;

PrimitiveExplanation only(const Scene& scene, SampleQuery query, Limits limits = {}) {
  limits.lineWidthMax = limits.pointSizeMax = 64;
  limits.lineWidthGranularity = limits.pointSizeGranularity = 0.125F;
  const Result<SampleExplanation> e = explain(scene, *Rules::profile("reference", limits), query);
  EXPECT_TRUE(e);
  EXPECT_EQ(e->primitives.size(), 1U);
  return e->primitives.at(0);
}

Scene lineOf(std::vector<testing::Point> ends, LineRasterizationMode mode) {
  Scene scene = testing::sceneOf(ends, 16);
  scene.state.topology = PrimitiveTopology::LINE_LIST;
  scene.state.lineRasterizationMode = mode;
  return scene;
}

TEST(ExplainPoint, GivesTheDistanceToEachSideOfTheSquare) {
  Scene scene = testing::sceneOf({{3.25, 4.5}}, 8);
  scene.state.topology = PrimitiveTopology::POINT_LIST;
  scene.state.pointSize = 3.04F;
  const PrimitiveExplanation e = only(scene, {2, 3, 0});
  EXPECT_EQ(e.kind, Kind::Point);
  EXPECT_EQ(e.ends[0].x, 3.25);
  EXPECT_EQ(e.size, 3) << "granules of 1/8 above 1";
  ASSERT_EQ(e.facts.sides.size(), 4U);
  EXPECT_EQ(e.facts.sides[0].name, "left");
  EXPECT_EQ(e.facts.sides[0].inside, 2.5 - 1.75);
  EXPECT_EQ(e.facts.sides[1].inside, 4.75 - 2.5);
  EXPECT_EQ(e.facts.sides[2].inside, 3.5 - 3.0);
  EXPECT_EQ(e.facts.sides[3].inside, 6.0 - 3.5);
  EXPECT_TRUE(e.covered);
  EXPECT_EQ(e.decidedBy, Rule::PointSquare);
  EXPECT_EQ(e.fate.end, FragmentFate::End::Written);
}

TEST(ExplainPoint, ASampleOnTheRightSideIsATieThatItLoses) {
  Scene scene = testing::sceneOf({{3, 3.5}}, 8);
  scene.state.topology = PrimitiveTopology::POINT_LIST;
  const PrimitiveExplanation e = only(scene, {3, 3, 0});
  EXPECT_TRUE(e.facts.sides[1].exactlyOn);
  EXPECT_FALSE(e.facts.sides[1].ownsTies);
  EXPECT_FALSE(e.covered);
  EXPECT_EQ(e.decidedBy, Rule::TieBreak);
}

TEST(ExplainLine, GivesTheDistanceToSidesAndEndsOfTheRectangle) {
  Scene scene = lineOf({{1.5, 2.5}, {6.5, 2.5}}, LineRasterizationMode::RECTANGULAR);
  scene.state.lineWidth = 1.5F;
  const PrimitiveExplanation e = only(scene, {3, 2, 0});
  EXPECT_EQ(e.kind, Kind::Line);
  ASSERT_EQ(e.facts.sides.size(), 4U);
  EXPECT_EQ(e.facts.sides[0].inside, 0.75);
  EXPECT_EQ(e.facts.sides[1].inside, 0.75);
  EXPECT_EQ(e.facts.sides[2].inside, 2);
  EXPECT_EQ(e.facts.sides[3].inside, 3);
  ASSERT_EQ(e.facts.corners.size(), 4U);
  EXPECT_EQ(e.facts.corners[0].y, 1.75);
  EXPECT_EQ(e.facts.corners[2].x, 6.5);
  EXPECT_EQ(e.decidedBy, Rule::LineRectangle);
}

TEST(ExplainLine, NamesTheDiamondOfTheColumn) {
  // Slope 2/5: in column 3 along the line (x = 4.5) it is at 2.5 + 6/5 = 3.7.
  const Scene scene = lineOf({{1.5, 2.5}, {6.5, 4.5}}, LineRasterizationMode::BRESENHAM);
  const PrimitiveExplanation e = only(scene, {4, 3, 0});
  ASSERT_TRUE(e.facts.diamond);
  EXPECT_TRUE(e.facts.diamond->xMajor);
  EXPECT_EQ(e.facts.diamond->number, 3);
  EXPECT_EQ(e.facts.diamond->count, 5);
  EXPECT_EQ(e.facts.diamond->pixel, (PixelIndex{4, 3}));
  EXPECT_EQ(e.facts.diamond->crossing * 10, e.facts.diamond->unit * 37);
  EXPECT_TRUE(e.covered);
  EXPECT_EQ(e.decidedBy, Rule::LineBresenham);
  const PrimitiveExplanation end = only(scene, {6, 4, 0});
  EXPECT_FALSE(end.facts.diamond->inColumn()) << "the line ends in that diamond";
  EXPECT_FALSE(end.covered);
}

TEST(ExplainLine, NamesTheBitOfThePattern) {
  Scene scene = lineOf({{1, 2.5}, {15, 2.5}}, LineRasterizationMode::RECTANGULAR);
  scene.state.stippledLineEnable = true;
  scene.state.lineStipplePattern = 0x00FF;
  const PrimitiveExplanation drawn = only(scene, {4, 2, 0}), dropped = only(scene, {10, 2, 0});
  EXPECT_EQ(drawn.facts.stipple.value().bit, 3U);
  EXPECT_TRUE(drawn.covered);
  EXPECT_EQ(dropped.facts.stipple.value().bit, 9U);
  EXPECT_TRUE(dropped.dropped);
  EXPECT_FALSE(dropped.covered);
  EXPECT_EQ(dropped.decidedBy, Rule::LineStipple);
}

TEST(ExplainFragment, FollowsTheDepthTestFromOnePrimitiveToTheNext) {
  Scene scene = testing::sceneOf({{0, 0}, {8, 0}, {0, 8}, {0, 0}, {8, 0}, {0, 8}}, 8);
  for (size_t i = 0; i < 6; ++i) scene.draws[0].positions[i].z = i < 3 ? 0.25F : 0.5F;
  scene.target.depthFormat = DepthFormat::D32_SFLOAT;
  scene.state.depthTestEnable = scene.state.depthWriteEnable = true;
  const SampleExplanation e = *explain(scene, testing::referenceRules(), {2, 2, 0});
  ASSERT_EQ(e.primitives.size(), 2U);
  EXPECT_EQ(e.primitives[0].fate.end, FragmentFate::End::Written);
  EXPECT_EQ(e.primitives[0].fate.stored, 1);
  EXPECT_EQ(e.primitives[1].fate.end, FragmentFate::End::DepthFailed);
  EXPECT_EQ(e.primitives[1].fate.depth, 0.5F);
  EXPECT_EQ(e.primitives[1].fate.stored, 0.25F);
  EXPECT_EQ(e.primitives[1].decidedBy, Rule::DepthTest);
}

TEST(ExplainFragment, NamesTheSampleMask) {
  Scene scene = testing::sceneOf({{0, 0}, {8, 0}, {0, 8}}, 8);
  scene.target.samples = 4;
  scene.state.sampleMask = 0xB;
  EXPECT_EQ(only(scene, {2, 2, 2}).decidedBy, Rule::SampleMask);
  EXPECT_EQ(only(scene, {2, 2, 1}).decidedBy, Rule::SampleCoverage);
}

TEST(ExplainRejection, NamesThePlane) {
  Scene scene = testing::sceneOf({{1, 1}, {7, 1}, {1, 7}}, 8);
  for (ClipPosition& p : scene.draws[0].positions) p.z = -0.5F;
  const SampleExplanation e = *explain(scene, testing::referenceRules(), {2, 2, 0});
  EXPECT_TRUE(e.primitives.empty());
  ASSERT_EQ(e.rejections.size(), 1U);
  EXPECT_EQ(e.rejections[0].by, "the near plane");
  EXPECT_EQ(e.rejections[0].first, 1U);
  EXPECT_EQ(e.rejections[0].count, 1U);
}

}  // namespace
}  // namespace rasterdiff::rasterizer
