// Polygon modes, depth clamp and clip, and depth bias, where every driver has to agree.
#include "tests/vkref/driver_fixture.hpp"

namespace rasterdiff::vkref::testing {
namespace {

using rasterdiff::testing::textMask;

class DriverPolygonMode : public DriverTest {};
RASTERDIFF_ON_ALL_DRIVERS(DriverPolygonMode);
class DriverDepthClip : public DriverTest {};
RASTERDIFF_ON_ALL_DRIVERS(DriverDepthClip);
class DriverDepthBias : public DriverTest {};
RASTERDIFF_ON_ALL_DRIVERS(DriverDepthBias);

/// Two triangles with corners at pixel centres; flat values tell their provoking vertices.
Scene corners(PolygonMode mode) {
  Scene scene = sceneOf({{1.5F, 1.5F}, {6.5F, 1.5F}, {1.5F, 6.5F}, {4.5F, 6.5F}, {6.5F, 6.5F}, {6.5F, 4.5F}});
  scene.state.polygonMode = mode;
  scene.draws.front().varyings = {vertexNumbers(6)};
  return scene;
}

TEST_P(DriverPolygonMode, PointsLieAtTheCorners) {
  const std::optional<Frame> frame =
      drawIf(caps().core().fillModeNonSolid, corners(PolygonMode::POINT), "state.polygonMode");
  ASSERT_TRUE(frame.has_value());
  EXPECT_EQ(textPrimitives(*frame),
            "........\n"
            ".1....1.\n"
            "........\n"
            "........\n"
            "......2.\n"
            "........\n"
            ".1..2.2.\n"
            "........\n");
}

TEST_P(DriverPolygonMode, LinesFollowTheEdgesAndLeaveTheInsideEmpty) {
  const std::optional<Frame> frame =
      drawIf(caps().core().fillModeNonSolid, corners(PolygonMode::LINE), "state.polygonMode");
  ASSERT_TRUE(frame.has_value());
  for (uint32_t i = 2; i < 6; ++i) {
    EXPECT_EQ(frame->primitive.at(i, 1, 0), 1U) << i;
    EXPECT_EQ(frame->primitive.at(1, i, 0), 1U) << i;
  }
  EXPECT_EQ(frame->primitive.at(5, 6, 0), 2U);
  EXPECT_EQ(frame->primitive.at(2, 2, 0), 0U);
  EXPECT_EQ(frame->primitive.at(2, 4, 0), 0U);
}

TEST_P(DriverPolygonMode, EveryModeKeepsThePrimitivesNumberAndFlatValue) {
  for (const auto mode : {PolygonMode::FILL, PolygonMode::LINE, PolygonMode::POINT}) {
    const Frame frame = draw(corners(mode));
    // SwiftShader takes the flat value of any vertex where it draws polygons as lines or points.
    const bool flat = mode == PolygonMode::FILL || GetParam() != std::string("swiftshader");
    uint32_t covered = 0;
    for (size_t i = 0; i < frame.primitive.data.size(); ++i) {
      const uint32_t primitive = frame.primitive.data[i];
      if (primitive == 0) continue;
      ++covered;
      EXPECT_LE(primitive, 2U);
      const float value = frame.varyings[0].values.data[i];
      EXPECT_TRUE(!flat || value == (primitive == 1 ? 0.0F : 3.0F)) << value;
    }
    EXPECT_GE(covered, 6U);
  }
}

/// A strip, or fan, of three triangles, and one more after a restart; all of the strip wind the same way.
Scene pieces(PrimitiveTopology topology, PolygonMode mode, ProvokingVertexMode provoking) {
  Scene scene = sceneOf({{0.5F, 0.5F}, {0.5F, 7.5F}, {4.5F, 0.5F}, {4.5F, 7.5F}, {7.5F, 0.5F}, {7.5F, 7.5F}});
  scene.state.topology = topology;
  scene.state.polygonMode = mode;
  scene.state.provokingVertexMode = provoking;
  scene.state.primitiveRestartEnable = true;
  scene.draws.front().indices = {{0, 1, 2, 3, 4, kRestartIndex, 5, 4, 3}};
  return scene;
}

TEST_P(DriverPolygonMode, StripsAndFansKeepTheirNumbers) {
  for (const auto provoking : {ProvokingVertexMode::FIRST_VERTEX, ProvokingVertexMode::LAST_VERTEX}) {
    Frame frame = draw(pieces(PrimitiveTopology::TRIANGLE_STRIP, PolygonMode::POINT, provoking));
    EXPECT_EQ(frame.primitive.at(0, 0, 0), 1U);
    EXPECT_EQ(frame.primitive.at(0, 7, 0), 2U);
    EXPECT_EQ(frame.primitive.at(4, 0, 0), 3U);
    EXPECT_EQ(frame.primitive.at(7, 0, 0), 4U);
    frame = draw(pieces(PrimitiveTopology::TRIANGLE_FAN, PolygonMode::POINT, provoking));
    EXPECT_EQ(frame.primitive.at(0, 0, 0), 3U);
    EXPECT_EQ(frame.primitive.at(0, 7, 0), 1U);
    EXPECT_EQ(frame.primitive.at(4, 0, 0), 2U);
    EXPECT_EQ(frame.primitive.at(7, 7, 0), 4U);
  }
}

TEST_P(DriverPolygonMode, StripsKeepTheirWinding) {
  for (const auto provoking : {ProvokingVertexMode::FIRST_VERTEX, ProvokingVertexMode::LAST_VERTEX}) {
    Scene scene = pieces(PrimitiveTopology::TRIANGLE_STRIP, PolygonMode::LINE, provoking);
    scene.state.cullMode = CullMode::BACK;
    const Frame front = draw(scene);
    EXPECT_EQ(front.primitive.at(0, 4, 0), 1U);  // the edge of triangle 1 alone
    EXPECT_EQ(front.primitive.at(2, 7, 0), 2U);
    EXPECT_EQ(front.primitive.at(7, 4, 0), 4U);
    scene.state.cullMode = CullMode::FRONT;
    EXPECT_EQ(textMask(draw(scene)).find('#'), std::string::npos);
  }
}

TEST_P(DriverPolygonMode, CullingComesFirst) {
  Scene scene = corners(PolygonMode::LINE);
  scene.state.cullMode = CullMode::FRONT_AND_BACK;
  EXPECT_EQ(textMask(draw(scene)).find('#'), std::string::npos);
}

Scene behind(float z) {
  Scene scene = sceneOf(wholeTarget(8, 8, z));
  scene.target.depthFormat = DepthFormat::D32_SFLOAT;
  scene.state.depthTestEnable = scene.state.depthWriteEnable = true;
  scene.state.depthCompareOp = CompareOp::ALWAYS;
  scene.target.depthClearValue = 0.5F;
  return scene;
}

TEST_P(DriverDepthClip, ClampDrawsWhatIsClippedWithoutAndStoresTheRange) {
  for (float z : {-0.5F, 1.5F}) {
    Scene scene = behind(z);
    EXPECT_EQ(draw(scene).primitive.at(4, 4, 0), 0U);
    scene.state.depthClampEnable = true;
    const std::optional<Frame> frame = drawIf(caps().core().depthClamp, scene, "state.depthClampEnable");
    if (!frame) continue;
    EXPECT_EQ(frame->primitive.at(4, 4, 0), 1U);
    EXPECT_EQ(frame->depth->at(4, 4, 0), z < 0 ? 0.0F : 1.0F);
    scene.viewport.minDepth = 0.25F;
    scene.viewport.maxDepth = 0.75F;
    EXPECT_EQ(draw(scene).depth->at(4, 4, 0), z < 0 ? 0.25F : 0.75F);
  }
}

TEST_P(DriverDepthClip, ClipAndClampAreIndependentWhereTheSceneSaysSo) {
  for (float z : {-0.5F, 1.5F}) {
    for (const bool clamp : {false, true}) {
      for (const bool clip : {false, true}) {
        Scene scene = behind(z);
        scene.state.depthClampEnable = clamp;
        scene.state.depthClipEnable = clip;
        const bool offered = clip != clamp || caps().features.depthClipEnable.depthClipEnable;
        const std::optional<Frame> frame = drawIf(offered, scene, "state.depthClipEnable");
        if (!frame) continue;
        EXPECT_EQ(frame->primitive.at(4, 4, 0), clip ? 0U : 1U) << "clamp " << clamp << ", clip " << clip;
      }
    }
  }
}

TEST_P(DriverDepthBias, ConstantFactorCountsInUnitsOfTheExponent) {
  // [vk:primsrast-depthbias-computation] r = 2^(e - 23) for floats: 2^-24 at z = 0.5, 2^-26 at 0.1875.
  for (const auto& [z, unit] : {std::pair{0.5F, 0x1p-24F}, {0.1875F, 0x1p-26F}}) {
    Scene scene = behind(z);
    scene.state.depthBiasEnable = true;
    scene.state.depthBiasConstantFactor = 4;
    EXPECT_EQ(draw(scene).depth->at(4, 4, 0), z + 4 * unit);
    scene.state.depthBiasEnable = false;
    EXPECT_EQ(draw(scene).depth->at(4, 4, 0), z);
  }
}

TEST_P(DriverDepthBias, SlopeFactorScalesTheSlopeAndTheClampEndsIt) {
  // z grows by 1/32 a pixel in x, and not in y: the exact slope and its bound agree.
  Scene scene = behind(0);
  scene.draws.front() = sceneOf({{0, 0, 0}, {16, 0, 0.5F}, {0, 16, 0}}).draws.front();
  const Frame plain = draw(scene);
  scene.state.depthBiasEnable = true;
  scene.state.depthBiasSlopeFactor = 2;
  const float bound = 0x1p-22F;  // a few roundings of values below 0.5, each at most 2^-25
  const Frame biased = draw(scene);
  for (uint32_t x = 0; x < 8; ++x) {
    EXPECT_NEAR(biased.depth->at(x, 3, 0), plain.depth->at(x, 3, 0) + 2.0F / 32, bound) << x;
  }
  scene.state.depthBiasClamp = 0.03125F;
  const std::optional<Frame> clamped = drawIf(caps().core().depthBiasClamp, scene, "state.depthBiasClamp");
  if (!clamped) return;
  for (uint32_t x = 0; x < 8; ++x) {
    EXPECT_NEAR(clamped->depth->at(x, 3, 0), plain.depth->at(x, 3, 0) + 0.03125F, bound) << x;
  }
}

}  // namespace
}  // namespace rasterdiff::vkref::testing
