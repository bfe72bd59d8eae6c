// Multisampling: masks, sample shading, alpha to coverage, where inputs are evaluated, and resolving.
#include "tests/vkref/driver_fixture.hpp"

namespace rasterdiff::vkref::testing {
namespace {

using rasterdiff::testing::textMask;

class DriverSampling : public DriverTest {};
RASTERDIFF_ON_ALL_DRIVERS(DriverSampling);
class DriverResolve : public DriverTest {};
RASTERDIFF_ON_ALL_DRIVERS(DriverResolve);

/// [vk:primsrast-multisampling] the four standard locations, in pixels.
constexpr float kSamples[4][2] = {{0.375F, 0.125F}, {0.875F, 0.375F}, {0.125F, 0.625F}, {0.625F, 0.875F}};

// Far above any float32 evaluation error of values of size 8 on 8 pixels, far below an eighth of a pixel.
constexpr float kTellsPositionsApart = 1e-4F;

/// The vertex's own x and y: what is interpolated is where it was evaluated.
Varying place(const std::vector<Point>& points, Interpolation interpolation) {
  Varying varying{"place", interpolation, 2, {}};
  for (const Point& p : points) varying.values.insert(varying.values.end(), {p.x, p.y});
  return varying;
}

Scene placed(const std::vector<Point>& points, Interpolation interpolation, uint32_t samples = 4) {
  Scene scene = sceneOf(points, 8, 8, samples);
  scene.draws.front().varyings = {place(points, interpolation)};
  return scene;
}

TEST_P(DriverSampling, TheSampleMaskLeavesOutWhatItHasNoBitFor) {
  for (uint32_t mask = 0; mask < 16; ++mask) {
    Scene scene = sceneOf(wholeTarget(), 8, 8, 4);
    scene.state.sampleMask = 0xFFFFFFF0U | mask;
    const Frame frame = draw(scene);
    for (uint32_t s = 0; s < 4; ++s) EXPECT_EQ(frame.count.at(5, 2, s), (mask >> s) & 1) << mask;
  }
}

TEST_P(DriverSampling, TheMaskThatTheShaderWritesLeavesOutWhatItHasNoBitFor) {
  for (uint32_t samples : {1U, 4U}) {
    for (uint32_t bits = 0; bits < 16; ++bits) {
      Scene scene = sceneOf(wholeTarget(), 8, 8, samples);
      scene.state.shaderSampleMask = ShaderSampleMask::CONSTANT;
      scene.draws[0].shaderSampleMaskBits = 0xFFFFFFF0U | bits;
      const Frame constant = draw(scene);
      scene.state.shaderSampleMask = ShaderSampleMask::INPUT_SHIFTED;
      const Frame shifted = draw(scene);
      for (uint32_t s = 0; s < samples; ++s) {
        EXPECT_EQ(constant.count.at(5, 2, s), (bits >> s) & 1) << bits;
        EXPECT_EQ(shifted.count.at(5, 2, s), s == 0 ? 0 : (bits >> s) & 1) << bits;
      }
    }
  }
}

// Values and built-ins come from passes of their own: each writes the mask.
TEST_P(DriverSampling, TheMaskThatTheShaderWritesIsThatOfEveryPass) {
  Scene scene = placed(wholeTarget(), Interpolation::smooth);
  const Varying one = scene.draws[0].varyings[0];
  for (const char* name : {"a", "b", "c", "d", "e", "f", "g"}) {
    scene.draws[0].varyings.push_back(one);
    scene.draws[0].varyings.back().name = name;
  }
  scene.builtIns = {BuiltIn::FragCoord};
  for (const ShaderSampleMask mask : {ShaderSampleMask::CONSTANT, ShaderSampleMask::INPUT_SHIFTED}) {
    scene.state.shaderSampleMask = mask;
    scene.draws[0].shaderSampleMaskBits = 0x6;
    const Frame frame = draw(scene);
    ASSERT_EQ(frame.varyings.size(), 9U);
    for (uint32_t s = 0; s < 4; ++s) {
      const bool kept = s == 1 || s == 2;
      EXPECT_EQ(frame.primitive.at(5, 2, s), kept ? 1U : 0U);
      for (const VaryingPlane& plane : frame.varyings) EXPECT_EQ(plane.values.at(5, 2, s, 0) != 0, kept) << plane.name << s;
    }
  }
}

TEST_P(DriverSampling, TheSampleMaskHoldsForOneSampleToo) {
  Scene scene = sceneOf(wholeTarget());
  scene.state.sampleMask = 1;
  EXPECT_EQ(draw(scene).primitive.at(4, 4, 0), 1U);
  scene.state.sampleMask = 0xFFFFFFFE;
  const Frame frame = draw(scene);
  if (GetParam() == std::string("lavapipe")) return;  // 22.3 does not look at the mask of a single sample
  EXPECT_EQ(textMask(frame).find('#'), std::string::npos);
}

TEST_P(DriverSampling, SampleShadingRunsOnceASample) {
  Scene scene = placed(wholeTarget(), Interpolation::smooth);
  scene.state.sampleShadingEnable = true;
  scene.state.minSampleShading = 1;
  scene.builtIns = {BuiltIn::FragCoord};
  const Frame frame = draw(scene);
  for (uint32_t s = 0; s < 4; ++s) {
    for (uint32_t c = 0; c < 2; ++c) {
      const float corner = c == 0 ? 3 : 2;
      // [vk:interfaces-builtin-variables] FragCoord is at the sample; an undecorated input is anywhere in the pixel.
      EXPECT_EQ(frame.varyings[1].values.at(3, 2, s, c), corner + kSamples[s][c]) << s;
      EXPECT_NEAR(frame.varyings[0].values.at(3, 2, s, c), corner + 0.5F, 0.5F + kTellsPositionsApart) << s;
    }
    EXPECT_EQ(frame.count.at(3, 2, s), 1U);
  }
}

TEST_P(DriverSampling, SampleInputsAreEvaluatedAtTheSamples) {
  const Frame frame = draw(placed(wholeTarget(), Interpolation::sample));
  for (uint32_t s = 0; s < 4; ++s) {
    EXPECT_NEAR(frame.varyings[0].values.at(3, 2, s, 0), 3 + kSamples[s][0], kTellsPositionsApart) << s;
    EXPECT_NEAR(frame.varyings[0].values.at(3, 2, s, 1), 2 + kSamples[s][1], kTellsPositionsApart) << s;
  }
}

TEST_P(DriverSampling, CentroidInputsAreEvaluatedInsideThePrimitive) {
  // The triangle's left edge is x = 3.7: in pixel 3 only sample 1 at 3.875 is covered, and the centre is not.
  const std::vector<Point> points = {{3.6875F, 0}, {16, 0}, {3.6875F, 16}};
  const Frame frame = draw(placed(points, Interpolation::centroid));
  ASSERT_EQ(frame.primitive.at(3, 2, 1), 1U);
  EXPECT_GE(frame.varyings[0].values.at(3, 2, 1, 0), 3.6875F - kTellsPositionsApart);
  EXPECT_LE(frame.varyings[0].values.at(3, 2, 1, 0), 4 + kTellsPositionsApart);
}

TEST_P(DriverSampling, OffsetInputsAreEvaluatedBesideTheCentre) {
  for (uint32_t samples : {1U, 4U}) {
    Scene scene = placed(wholeTarget(), Interpolation::offset, samples);
    scene.draws.front().varyings.push_back(place(wholeTarget(), Interpolation::smooth));
    scene.draws.front().varyings.back().name = "centre";
    scene.draws.front().varyings.front().offsetX = 0.25F;
    scene.draws.front().varyings.front().offsetY = -0.4375F;
    const Frame frame = draw(scene);
    EXPECT_NEAR(frame.varyings[0].values.at(3, 2, 0, 0), 3.75F, kTellsPositionsApart);
    EXPECT_NEAR(frame.varyings[0].values.at(3, 2, 0, 1), 2.0625F, kTellsPositionsApart);
    // An undecorated input beside it stays where it may be: at the centre of one sample, in the pixel of several.
    EXPECT_NEAR(frame.varyings[1].values.at(3, 2, 0, 0), 3.5F, (samples == 1 ? 0 : 0.5F) + kTellsPositionsApart);
  }
}

/// A varying of four components whose alpha is constant.
Varying alphaVarying(float alpha) { return constantVarying("rgba", 3, {0.25F, 0.5F, 0.75F, alpha}); }

TEST_P(DriverSampling, AlphaMakesCoverage) {
  for (float alpha : {0.0F, 0.25F, 0.5F, 1.0F}) {
    Scene scene = sceneOf(wholeTarget(), 8, 8, 4);
    scene.draws.front().varyings = {alphaVarying(alpha), constantVarying("b", 3, {3, 4})};
    scene.state.alphaToCoverageEnable = true;
    const Frame frame = draw(scene);
    uint32_t covered = 0;
    for (uint32_t s = 0; s < 4; ++s) {
      const bool in = frame.primitive.at(4, 4, s) == 1;
      covered += in;
      EXPECT_EQ(frame.count.at(4, 4, s), in ? 1U : 0U);
      EXPECT_EQ(frame.varyings[0].values.at(4, 4, s, 3), in ? alpha : 0.0F);
      EXPECT_EQ(frame.varyings[0].values.at(4, 4, s, 0), in ? 0.25F : 0.0F);
      EXPECT_EQ(frame.varyings[1].values.at(4, 4, s, 1), in ? 4.0F : 0.0F);
    }
    EXPECT_LE(covered, alpha == 0 ? 0U : 4U);
    EXPECT_GE(covered, alpha == 1 ? 4U : 0U);
  }
}

TEST_P(DriverSampling, AlphaMakesTheSameCoverageInEveryPass) {
  Scene scene = sceneOf(wholeTarget(), 8, 8, 4);
  scene.state.alphaToCoverageEnable = true;
  scene.draws.front().varyings = {alphaVarying(0.5F)};
  for (int v = 1; v < 8; ++v) {
    scene.draws.front().varyings.push_back(constantVarying(fmt::format("v{}", v), 3, {static_cast<float>(v)}));
  }
  scene.builtIns = {BuiltIn::FragCoord};
  const Frame frame = draw(scene);
  EXPECT_GE(device().lastCost().passes, 3U);
  for (uint32_t s = 0; s < 4; ++s) {
    const bool in = frame.primitive.at(4, 4, s) == 1;
    EXPECT_EQ(frame.varyings[0].values.at(4, 4, s, 3), in ? 0.5F : 0.0F);
    for (uint32_t v = 1; v < 8; ++v) {
      EXPECT_EQ(frame.varyings[v].values.at(4, 4, s), in ? static_cast<float>(v) : 0.0F) << v;
    }
    EXPECT_EQ(frame.varyings[8].values.at(4, 4, s, 3), in ? 1.0F : 0.0F);
  }
}

TEST_P(DriverResolve, TheMeanOfTheSamplesIsStoredOnceAPixel) {
  // Left of x = 4.5 is drawn: in pixel 4, samples 0 and 2. All values are exact in any order of adding.
  Scene scene = sceneOf({{-8, -8}, {4.5F, -8}, {4.5F, 24}, {-8, -8}, {4.5F, 24}, {-8, 24}}, 8, 8, 4);
  scene.target.resolve = true;
  scene.draws.front().varyings = {constantVarying("a", 6, {1}), constantVarying("b", 6, {2, -4}),
                                  constantVarying("c", 6, {8, 16, 32})};
  const Frame frame = draw(scene);
  ASSERT_EQ(frame.resolved.size(), 3U);
  for (size_t v = 0; v < 3; ++v) {
    const Plane<float>& resolved = frame.resolved[v].values;
    const Plane<float>& sampled = frame.varyings[v].values;
    EXPECT_EQ(frame.resolved[v].name, frame.varyings[v].name);
    ASSERT_EQ(resolved.samples, 1U);
    ASSERT_EQ(resolved.components, sampled.components);
    for (uint32_t x = 0; x < 8; ++x) {
      for (uint32_t c = 0; c < resolved.components; ++c) {
        float sum = 0;
        for (uint32_t s = 0; s < 4; ++s) sum += sampled.at(x, 3, s, c);
        EXPECT_EQ(resolved.at(x, 3, 0, c), sum / 4) << x;
      }
    }
    EXPECT_EQ(resolved.at(4, 3, 0), sampled.at(0, 3, 0) / 2);
  }
  EXPECT_EQ(device().lastCost().colorAttachments, 8U);
}

TEST_P(DriverResolve, VaryingsOfAllPassesAreResolvedAlsoWithAlpha) {
  Scene scene = sceneOf(wholeTarget(), 8, 8, 4);
  scene.target.resolve = true;
  scene.draws.front().varyings = {alphaVarying(1)};
  for (int v = 1; v < 8; ++v) {
    scene.draws.front().varyings.push_back(constantVarying(fmt::format("v{}", v), 3, {static_cast<float>(v)}));
  }
  for (const bool alpha : {false, true}) {
    scene.state.alphaToCoverageEnable = alpha;
    const Frame frame = draw(scene);
    ASSERT_EQ(frame.resolved.size(), 8U);
    EXPECT_EQ(frame.resolved[0].values.at(2, 2, 0, 2), 0.75F);
    for (uint32_t v = 1; v < 8; ++v) EXPECT_EQ(frame.resolved[v].values.at(2, 2, 0), static_cast<float>(v));
  }
}

TEST_P(DriverResolve, ScenesThatDoNotAskGetNone) {
  Scene scene = sceneOf(wholeTarget(), 8, 8, 4);
  scene.draws.front().varyings = {constantVarying("a", 3, {1})};
  EXPECT_TRUE(draw(scene).resolved.empty());
  EXPECT_EQ(device().lastCost().colorAttachments, 3U);
}

}  // namespace
}  // namespace rasterdiff::vkref::testing
