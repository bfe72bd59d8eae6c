// Clip distances that drop whole fragments instead of cutting primitives. [choice:clip-distances]
#include <gtest/gtest.h>

#include "tests/support/scenes.hpp"

namespace rasterdiff::rasterizer {
namespace {

Rules droppingRules() {
  Rules rules = testing::referenceRules();
  rules.limits.pointSizeMax = 64;
  rules.choices.clipDistances = ClipDistances::Fragments;
  return rules;
}

// Over a target of 8 × 8 pixels, kept where x + offset <= `edge`.
Scene keptLeftOf(double edge, uint32_t samples) {
  Scene scene = testing::sceneOf({{-8, -8}, {24, -8}, {-8, 24}}, 8, samples);
  scene.viewport = {-8, -8, 32, 32, 0, 1};
  Draw& draw = scene.draws.front();
  draw.positions = {{-1, -1, 0.5F, 1}, {1, -1, 0.5F, 1}, {-1, 1, 0.5F, 1}};
  draw.clipDistanceCount = 1;
  draw.clipDistances = {static_cast<float>(edge + 8), static_cast<float>(edge - 24), static_cast<float>(edge + 8)};
  return scene;
}

uint64_t coveredOf(const Scene& scene, const Rules& rules) {
  const Result<Frame> frame = render(scene, rules);
  EXPECT_TRUE(frame.has_value());
  uint64_t covered = 0;
  for (const uint32_t primitive : frame->primitive.data) covered += primitive != 0 ? 1U : 0U;
  return covered;
}

TEST(KeptFragments, DropThoseWhoseCentreHasANegativeDistance) {
  EXPECT_EQ(coveredOf(keptLeftOf(3.25, 1), droppingRules()), 3U * 8);
  EXPECT_EQ(coveredOf(keptLeftOf(3.25, 1), testing::referenceRules()), 3U * 8);
}

TEST(KeptFragments, AreKeptWhereTheDistanceIsZero) { EXPECT_EQ(coveredOf(keptLeftOf(3.5, 1), droppingRules()), 4U * 8); }

// The cut keeps two of the four samples of a column (those left of its middle), a fragment all or none.
TEST(KeptFragments, AreKeptOrDroppedWithAllTheirSamples) {
  EXPECT_EQ(coveredOf(keptLeftOf(3.5, 4), droppingRules()), 4U * 8 * 4);
  EXPECT_EQ(coveredOf(keptLeftOf(3.4375, 4), droppingRules()), 3U * 8 * 4);
  EXPECT_EQ(coveredOf(keptLeftOf(3.5, 4), testing::referenceRules()), 3U * 8 * 4 + 2U * 8);
}

TEST(KeptFragments, MayBeAnywhereOfAPolygonInManyDraws) {
  Scene scene = keptLeftOf(3.25, 1);
  scene.draws.push_back(scene.draws.front());
  for (float& distance : scene.draws.back().clipDistances) distance = -distance;
  EXPECT_EQ(coveredOf(scene, droppingRules()), 8U * 8);
}

TEST(KeptFragments, OfALineFollowItsLength) {
  Scene scene = testing::sceneOf({{0, 4.5}, {8, 4.5}});
  scene.state.topology = PrimitiveTopology::LINE_LIST;
  scene.draws.front().clipDistanceCount = 1;
  scene.draws.front().clipDistances = {4, -4};
  EXPECT_EQ(coveredOf(scene, droppingRules()), 4U);
}

TEST(KeptFragments, OfAPointAreAllOrNone) {
  Scene scene = testing::sceneOf({{4, 4}});
  scene.state.topology = PrimitiveTopology::POINT_LIST;
  scene.state.pointSize = 4;
  scene.draws.front().clipDistanceCount = 1;
  scene.draws.front().clipDistances = {0};
  EXPECT_EQ(coveredOf(scene, droppingRules()), 16U);
  scene.draws.front().clipDistances = {-1};
  EXPECT_EQ(coveredOf(scene, droppingRules()), 0U);
}

TEST(KeptFragments, AreNotKnownToTheSpecification) {
  Rules open = Rules::specification(Limits{});
  open.choices.clipDistances = ClipDistances::Fragments;
  EXPECT_EQ(coveredOf(keptLeftOf(3.5, 4), open), 3U * 8 * 4 + 2U * 8);
}

}  // namespace
}  // namespace rasterdiff::rasterizer
