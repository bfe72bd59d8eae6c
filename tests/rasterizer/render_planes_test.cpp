// Which planes a frame has, what they cost, and what the three-valued plane says of the freedoms.
#include <gtest/gtest.h>

#include "rasterizer/render.hpp"
#include "scene/generators/random_triangles.hpp"
#include "tests/support/scenes.hpp"

namespace rasterdiff::rasterizer {
namespace {

Rules openRules() { return Rules::specification(Limits{}); }

TEST(Planes, CoverageOnlySceneHoldsPrimitiveAndCountAndNothingElse) {
  for (const uint32_t samples : {1U, 4U}) {
    const Frame frame = *render(testing::sceneOf({{0, 0}, {8, 0}, {0, 8}}, 8, samples), testing::referenceRules());
    EXPECT_FALSE(frame.depth);
    EXPECT_FALSE(frame.depthBounds);
    EXPECT_FALSE(frame.coverage);
    EXPECT_TRUE(frame.varyings.empty());
    EXPECT_EQ(planeBytes(frame), size_t{8} * 8 * samples * (sizeof(uint32_t) + sizeof(uint32_t)));
  }
}

TEST(Planes, OpenRulesAddOneByteASample) {
  const Frame frame = *render(testing::sceneOf({{0, 0}, {8, 0}, {0, 8}}, 8, 4), openRules());
  EXPECT_EQ(planeBytes(frame), size_t{8} * 8 * 4 * (4 + 4 + 1));
}

TEST(Planes, DepthAndVaryingsAddTheirOwnAndTheirBounds) {
  Scene scene = testing::sceneOf({{0, 0}, {8, 0}, {0, 8}}, 8);
  scene.target.depthFormat = DepthFormat::D32_SFLOAT;
  EXPECT_EQ(planeBytes(*render(scene, testing::referenceRules())), 64U * (8 + 4 + 8));
  scene.draws[0].varyings = {{"a", Interpolation::smooth, 3, std::vector<float>(9)}, {"b", Interpolation::flat, 1, {1, 2, 3}}};
  const Frame frame = *render(scene, testing::referenceRules());
  EXPECT_EQ(planeBytes(frame), 64U * (8 + 12 + 4 * 12));
  ASSERT_EQ(frame.varyings.size(), 2U);
  EXPECT_EQ(frame.varyings[0].name, "a");
  EXPECT_EQ(frame.varyings[0].values.components, 3U);
}

TEST(Planes, WhereNothingIsDrawnDepthIsTheClearValueAndValuesAreZero) {
  Scene scene = testing::sceneOf({{0, 0}, {2, 0}, {0, 2}}, 8);
  scene.target.depthFormat = DepthFormat::D32_SFLOAT;
  scene.target.depthClearValue = 0.25F;
  scene.draws[0].varyings = {{"a", Interpolation::smooth, 1, {3, 3, 3}}};
  const Frame frame = *render(scene, testing::referenceRules());
  ASSERT_TRUE(frame.depth);
  EXPECT_EQ(frame.depth->at(7, 7, 0), 0.25F);
  EXPECT_EQ(frame.depthBounds->at(7, 7, 0).lo, 0.25F);
  EXPECT_EQ(frame.depthBounds->at(7, 7, 0).hi, 0.25F);
  EXPECT_EQ(frame.varyings[0].values.at(7, 7, 0), 0);
}

char letter(Coverage coverage) { return coverage == Coverage::In ? '#' : coverage == Coverage::Out ? '.' : '?'; }

std::string coverageText(const Frame& frame) {
  std::string text;
  for (uint32_t y = 0; y < frame.height; ++y) {
    for (uint32_t x = 0; x < frame.width; ++x) text += letter(frame.coverage->at(x, y, 0));
    text += '\n';
  }
  return text;
}

TEST(ThreeValuedPlane, TiesAreFreeAndNothingElseIsWhereVerticesLieOnTheGrid) {
  EXPECT_EQ(coverageText(*render(testing::sceneOf({{1.5, 1.5}, {6.5, 1.5}, {1.5, 6.5}}, 8), openRules())),
            "........\n"
            ".??????.\n"
            ".?###?..\n"
            ".?##?...\n"
            ".?#?....\n"
            ".??.....\n"
            ".?......\n"
            "........\n");
}

TEST(ThreeValuedPlane, SampleCoveredByAnyPrimitiveForSureIsIn) {
  // The diagonal is free for each triangle, but the third one covers it for sure.
  const Scene scene = testing::sceneOf({{1.5, 1.5}, {5.5, 5.5}, {1.5, 5.5}, {0, 0}, {8, 0}, {8, 8}, {0, 0}, {20, 0}, {0, 20}}, 8);
  const Plane<Coverage> plane = render(scene, openRules())->coverage.value();
  for (const Coverage coverage : plane.data) EXPECT_EQ(coverage, Coverage::In);
}

TEST(ThreeValuedPlane, ScissorIsCertain) {
  Scene scene = testing::sceneOf({{-20, -20}, {40, -20}, {-20, 40}}, 8);
  scene.scissor = Rect2D{2, 2, 4, 4};
  const std::string text = coverageText(*render(scene, openRules()));
  EXPECT_EQ(text, "........\n........\n..####..\n..####..\n..####..\n..####..\n........\n........\n");
}

TEST(ThreeValuedPlane, CulledWhateverTheSnapIsOut) {
  Scene scene = testing::sceneOf({{1.1, 1.2}, {6.3, 1.4}, {1.5, 6.6}}, 8);
  scene.state.cullMode = CullMode::BACK;
  const Plane<Coverage> plane = render(scene, openRules())->coverage.value();
  for (const Coverage coverage : plane.data) EXPECT_EQ(coverage, Coverage::Out);
}

// The nominal outcome of every profile, and every mutant that stays within the law, is one of the free outcomes.
TEST(ThreeValuedPlane, AgreesWithTheNominalOutcomeOfEveryProfileAndOwner) {
  uint64_t free = 0;
  for (const Grid grid : {Grid::Half, Grid::Sixteenth, Grid::TwoHundredFiftySixth, Grid::Free}) {
    for (const uint32_t samples : {1U, 4U}) {
      for (const bool perspective : {false, true}) {
        const Scene scene = randomTriangles({77, 300, grid, samples, perspective, 128, false});
        const Frame open = *render(scene, openRules());
        for (const std::string_view profile : profiles()) {
          for (const TieOwner owner : {TieOwner::TopLeft, TieOwner::TopRight, TieOwner::BottomLeft, TieOwner::BottomRight}) {
            Rules rules = *Rules::profile(profile, Limits{});
            rules.choices.tieOwner = owner;
            const Frame closed = *render(scene, rules);
            for (size_t i = 0; i < closed.primitive.data.size(); ++i) {
              const Coverage coverage = open.coverage->data[i];
              const bool covered = closed.primitive.data[i] != 0;
              EXPECT_FALSE(coverage == Coverage::In && !covered) << profile;
              EXPECT_FALSE(coverage == Coverage::Out && covered) << profile;
              free += coverage == Coverage::Either ? 1 : 0;
            }
          }
        }
      }
    }
  }
  EXPECT_GT(free, 10000U);
}

}  // namespace
}  // namespace rasterdiff::rasterizer
