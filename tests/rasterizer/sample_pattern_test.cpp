// Where samples lie, and which pixels can be written.
#include "rasterizer/sample_pattern.hpp"

#include <gtest/gtest.h>

#include "rasterizer/target_area.hpp"
#include "tests/support/scenes.hpp"

namespace rasterdiff::rasterizer {
namespace {

TEST(SamplePattern, IsTheStandardTableInSubpixels) {
  const Rules rules = testing::referenceRules();
  EXPECT_EQ(*samplePattern(1, rules), (std::vector<SubpixelPosition>{{128, 128}}));
  EXPECT_EQ(*samplePattern(2, rules), (std::vector<SubpixelPosition>{{192, 192}, {64, 64}}));
  EXPECT_EQ(*samplePattern(4, rules), (std::vector<SubpixelPosition>{{96, 32}, {224, 96}, {32, 160}, {160, 224}}));
  EXPECT_EQ(samplePattern(8, rules)->size(), 8U);
  EXPECT_EQ((*samplePattern(16, rules))[15], (SubpixelPosition{16, 0}));
}

TEST(SamplePattern, OtherCountsAreNotOffered) {
  for (const uint32_t samples : {0U, 3U, 32U, 64U}) {
    const auto pattern = samplePattern(samples, testing::referenceRules());
    ASSERT_FALSE(pattern) << samples;
    EXPECT_EQ(pattern.error().code, ErrorCode::NotOffered);
    EXPECT_EQ(pattern.error().where, "target.samples");
  }
}

TEST(SamplePattern, MutantMovesTheFirstSampleByASixteenth) {
  Rules rules = testing::referenceRules();
  rules.error = DeliberateError::SampleMoved;
  EXPECT_EQ(*samplePattern(4, rules), (std::vector<SubpixelPosition>{{112, 32}, {224, 96}, {32, 160}, {160, 224}}));
}

PixelArea areaWith(const Rect2D& scissor, DeliberateError error = DeliberateError::None) {
  Scene scene = testing::sceneOf({{0, 0}, {8, 0}, {0, 8}}, 8);
  scene.scissor = scissor;
  return targetArea(scene, 0, error);
}

void expectArea(const PixelArea& area, int32_t left, int32_t top, int32_t right, int32_t bottom) {
  EXPECT_EQ(area.left, left);
  EXPECT_EQ(area.top, top);
  EXPECT_EQ(area.right, right);
  EXPECT_EQ(area.bottom, bottom);
}

TEST(TargetArea, IsTheTargetCutByTheScissor) {
  expectArea(targetArea(testing::sceneOf({{0, 0}, {8, 0}, {0, 8}}, 8), 0), 0, 0, 8, 8);
  expectArea(areaWith({2, 3, 4, 1}), 2, 3, 6, 4);
  expectArea(areaWith({2, 3, 400, 100}), 2, 3, 8, 8);
  expectArea(areaWith({0x7ffffff0, 0, 15, 8}), 0x7ffffff0, 0, 8, 8);
}

TEST(TargetArea, HoldsLeftAndTopButNotRightAndBottom) {
  const PixelArea area = areaWith({2, 3, 4, 2});
  EXPECT_TRUE(area.contains(2, 3));
  EXPECT_TRUE(area.contains(5, 4));
  EXPECT_FALSE(area.contains(6, 4));
  EXPECT_FALSE(area.contains(5, 5));
  EXPECT_FALSE(area.contains(1, 3));
  EXPECT_FALSE(area.contains(2, 2));
}

TEST(TargetArea, MutantAddsOneColumn) { expectArea(areaWith({2, 3, 4, 1}, DeliberateError::ScissorOffByOne), 2, 3, 7, 4); }

}  // namespace
}  // namespace rasterdiff::rasterizer
