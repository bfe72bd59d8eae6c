// Custom sample locations: which pixel of the grid has which table, clamping, rounding, and what is refused.
#include "rasterizer/sample_grid.hpp"

#include <gtest/gtest.h>

#include "rasterizer/explain.hpp"
#include "tests/support/scenes.hpp"

namespace rasterdiff::rasterizer {
namespace {

/// The half of the target left of x = 4.5 covered.
Scene leftHalf(uint32_t gridWidth, uint32_t gridHeight, std::vector<SampleLocationEXT> locations) {
  Scene scene = testing::sceneOf({{0, 0}, {4.5, 0}, {4.5, 8}, {0, 0}, {4.5, 8}, {0, 8}}, 8, 2);
  scene.target.sampleLocations = SampleLocationsInfo{gridWidth, gridHeight, std::move(locations)};
  return scene;
}

Rules withRange(float low, float high, uint32_t bits) {
  Rules rules = testing::referenceRules();
  rules.limits.sampleLocationCoordinateMin = low;
  rules.limits.sampleLocationCoordinateMax = high;
  rules.limits.sampleLocationSubPixelBits = bits;
  return rules;
}

/// Samples of row y's pixel 4 that are covered: "#." is the first of two.
std::string pixelFour(const Frame& frame, uint32_t y) {
  std::string text;
  for (uint32_t s = 0; s < frame.samples; ++s) text += frame.primitive.at(4, y, s) != 0 ? '#' : '.';
  return text;
}

std::vector<SampleTables::Offset> offsetsOf(const Rules& rules, SampleLocationEXT a, SampleLocationEXT b) {
  const Result<SampleGrid> grid = SampleGrid::of(leftHalf(1, 1, {a, b}), rules);
  const auto table = grid->at(0, 0).rules.choices.sampleLocations->of(2);
  return {table.begin(), table.end()};
}

TEST(SampleGrid, CoverageFollowsTheLocations) {
  EXPECT_EQ(pixelFour(*render(leftHalf(1, 1, {{0.25F, 0.5F}, {0.75F, 0.5F}}), testing::referenceRules()), 3), "#.");
  EXPECT_EQ(pixelFour(*render(leftHalf(1, 1, {{0.75F, 0.5F}, {0.25F, 0.5F}}), testing::referenceRules()), 3), ".#");
}

TEST(SampleGrid, EachPixelHasTheTableOfItsPlaceColumnFirst) {
  // Row 0 of the grid: both left; row 1: both right. The column of pixel 4 is 0 of two.
  const std::vector<SampleLocationEXT> table{{0.25F, 0.5F}, {0.25F, 0.25F}, {0.75F, 0.5F}, {0.25F, 0.5F},
                                             {0.75F, 0.5F}, {0.75F, 0.25F}, {0.25F, 0.5F}, {0.25F, 0.25F}};
  const Frame frame = *render(leftHalf(2, 2, table), testing::referenceRules());
  EXPECT_EQ(pixelFour(frame, 2), "##");
  EXPECT_EQ(pixelFour(frame, 3), "..");
  EXPECT_EQ(pixelFour(frame, 6), "##");
}

TEST(SampleGrid, LocationsAreClampedToTheRange) {
  using Offset = SampleTables::Offset;
  EXPECT_EQ(offsetsOf(withRange(0, 0.9375F, 4), {-1, 2}, {0.5F, 1}), (std::vector<Offset>{{0, 240}, {128, 240}}));
  EXPECT_EQ(offsetsOf(withRange(0.125F, 0.5F, 4), {-1, 2}, {0, 1}), (std::vector<Offset>{{32, 128}, {32, 128}}));
}

TEST(SampleGrid, LocationsAreRoundedToTheNearestStepAndTiesToTheEvenOne) {
  using Offset = SampleTables::Offset;
  EXPECT_EQ(offsetsOf(withRange(0, 0.9375F, 4), {0.3F, 0.34375F}, {0.40625F, 0.4F}),
            (std::vector<Offset>{{80, 96}, {96, 96}}));  // 4.8 → 5, 5.5 → 6, 6.5 → 6, 6.4 → 6
  EXPECT_EQ(offsetsOf(withRange(0, 0.9375F, 6), {0.3F, 0.34375F}, {0.40625F, 0.4F}),
            (std::vector<Offset>{{76, 88}, {104, 104}}));  // 19.2, 22, 26, 25.6 of 64
}

TEST(SampleGrid, TheSpecificationDoesNotSayWhereALocationBetweenTwoStepsGoes) {
  const Scene between = leftHalf(1, 1, {{0.3F, 0.5F}, {0.75F, 0.5F}});
  const Result<Frame> frame = render(between, Rules::specification(Limits{}));
  ASSERT_FALSE(frame.has_value());
  EXPECT_EQ(frame.error().code, ErrorCode::NotOffered);
  EXPECT_EQ(frame.error().where, "target.sampleLocations.sampleLocations[0]");
  EXPECT_TRUE(render(between, testing::referenceRules()).has_value());
}

TEST(SampleGrid, FinerStepsThanTheReferenceKeepsAreRefused) {
  const Result<Frame> frame = render(leftHalf(1, 1, {{0.25F, 0.5F}, {0.75F, 0.5F}}), withRange(0, 0.9375F, 9));
  ASSERT_FALSE(frame.has_value());
  EXPECT_EQ(frame.error().code, ErrorCode::NotOffered);
}

TEST(SampleGrid, CandidatesAndExplanationsKnowThePlaceOfThePixel) {
  const Scene scene = leftHalf(1, 2, {{0.25F, 0.5F}, {0.75F, 0.5F}, {0.75F, 0.5F}, {0.25F, 0.5F}});
  const std::vector<SampleQuery> queries{{4, 3, 0}, {4, 2, 0}, {4, 3, 1}};
  const auto found = candidates(scene, testing::referenceRules(), queries);
  ASSERT_TRUE(found.has_value());
  EXPECT_TRUE((*found)[0].empty());
  EXPECT_EQ((*found)[1].size(), 1u);
  EXPECT_EQ((*found)[2].size(), 1u);
  const Result<SampleExplanation> explanation = explain(scene, testing::referenceRules(), {4, 3, 1});
  ASSERT_TRUE(explanation.has_value());
  EXPECT_EQ(explanation->position, (SubpixelPosition{4 * 256 + 64, 3 * 256 + 128}));
  EXPECT_NE(explanation->owner, 0u);
  EXPECT_EQ(explanation->rules.back(), Rule::CustomLocations);
}

}  // namespace
}  // namespace rasterdiff::rasterizer
