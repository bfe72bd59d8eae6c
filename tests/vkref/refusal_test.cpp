// What a device cannot do is said before it is tried; what it does not finish in time ends with an error.
#include <limits>

#include "tests/vkref/driver_fixture.hpp"

namespace rasterdiff::vkref::testing {
namespace {

class DriverRefusal : public DriverTest {};
RASTERDIFF_ON_ALL_DRIVERS(DriverRefusal);

TEST_P(DriverRefusal, SampleCountsThatAreNotOfferedAreRefused) {
  for (uint32_t samples : {2U, 8U, 16U}) {
    if (device().limits().framebufferSampleCounts & samples) continue;
    const Result<Frame> frame = render(sceneOf(wholeTarget(), 8, 8, samples), device());
    ASSERT_FALSE(frame.has_value());
    EXPECT_EQ(frame.error().code, ErrorCode::NotOffered);
    EXPECT_EQ(frame.error().where, "target.samples");
  }
  EXPECT_EQ(draw(sceneOf(wholeTarget())).primitive.at(0, 0, 0), 1U);  // and the device goes on working
}

TEST_P(DriverRefusal, FramesBeyondMemoryAreRefusedBeforeTheyAreAllocated) {
  Scene scene = sceneOf(wholeTarget(), 8, 8, 4);
  scene.target.width = scene.target.height = 4096;
  scene.draws.front().varyings = {constantVarying("a", 3, {1, 2, 3})};  // 1.5 GiB of attachments
  const Result<Frame> frame = render(scene, device());
  ASSERT_FALSE(frame.has_value());
  EXPECT_EQ(frame.error().code, ErrorCode::NotOffered) << frame.error().where << frame.error().what;
  EXPECT_EQ(frame.error().where, "target");
}

TEST_P(DriverRefusal, CustomSampleLocationsNeedTheirExtension) {
  Scene scene = sceneOf(wholeTarget(), 8, 8, 4);
  scene.target.sampleLocations = SampleLocationsInfo{1, 1, {{0, 0}, {0.5F, 0}, {0, 0.5F}, {0.5F, 0.5F}}};
  const Result<Frame> frame = render(scene, device());
  if (device().limits().sampleLocationSampleCounts & 4) {
    ASSERT_TRUE(frame.has_value());
    EXPECT_EQ(frame->primitive.at(7, 7, 3), 1U);
  } else {
    ASSERT_FALSE(frame.has_value());
    EXPECT_EQ(frame.error().code, ErrorCode::NotOffered);
    EXPECT_EQ(frame.error().where, "target.sampleLocations");
    EXPECT_EQ(frame.error().what, "needs VK_EXT_sample_locations");
  }
}

TEST_P(DriverRefusal, TargetsWiderThanTheDeviceAreRefused) {
  Scene scene = sceneOf(wholeTarget());
  scene.target.width = kMaxTargetExtent;
  const Result<Frame> frame = render(scene, device());
  if (device().limits().maxFramebufferWidth >= kMaxTargetExtent) {
    ASSERT_TRUE(frame.has_value());
    EXPECT_EQ(frame->primitive.at(7, 7, 0), 1U);
  } else {
    ASSERT_FALSE(frame.has_value());
    EXPECT_EQ(frame.error().code, ErrorCode::NotOffered);
  }
}

TEST_P(DriverRefusal, InvalidScenesNeverReachTheDriver) {
  Scene scene = sceneOf(wholeTarget());
  scene.draws.front().indices = {{0, 1, 3}};
  const Result<Frame> frame = render(scene, device());
  ASSERT_FALSE(frame.has_value());
  EXPECT_EQ(frame.error().code, ErrorCode::BadInput);
}

TEST_P(DriverRefusal, NonFinitePositionsThatASceneAllowsDoNotEndTheDevice) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity(), kNan = std::numeric_limits<float>::quiet_NaN();
  for (uint32_t samples : {1U, 4U}) {
    for (float bad : {kNan, kInfinity, -kInfinity, std::numeric_limits<float>::max()}) {
      Scene scene = sceneOf({{bad, 0}, {8, bad}, {0, 8, bad}, {0, 0}, {8, 0, 0, bad}, {0, 8}}, 8, 8, samples);
      scene.allowNonFinite = true;
      const Result<Frame> frame = render(scene, device());
      ASSERT_TRUE(frame.has_value()) << frame.error().what;
    }
  }
  EXPECT_EQ(draw(sceneOf(wholeTarget())).primitive.at(0, 0, 0), 1U);
}

TEST_P(DriverRefusal, ASubmitThatTakesTooLongTimesOutAndEndsTheDevice) {
  Result<std::unique_ptr<Device>> hasty = openDevice({GetParam(), false, /*timeoutSeconds=*/1e-9});
  ASSERT_TRUE(hasty.has_value());
  std::vector<Point> points;
  for (int i = 0; i < 100; ++i) {
    for (const Point& p : wholeTarget(1024, 1024)) points.push_back(p);
  }
  const Scene scene = sceneOf(points, 1024, 1024);
  for (int attempt = 0; attempt < 2; ++attempt) {
    const Result<Frame> frame = render(scene, **hasty);
    ASSERT_FALSE(frame.has_value());
    EXPECT_EQ(frame.error().code, ErrorCode::TimedOut);
  }
  hasty->reset();  // waits for the work that still runs
  EXPECT_EQ(draw(sceneOf(wholeTarget())).primitive.at(0, 0, 0), 1U);  // another device is not affected
}

}  // namespace
}  // namespace rasterdiff::vkref::testing
