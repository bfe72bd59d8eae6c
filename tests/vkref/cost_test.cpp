// A scene pays for what it needs: attachments, bytes, passes and pipelines, counted where they are made.
#include <cmath>

#include "tests/vkref/driver_fixture.hpp"

namespace rasterdiff::vkref::testing {
namespace {

class DriverCost : public DriverTest {};
RASTERDIFF_ON_ALL_DRIVERS(DriverCost);

TEST_P(DriverCost, CoverageAloneHasTwoColorAttachmentsAndNothingElse) {
  for (uint32_t samples : {1U, 4U}) {
    const Frame frame = draw(sceneOf(wholeTarget(32, 16), 32, 16, samples));
    const RenderCost& cost = device().lastCost();
    EXPECT_EQ(cost.colorAttachments, 2U);
    EXPECT_EQ(cost.depthAttachments, 0U);
    EXPECT_EQ(cost.passes, 1U);
    EXPECT_EQ(cost.attachmentBytes, 32U * 16 * samples * 8);
    EXPECT_EQ(cost.readbackBytes, 32U * 16 * samples * 8);
    EXPECT_FALSE(frame.depth.has_value());
    EXPECT_TRUE(frame.varyings.empty());
    EXPECT_EQ(planeBytes(frame), 32U * 16 * samples * 8);
  }
}

TEST_P(DriverCost, DepthAndEachVaryingAddTheirOwnBytes) {
  Scene scene = sceneOf(wholeTarget(32, 16), 32, 16, 4);
  scene.target.depthFormat = DepthFormat::D32_SFLOAT;
  scene.draws.front().varyings = {constantVarying("a", 3, {1, 2}), constantVarying("b", 3, {1, 2, 3})};
  const Frame frame = draw(scene);
  const RenderCost& cost = device().lastCost();
  EXPECT_EQ(cost.colorAttachments, 4U);
  EXPECT_EQ(cost.depthAttachments, 1U);
  EXPECT_EQ(cost.attachmentBytes, 32U * 16 * 4 * (8 + 4 + 8 + 16));  // three components are stored as four
  EXPECT_EQ(cost.readbackBytes, 32U * 16 * 4 * (8 + 4 + 8 + 12));
  EXPECT_TRUE(frame.depth.has_value());
}

TEST_P(DriverCost, StateThatIsDynamicMakesNoPipeline) {
  Scene scene = sceneOf(wholeTarget());
  scene.target.depthFormat = DepthFormat::D32_SFLOAT;
  draw(scene);
  scene.state.topology = PrimitiveTopology::TRIANGLE_FAN;
  scene.state.cullMode = CullMode::BACK;
  scene.state.frontFace = FrontFace::CLOCKWISE;
  scene.state.depthTestEnable = true;
  scene.state.depthCompareOp = CompareOp::ALWAYS;
  scene.state.depthBiasEnable = true;
  scene.state.depthBiasConstantFactor = 1;
  scene.state.primitiveRestartEnable = true;
  scene.viewport = {1, 2, 3, 4, 0.5F, 0.25F};
  scene.target.width = 16;
  draw(scene);
  EXPECT_EQ(device().lastCost().pipelinesCreated, 0U);
  scene.state.provokingVertexMode = ProvokingVertexMode::LAST_VERTEX;
  scene.state.negativeOneToOne = true;
  draw(scene);
  EXPECT_EQ(device().lastCost().pipelinesCreated, 1U);
}

TEST_P(DriverCost, TimeIsSplitAndPipelinesTakeItOnlyWhenTheyAreMade) {
  Scene scene = sceneOf(wholeTarget(), 8, 8, 4);
  scene.state.provokingVertexMode = ProvokingVertexMode::LAST_VERTEX;
  draw(scene);
  draw(scene);
  const RenderCost again = device().lastCost();
  EXPECT_EQ(again.pipelineSeconds, 0);
  for (const double seconds : {again.uploadSeconds, again.drawSeconds, again.readbackSeconds}) EXPECT_GT(seconds, 0);
  scene.target.depthFormat = DepthFormat::D32_SFLOAT;
  scene.state.depthClampEnable = true;
  scene.draws.front().varyings = {constantVarying("unseen", 3, {1, 2})};
  draw(scene);
  const RenderCost first = device().lastCost();
  EXPECT_EQ(first.pipelineSeconds > 0, first.pipelinesCreated > 0);
  EXPECT_GE(first.uploadSeconds, 0);
}

TEST_P(DriverCost, StateThatASceneDoesNotUseMakesNoPipeline) {
  Scene scene = sceneOf(wholeTarget());
  draw(scene);
  scene.state.lineRasterizationMode = LineRasterizationMode::BRESENHAM;  // but no lines are drawn
  scene.state.pointSize = 7;
  scene.state.depthClipEnable = true;        // as it would be
  scene.state.sampleMask = 0xF0F0F0F1;       // of one sample
  scene.state.minSampleShading = 1;          // but no sample shading
  draw(scene);
  EXPECT_EQ(device().lastCost().pipelinesCreated, 0U);
}

TEST_P(DriverCost, EachBuiltInAddsAPassWithItsOwnBytes) {
  Scene scene = sceneOf(wholeTarget(32, 16), 32, 16, 4);
  scene.builtIns = {BuiltIn::SampleMask, BuiltIn::FragCoord};
  draw(scene);
  EXPECT_EQ(device().lastCost().passes, 3U);
  EXPECT_EQ(device().lastCost().colorAttachments, 4U);
  EXPECT_EQ(device().lastCost().attachmentBytes, 32U * 16 * 4 * (8 + 4 + 16));
}

// Frames that go through the readback buffer in many batches: every sample has to arrive at its own place.
TEST_P(DriverCost, LargeFramesArriveWholeWhateverTheirRowsAre) {
  for (const uint32_t samples : {1U, 4U}) {
    const uint32_t width = samples == 1 ? 1021 : 1531, height = 1103;
    Scene scene = sceneOf(wholeTarget(static_cast<float>(width), static_cast<float>(height)), width, height, samples);
    scene.target.depthFormat = DepthFormat::D32_SFLOAT;
    scene.state.depthTestEnable = scene.state.depthWriteEnable = true;
    scene.builtIns = {BuiltIn::FragCoord};
    const Frame frame = draw(scene);
    size_t wrong = 0;
    for (uint32_t y = 0; y < height; ++y) {
      for (uint32_t x = 0; x < width; ++x) {
        for (uint32_t s = 0; s < samples; ++s) {
          const VaryingPlane& place = frame.varyings[0];
          const bool right = frame.primitive.at(x, y, s) == 1 && frame.count.at(x, y, s) == 1 &&
                             std::floor(place.values.at(x, y, s, 0)) == static_cast<float>(x) &&
                             std::floor(place.values.at(x, y, s, 1)) == static_cast<float>(y) &&
                             frame.depth->at(x, y, s) == place.values.at(x, y, s, 2);
          wrong += right ? 0 : 1;
        }
      }
    }
    EXPECT_EQ(wrong, 0U) << samples;
  }
}

TEST_P(DriverCost, ManyScenesOfManySizesLeaveNoTraceInTheNext) {
  Scene probe = sceneOf({{1.3F, 0.2F, 0.3F}, {7.1F, 2.9F, 0.9F}, {2.2F, 7.7F, 0.1F}}, 8, 8, 4);
  probe.target.depthFormat = DepthFormat::D32_SFLOAT;
  probe.draws.front().varyings = {constantVarying("f", 3, {1, 2, 3, 4})};
  const Frame before = draw(probe);
  for (uint32_t i = 0; i < 200; ++i) {
    const uint32_t extent = 1U << (3 + i % 5);
    Scene scene = sceneOf(wholeTarget(static_cast<float>(extent), static_cast<float>(extent)), extent, extent,
                          i % 2 ? 1 : 4);
    if (i % 3) scene.target.depthFormat = DepthFormat::D32_SFLOAT;
    const Frame frame = draw(scene);
    ASSERT_EQ(frame.primitive.at(extent - 1, extent - 1, 0), 1U);
  }
  const Frame after = draw(probe);
  EXPECT_EQ(device().lastCost().pipelinesCreated, 0U);
  EXPECT_EQ(after.primitive.data, before.primitive.data);
  EXPECT_EQ(after.count.data, before.count.data);
  EXPECT_EQ(after.depth->data, before.depth->data);
  EXPECT_EQ(after.varyings[0].values.data, before.varyings[0].values.data);
}

}  // namespace
}  // namespace rasterdiff::vkref::testing
