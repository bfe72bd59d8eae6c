// Depth attachments: stored values, tests, ranges and the clip-space convention.
#include "tests/vkref/driver_fixture.hpp"

namespace rasterdiff::vkref::testing {
namespace {

class DriverDepth : public DriverTest {};
RASTERDIFF_ON_ALL_DRIVERS(DriverDepth);

Scene depthScene(const std::vector<Point>& points, uint32_t samples) {
  Scene scene = sceneOf(points, 8, 8, samples);
  scene.target.depthFormat = DepthFormat::D32_SFLOAT;
  scene.state.depthTestEnable = true;
  scene.state.depthWriteEnable = true;
  return scene;
}

TEST_P(DriverDepth, ConstantDepthIsStoredExactlyAndTheRestKeepsTheClearValue) {
  for (uint32_t samples : {1U, 4U}) {
    Scene scene = depthScene({{0, 0, 0.25F}, {4, 0, 0.25F}, {0, 4, 0.25F}}, samples);
    scene.target.depthClearValue = 0.75F;
    const Frame frame = draw(scene);
    ASSERT_TRUE(frame.depth.has_value());
    for (size_t i = 0; i < frame.depth->data.size(); ++i) {
      ASSERT_EQ(frame.depth->data[i], frame.primitive.data[i] ? 0.25F : 0.75F);
    }
  }
}

TEST_P(DriverDepth, TheTestDecidesWhoOwnsASampleAndWhatIsCounted) {
  std::vector<Point> points = wholeTarget(8, 8, 0.5F);
  for (const Point& p : wholeTarget(8, 8, 0.75F)) points.push_back(p);  // behind
  for (const Point& p : wholeTarget(8, 8, 0.25F)) points.push_back(p);  // in front
  for (uint32_t samples : {1U, 4U}) {
    Scene scene = depthScene(points, samples);
    Frame frame = draw(scene);
    EXPECT_EQ(frame.primitive.at(3, 3, 0), 3U);
    EXPECT_EQ(frame.count.at(3, 3, 0), 2U);
    EXPECT_EQ(frame.depth->at(3, 3, 0), 0.25F);
    scene.state.depthCompareOp = CompareOp::GREATER;
    scene.target.depthClearValue = 0;
    frame = draw(scene);
    EXPECT_EQ(frame.primitive.at(3, 3, 0), 2U);
    EXPECT_EQ(frame.count.at(3, 3, 0), 2U);
    scene.state.depthCompareOp = CompareOp::NEVER;
    frame = draw(scene);
    EXPECT_EQ(frame.count.at(3, 3, 0), 0U);
    EXPECT_EQ(frame.depth->at(3, 3, 0), 0.0F);
  }
}

TEST_P(DriverDepth, WithoutWritesTheClearValueStays) {
  Scene scene = depthScene(wholeTarget(), 1);
  scene.state.depthWriteEnable = false;
  const Frame frame = draw(scene);
  EXPECT_EQ(frame.primitive.at(0, 0, 0), 1U);
  EXPECT_EQ(frame.depth->at(0, 0, 0), 1.0F);
}

TEST_P(DriverDepth, ADepthRangeMayBeReversed) {
  Scene scene = depthScene(wholeTarget(8, 8, 0.25F), 1);
  scene.viewport.minDepth = 1;
  scene.viewport.maxDepth = 0.5F;
  EXPECT_EQ(draw(scene).depth->at(4, 4, 0), 0.875F);  // 1 + 0.25 × (0.5 - 1)
}

TEST_P(DriverDepth, NegativeOneToOneShowsWhatZeroToOneClips) {
  Scene scene = depthScene(wholeTarget(8, 8, -0.5F), 1);
  EXPECT_EQ(draw(scene).primitive.at(4, 4, 0), 0U);
  scene.state.negativeOneToOne = true;
  const Frame frame = draw(scene);
  EXPECT_EQ(frame.primitive.at(4, 4, 0), 1U);
  EXPECT_EQ(frame.depth->at(4, 4, 0), 0.25F);  // (-0.5 + 1) / 2
}

}  // namespace
}  // namespace rasterdiff::vkref::testing
