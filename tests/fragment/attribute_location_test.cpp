// Where inputs are evaluated: the pixel's own coordinates as inputs tell the place.
#include "fragment_support.hpp"
#include "rasterizer/sample_pattern.hpp"

namespace rasterdiff::rasterizer {
namespace {

// x and y of the screen as one input of two components.
void addPosition(Scene& scene, std::string_view name, Interpolation interpolation, float offsetX = 0, float offsetY = 0) {
  std::vector<float> values;
  const std::vector<float> x = pixelsOf(scene, true), y = pixelsOf(scene, false);
  for (size_t i = 0; i < x.size(); ++i) {
    values.push_back(x[i]);
    values.push_back(y[i]);
  }
  addVarying(scene, name, interpolation, 2, values);
  scene.draws[0].varyings.back().offsetX = offsetX;
  scene.draws[0].varyings.back().offsetY = offsetY;
}

// A triangle to the left of a line that leans a little: pixels of column 4 have some samples inside, and no centre.
Scene leaningScene(uint32_t samples) { return testing::sceneOf({{0, 0}, {4.375, 0}, {4.375, 8}, {0, 8}}, 8, samples); }

TEST(AttributeLocation, SampleInputsAreEvaluatedAtEverySample) {
  for (const uint32_t samples : {1U, 2U, 4U, 8U, 16U}) {
    Scene scene = coveringScene(4, samples);
    addPosition(scene, "place", Interpolation::sample);
    for (const Rules& rules : {testing::referenceRules(), specificationRules()}) {
      const std::vector<SubpixelPosition> pattern = *samplePattern(samples, rules);
      const Frame frame = drawn(scene, rules);
      const VaryingPlane& plane = frame.varyings[0];
      for (uint32_t s = 0; s < samples; ++s) {
        const float x = 2 + static_cast<float>(pattern[s].x) / 256, y = 1 + static_cast<float>(pattern[s].y) / 256;
        EXPECT_EQ(plane.values.at(2, 1, s, 0), x);
        EXPECT_EQ(plane.values.at(2, 1, s, 1), y);
        EXPECT_LT(plane.bounds->at(2, 1, s, 0).hi - plane.bounds->at(2, 1, s, 0).lo, 0.0625F);
      }
    }
  }
}

TEST(AttributeLocation, CentroidIsTheCentreOfFullyCoveredPixelsElseTheFirstCoveredSample) {
  Scene scene = leaningScene(4);
  scene.state.topology = PrimitiveTopology::TRIANGLE_FAN;
  addPosition(scene, "place", Interpolation::centroid);
  const Frame frame = drawn(scene);
  const VaryingPlane& plane = frame.varyings[0];
  // Samples at x of 6, 14, 2 and 10 sixteenths: sample 2 alone is left of 4.375, sample 0 lies on it.
  for (uint32_t y = 1; y < 7; ++y) {
    if (y == 4) continue;  // the diagonal may cut pixels elsewhere
    EXPECT_EQ(frame.primitive.at(4, y, 1), 0U);
    ASSERT_NE(frame.primitive.at(4, y, 2), 0U);
    EXPECT_EQ(plane.values.at(4, y, 2, 0), 4.125F);
    EXPECT_EQ(plane.values.at(4, y, 2, 1), static_cast<float>(y) + 10 / 16.0F);
  }
  EXPECT_EQ(plane.values.at(1, 6, 0, 0), 1.5F);
  EXPECT_EQ(plane.values.at(1, 6, 0, 1), 6.5F);
}

TEST(AttributeLocation, CentroidMayBeAnywhereThatThePrimitiveCoversUnderOpenRules) {
  Scene scene = testing::sceneOf({{0, 0}, {4.25, 0}, {4.25, 8}}, 8, 4);
  addPosition(scene, "place", Interpolation::centroid);
  const Frame frame = drawn(scene, specificationRules());
  ASSERT_NE(frame.primitive.at(4, 1, 2), 0U);
  const Bounds x = frame.varyings[0].bounds->at(4, 1, 2, 0);
  EXPECT_TRUE(contains(x, 4.0F));
  EXPECT_TRUE(contains(x, 4.125F));
  EXPECT_TRUE(contains(x, 4.25F));
  EXPECT_FALSE(contains(x, 4.5F));  // the centre is outside of the primitive
  EXPECT_FALSE(contains(x, 3.9F));
}

TEST(AttributeLocation, UndecoratedInputsMayBeAnywhereInThePixelUnderOpenRules) {
  Scene scene = coveringScene(4, 4);
  addPosition(scene, "place", Interpolation::smooth);
  for (const bool open : {false, true}) {
    const Frame frame = drawn(scene, open ? specificationRules() : testing::referenceRules());
    EXPECT_EQ(frame.varyings[0].values.at(1, 1, 3, 0), 1.5F);
    EXPECT_EQ(contains(frame.varyings[0].bounds->at(1, 1, 3, 0), 1.0F), open);
    EXPECT_EQ(contains(frame.varyings[0].bounds->at(1, 1, 3, 1), 2.0F), open);
  }
}

TEST(AttributeLocation, OffsetIsAddedToTheCentre) {
  for (const uint32_t samples : {1U, 4U}) {
    Scene scene = coveringScene(4, samples);
    addPosition(scene, "place", Interpolation::offset, -0.5F, 0.1875F);
    for (const Rules& rules : {testing::referenceRules(), specificationRules()}) {
      const Frame frame = drawn(scene, rules);
      EXPECT_EQ(frame.varyings[0].values.at(1, 2, samples - 1, 0), 1.0F);
      EXPECT_EQ(frame.varyings[0].values.at(1, 2, samples - 1, 1), 2.6875F);
      // A multiple of 1/16 is not rounded.
      EXPECT_FALSE(contains(frame.varyings[0].bounds->at(1, 2, 0, 1), 2.625F));
    }
  }
}

TEST(AttributeLocation, OffsetMayBeRoundedToTheAdvertisedBits) {
  Scene scene = coveringScene(4);
  addPosition(scene, "place", Interpolation::offset, 0.21875F, 0);  // 3.5 / 16
  for (const bool open : {false, true}) {
    const Frame frame = drawn(scene, open ? specificationRules() : testing::referenceRules());
    const Bounds x = frame.varyings[0].bounds->at(1, 2, 0, 0);
    EXPECT_EQ(frame.varyings[0].values.at(1, 2, 0, 0), 1.71875F);
    EXPECT_EQ(contains(x, 1.6875F), open);
    EXPECT_EQ(contains(x, 1.75F), open);
    EXPECT_FALSE(contains(x, 1.625F));
    EXPECT_FALSE(contains(x, 1.8125F));
  }
}

TEST(AttributeLocation, IsCountedWhereItIsNotTheCentre) {
  RuleCounts counts;
  Scene scene = coveringScene(4, 4);
  addPosition(scene, "place", Interpolation::centroid);
  drawn(scene, testing::referenceRules(), &counts);
  EXPECT_EQ(counts[Rule::AttributeLocation], 0U);
  scene.draws[0].varyings[0].interpolation = Interpolation::sample;
  drawn(scene, testing::referenceRules(), &counts);
  EXPECT_EQ(counts[Rule::AttributeLocation], 4U * 4 * 4 * 2);
  EXPECT_EQ(counts[Rule::SampleShading], 4U * 4 * 4);
}

}  // namespace
}  // namespace rasterdiff::rasterizer
