// Observed built-ins, one plane each after the varyings.
#include "fragment_support.hpp"
#include "rasterizer/sample_pattern.hpp"

namespace rasterdiff::rasterizer {
namespace {

Scene observing(std::vector<BuiltIn> builtIns, uint32_t samples = 1) {
  Scene scene = coveringScene(4, samples, 0.25, 0.75, 0.25);
  scene.builtIns = std::move(builtIns);
  return scene;
}

TEST(FragCoord, IsTheCentreTheDepthAndOneOverW) {
  for (const uint32_t samples : {1U, 4U}) {
    Scene scene = observing({BuiltIn::FragCoord}, samples);
    for (ClipPosition& p : scene.draws[0].positions) p = {4 * p.x, 4 * p.y, 4 * p.z, 4};
    const Frame frame = drawn(scene);
    const Plane<float>& values = planeOf(frame.varyings, "FragCoord").values;
    ASSERT_EQ(values.components, 4U);
    EXPECT_EQ(values.at(3, 1, samples - 1, 0), 3.5F);
    EXPECT_EQ(values.at(3, 1, samples - 1, 1), 1.5F);
    EXPECT_EQ(values.at(3, 1, samples - 1, 2), 0.25F + 0.5F * 3.5F / 8);
    EXPECT_EQ(values.at(3, 1, samples - 1, 3), 0.25F);
    EXPECT_FALSE(frame.depth.has_value());
  }
}

TEST(FragCoord, IsAtTheSampleUnderSampleShading) {
  for (const bool byState : {false, true}) {
    Scene scene = observing({BuiltIn::FragCoord}, 4);
    if (byState) {
      scene.state.sampleShadingEnable = true;
      scene.state.minSampleShading = 1;
    } else {
      scene.builtIns.push_back(BuiltIn::SampleId);
    }
    for (const Rules& rules : {testing::referenceRules(), specificationRules()}) {
      const std::vector<SubpixelPosition> pattern = *samplePattern(4, rules);
      const Frame frame = drawn(scene, rules);
      for (uint32_t s = 0; s < 4; ++s) {
        const float x = 2 + static_cast<float>(pattern[s].x) / 256;
        EXPECT_EQ(frame.varyings[0].values.at(2, 2, s, 0), x);
        EXPECT_EQ(frame.varyings[0].bounds->at(2, 2, s, 0).lo, x);
        EXPECT_EQ(frame.varyings[0].bounds->at(2, 2, s, 0).hi, x);
        EXPECT_EQ(frame.varyings[0].values.at(2, 2, s, 2), 0.25F + 0.5F * x / 8);
      }
    }
  }
}

// [vk:primsrast-sampleshading] a sample input may make the shader run for every sample, or not.
TEST(FragCoord, MayBeAtTheSampleWhereAnInputIsASampleInput) {
  Scene scene = observing({BuiltIn::FragCoord}, 4);
  addVarying(scene, "x", Interpolation::sample, 1, pixelsOf(scene, true));
  const Frame frame = drawn(scene, specificationRules());
  const Bounds x = planeOf(frame.varyings, "FragCoord").bounds->at(2, 2, 1, 0);
  EXPECT_EQ(x.lo, 2.5F);
  EXPECT_EQ(x.hi, 2.875F);
}

TEST(FragCoord, ShowsTheBiasedDepth) {
  Scene scene = observing({BuiltIn::FragCoord});
  useDepth(scene);
  scene.state.depthBiasEnable = true;
  scene.state.depthBiasSlopeFactor = 2;  // m = 1/16
  const Frame frame = drawn(scene);
  EXPECT_EQ(frame.varyings[0].values.at(1, 1, 0, 2), frame.depth->at(1, 1, 0));
  EXPECT_EQ(frame.depth->at(1, 1, 0), 0.25F + 0.5F * 1.5F / 8 + 0.125F);
}

TEST(FrontFacing, IsThatOfTheTriangleAndTrueForLinesAndPoints) {
  for (const FrontFace face : {FrontFace::COUNTER_CLOCKWISE, FrontFace::CLOCKWISE}) {
    Scene scene = observing({BuiltIn::FrontFacing});
    scene.state.frontFace = face;
    for (const Rules& rules : {testing::referenceRules(), specificationRules()}) {
      const Frame frame = drawn(scene, rules);
      const float expected = face == FrontFace::CLOCKWISE ? 1 : 0;  // clockwise on a screen whose y points down
      EXPECT_EQ(frame.varyings[0].values.at(0, 0, 0), expected);
      EXPECT_EQ(frame.varyings[0].bounds->at(0, 0, 0).lo, expected);
      EXPECT_EQ(frame.varyings[0].bounds->at(0, 0, 0).hi, expected);
    }
    for (const auto topology : {PrimitiveTopology::POINT_LIST, PrimitiveTopology::LINE_LIST}) {
      Scene other = testing::sceneOf({{1.5, 1.5}, {6.5, 1.5}}, 8);
      other.builtIns = {BuiltIn::FrontFacing};
      other.state.topology = topology;
      other.state.frontFace = face;
      EXPECT_EQ(drawn(other).varyings[0].values.at(1, 1, 0), 1.0F);
    }
  }
}

TEST(FrontFacing, IsFreeWhereSnappingMayTurnTheTriangle) {
  // A third of a subpixel thick.
  Scene scene = testing::sceneOf({{0.5, 0.5}, {7.5, 7.5}, {4, 4 + 1 / 768.0}}, 8);
  scene.builtIns = {BuiltIn::FrontFacing};
  const Frame frame = drawn(scene, specificationRules());
  for (size_t i = 0; i < frame.primitive.data.size(); ++i) {
    if (frame.primitive.data[i] == 0) continue;
    EXPECT_EQ(frame.varyings[0].bounds->data[i].lo, 0.0F);
    EXPECT_EQ(frame.varyings[0].bounds->data[i].hi, 1.0F);
  }
}

TEST(SampleMaskIn, HasTheBitsOfTheCoveredSamples) {
  // Left of x = 4.5: of the samples at 6, 14, 2 and 10 sixteenths the first and the third.
  Scene scene = testing::sceneOf({{0, 0}, {4.5, 0}, {4.5, 8}, {0, 8}}, 8, 4);
  scene.state.topology = PrimitiveTopology::TRIANGLE_FAN;
  scene.builtIns = {BuiltIn::SampleMask};
  for (const Rules& rules : {testing::referenceRules(), specificationRules()}) {
    const Frame frame = drawn(scene, rules);
    const VaryingPlane& plane = planeOf(frame.varyings, "SampleMask");
    for (const uint32_t s : {0U, 2U}) {
      EXPECT_EQ(plane.values.at(4, 1, s), 5.0F);
      EXPECT_EQ(plane.bounds->at(4, 1, s).lo, 5.0F);
      EXPECT_EQ(plane.bounds->at(4, 1, s).hi, 5.0F);
    }
    EXPECT_EQ(plane.values.at(1, 6, 0), 15.0F);
  }
}

TEST(SampleMaskIn, HoldsFreeSamplesAsFree) {
  Scene scene = testing::sceneOf({{0, 0}, {4.375 + 1 / 1024.0, 0}, {4.375 + 1 / 1024.0, 8}, {0, 8}}, 8, 4);
  scene.state.topology = PrimitiveTopology::TRIANGLE_FAN;
  scene.builtIns = {BuiltIn::SampleMask};
  const Frame frame = drawn(scene, specificationRules());
  const Bounds mask = frame.varyings[0].bounds->at(4, 1, 2);  // sample 0 lies within a rounding of the edge
  EXPECT_EQ(mask.lo, 4.0F);
  EXPECT_EQ(mask.hi, 5.0F);
}

TEST(SampleMaskIn, IsTheShadedSampleUnderSampleShading) {
  Scene scene = observing({BuiltIn::SampleMask, BuiltIn::SampleId, BuiltIn::SamplePosition}, 4);
  const Frame frame = drawn(scene, specificationRules());
  const std::vector<SubpixelPosition> pattern = *samplePattern(4, testing::referenceRules());
  for (uint32_t s = 0; s < 4; ++s) {
    EXPECT_EQ(planeOf(frame.varyings, "SampleMask").values.at(1, 1, s), static_cast<float>(1U << s));
    EXPECT_EQ(planeOf(frame.varyings, "SampleMask").bounds->at(1, 1, s).hi, static_cast<float>(1U << s));
    EXPECT_EQ(planeOf(frame.varyings, "SampleId").values.at(1, 1, s), static_cast<float>(s));
    EXPECT_EQ(planeOf(frame.varyings, "SamplePosition").values.at(1, 1, s, 0), static_cast<float>(pattern[s].x) / 256);
    EXPECT_EQ(planeOf(frame.varyings, "SamplePosition").values.at(1, 1, s, 1), static_cast<float>(pattern[s].y) / 256);
  }
}

TEST(BuiltIns, FollowTheVaryingsInTheirOrder) {
  Scene scene = observing({BuiltIn::SampleId, BuiltIn::FragCoord});
  addVarying(scene, "x", Interpolation::smooth, 1, pixelsOf(scene, true));
  const Frame frame = drawn(scene);
  ASSERT_EQ(frame.varyings.size(), 3U);
  EXPECT_EQ(frame.varyings[0].name, "x");
  EXPECT_EQ(frame.varyings[1].name, "SampleId");
  EXPECT_EQ(frame.varyings[2].name, "FragCoord");
}

}  // namespace
}  // namespace rasterdiff::rasterizer
