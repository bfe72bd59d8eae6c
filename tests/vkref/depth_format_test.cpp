// Every depth format that a device offers: what is stored comes back as the nearest float of the stored integer.
#include <cmath>

#include "tests/vkref/driver_fixture.hpp"
#include "vkref/depth_values.hpp"

namespace rasterdiff::vkref::testing {
namespace {

class DriverDepthFormat : public DriverTest {};
RASTERDIFF_ON_ALL_DRIVERS(DriverDepthFormat);

bool offered(const Capabilities& caps, size_t format, uint32_t samples) {
  return (caps.depthSampleCounts[format] & samples) != 0;
}

/// A strip of `depths.size()` pixels, each with its own constant depth.
Scene depthSteps(const std::vector<float>& depths, DepthFormat format, uint32_t samples) {
  std::vector<Point> points;
  for (size_t i = 0; i < depths.size(); ++i) {
    const float x = static_cast<float>(i), z = depths[i];
    points.insert(points.end(), {{x, 0, z}, {x + 1, 0, z}, {x, 1, z}, {x + 1, 0, z}, {x + 1, 1, z}, {x, 1, z}});
  }
  Scene scene = sceneOf(points, static_cast<uint32_t>(depths.size()), 1, samples);
  scene.target.depthFormat = format;
  scene.state.depthTestEnable = scene.state.depthWriteEnable = true;
  scene.state.depthCompareOp = CompareOp::ALWAYS;
  return scene;
}

TEST(UnormDepth, IsTheNearestFloatOfTheQuotient) {
  EXPECT_EQ(unormDepth(0, 16), 0.0F);
  EXPECT_EQ(unormDepth(65535, 16), 1.0F);
  EXPECT_EQ(unormDepth(0xFFFFFF, 24), 1.0F);
  EXPECT_EQ(unormDepth(0xFFFFFE, 24), 1 - 0x1p-24F);
  EXPECT_EQ(unormDepth(1, 24), 0x1.000002p-24F);  // 2^-24 (1 + 2^-24 + 2^-48 + ..) lies just above the middle
  for (uint32_t k = 0; k <= 65535; ++k) {
    ASSERT_EQ(std::lround(static_cast<double>(unormDepth(k, 16)) * 65535), static_cast<long>(k));
  }
}

TEST(UnormDepth, AnIntegerIsFoundAgainBehindEitherFetch) {
  for (const DepthFetch fetch : {DepthFetch::Quotient, DepthFetch::Reciprocal}) {
    std::vector<uint32_t> integers;
    for (uint32_t k = 0; k < 0xFFFFFE; k += 997) integers.push_back(k);
    for (uint32_t k = 0xFFFF00; k < 0xFFFFFE; ++k) integers.push_back(k);
    integers.push_back(0xFFFFFF);
    std::vector<float> depths;
    for (uint32_t k : integers) depths.push_back(fetchedDepth(fetch, k, 24));
    restoreFetchedDepths(VK_FORMAT_X8_D24_UNORM_PACK32, fetch, depths);
    for (size_t i = 0; i < integers.size(); ++i) ASSERT_EQ(depths[i], unormDepth(integers[i], 24)) << integers[i];
  }
}

TEST_P(DriverDepthFormat, FormatsAreOfferedOrRefusedByName) {
  for (size_t f = 0; f < kDepthFormats.size(); ++f) {
    for (uint32_t samples : {1U, 4U}) {
      const std::optional<Frame> frame = drawIf(offered(caps(), f, samples),
                                                depthSteps({0.25F, 0.5F}, kDepthFormats[f], samples),
                                                "target.depthFormat");
      if (!frame) continue;
      EXPECT_GE(frame->primitive.at(1, 0, 0), 3U);  // one of the two triangles of pixel 1
      ASSERT_TRUE(frame->depth.has_value());
    }
  }
}

TEST_P(DriverDepthFormat, StoredDepthsAreTheNearestStepsAndSamplesAgreeWithOne) {
  std::vector<float> depths = {0, 1, 0.5F, 0.25F, 1 - 0x1p-24F, 1 - 0x1p-23F, 0x1p-24F, 0x1p-16F};
  for (int i = 0; depths.size() < 1024; ++i) depths.push_back(static_cast<float>(std::fmod(i * 0.618033988749895, 1)));
  for (size_t f = 0; f < kDepthFormats.size(); ++f) {
    if (!offered(caps(), f, 1)) continue;
    const Frame one = draw(depthSteps(depths, kDepthFormats[f], 1));
    const uint32_t bits = unormDepthBits(static_cast<VkFormat>(kDepthFormats[f]));
    for (uint32_t x = 0; x < depths.size(); ++x) {
      const float stored = one.depth->at(x, 0, 0);
      if (bits == 0) {
        ASSERT_EQ(stored, depths[x]);
      } else {
        // [vk:fundamentals-fixedconv] half a step, and another for the float arithmetic before
        const double largest = (1U << bits) - 1;
        ASSERT_LE(std::abs(static_cast<double>(stored) - static_cast<double>(depths[x])) * largest, 1.5) << x;
      }
    }
    if (!offered(caps(), f, 4)) continue;
    const Frame four = draw(depthSteps(depths, kDepthFormats[f], 4));
    for (uint32_t x = 0; x < depths.size(); ++x) {
      // A fetch that multiplies by the reciprocal gives 1 for the two largest of 24 bits (depth_values.hpp).
      const float stored = one.depth->at(x, 0, 0);
      const float expected = bits == 24 && stored == 1 - 0x1p-24F && four.depth->at(x, 0, 0) == 1 ? 1 : stored;
      for (uint32_t s = 0; s < 4; ++s) ASSERT_EQ(four.depth->at(x, 0, s), expected) << depths[x];
    }
  }
}

TEST_P(DriverDepthFormat, TheTestWorksInEveryFormat) {
  for (size_t f = 0; f < kDepthFormats.size(); ++f) {
    for (uint32_t samples : {1U, 4U}) {
      if (!offered(caps(), f, samples)) continue;
      std::vector<Point> points = wholeTarget(8, 8, 0.5F);
      for (const Point& p : wholeTarget(8, 8, 0.75F)) points.push_back(p);  // behind
      for (const Point& p : wholeTarget(8, 8, 0.25F)) points.push_back(p);  // in front
      Scene scene = sceneOf(points, 8, 8, samples);
      scene.target.depthFormat = kDepthFormats[f];
      scene.state.depthTestEnable = scene.state.depthWriteEnable = true;
      const Frame frame = draw(scene);
      EXPECT_EQ(frame.primitive.at(3, 3, 0), 3U);
      EXPECT_EQ(frame.count.at(3, 3, samples - 1), 2U);
    }
  }
}

}  // namespace
}  // namespace rasterdiff::vkref::testing
