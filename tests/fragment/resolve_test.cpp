// Resolve: the mean of a pixel's samples, rounded once, with room for any order of float32 sums.
#include <cmath>
#include <random>

#include "fragment_support.hpp"
#include "rasterizer/depth/format.hpp"
#include "rasterizer/depth/resolve_depth.hpp"
#include "rasterizer/fragment/resolve.hpp"

namespace rasterdiff::rasterizer {
namespace {

std::vector<Bounds> exactBounds(const std::vector<float>& values) {
  std::vector<Bounds> bounds;
  for (const float value : values) bounds.push_back({value, value});
  return bounds;
}

TEST(Resolve, IsTheMeanRoundedOnce) {
  const std::vector<float> values{1, 2, 4, 8};
  EXPECT_EQ(meanOf(values, exactBounds(values), 1).value, 3.75F);
  const std::vector<float> one{0.1F};
  EXPECT_EQ(meanOf(one, exactBounds(one), 1).value, 0.1F);
  EXPECT_EQ(meanOf(one, exactBounds(one), 1).bounds.hi, 0.1F);
}

// In float32: summed in any order and divided, or scaled first; all of it is legal.
TEST(Resolve, HoldsEveryOrderOfFloat32Sums) {
  std::mt19937 random(5);
  for (const size_t n : {2U, 4U, 8U, 16U}) {
    for (int round = 0; round < 2000; ++round) {
      std::vector<float> values(n);
      for (float& value : values) value = std::uniform_real_distribution<float>(-1, 1)(random) * std::ldexp(1.0F, static_cast<int>(random() % 8));
      const Bounds bounds = meanOf(values, exactBounds(values), 1).bounds;
      std::shuffle(values.begin(), values.end(), random);
      float sum = 0, scaled = 0;
      for (const float value : values) {
        sum += value;
        scaled += value * (1.0F / static_cast<float>(n));
      }
      EXPECT_TRUE(contains(bounds, sum / static_cast<float>(n)));
      EXPECT_TRUE(contains(bounds, scaled));
      float magnitude = 0;
      for (const float value : values) magnitude += std::fabs(value);
      EXPECT_LE(bounds.hi - bounds.lo, magnitude * 0x1p-21F);  // two dozen roundings at most
    }
  }
}

TEST(Resolve, AddsAPlaneOfOneSampleForEveryVaryingAndNoBuiltIn) {
  Scene scene = testing::sceneOf({{0, 0}, {4.5, 0}, {4.5, 8}, {0, 8}}, 8, 4);
  scene.state.topology = PrimitiveTopology::TRIANGLE_FAN;
  addVarying(scene, "level", Interpolation::flat, 2, {1, -2, 1, -2, 1, -2, 1, -2});
  scene.builtIns = {BuiltIn::SampleId};
  EXPECT_TRUE(drawn(scene).resolved.empty());
  scene.target.resolve = true;
  RuleCounts counts;
  const Frame frame = drawn(scene, testing::referenceRules(), &counts);
  ASSERT_EQ(frame.resolved.size(), 1U);
  EXPECT_EQ(frame.resolved[0].name, "level");
  const Plane<float>& values = frame.resolved[0].values;
  EXPECT_EQ(values.samples, 1U);
  EXPECT_EQ(values.at(1, 1, 0, 0), 1.0F);
  EXPECT_EQ(values.at(4, 1, 0, 0), 0.5F);  // two of four samples
  EXPECT_EQ(values.at(4, 1, 0, 1), -1.0F);
  EXPECT_EQ(values.at(6, 1, 0, 0), 0.0F);
  EXPECT_EQ(counts[Rule::Resolve], 8U);  // the pixels of one column
}

TEST(ResolveDepth, FollowsItsMode) {
  const std::vector<float> depths{0.5F, 0.25F, 0.75F, 0.25F};
  const std::vector<Bounds> bounds = exactBounds(depths);
  const auto value = [&](ResolveMode mode) { return resolvedDepth(depths, bounds, mode, DepthFormat::D32_SFLOAT).value; };
  EXPECT_EQ(value(ResolveMode::SAMPLE_ZERO), 0.5F);
  EXPECT_EQ(value(ResolveMode::MIN), 0.25F);
  EXPECT_EQ(value(ResolveMode::MAX), 0.75F);
  EXPECT_EQ(value(ResolveMode::AVERAGE), 0.4375F);
}

TEST(ResolveDepth, AnAverageInFixedPointMayEndOnEitherNeighbour) {
  const std::vector<float> depths{fromUnorm(1, 16), fromUnorm(2, 16)};
  const Interpolated mean = resolvedDepth(depths, exactBounds(depths), ResolveMode::AVERAGE, DepthFormat::D16_UNORM);
  EXPECT_EQ(mean.bounds.lo, fromUnorm(1, 16));
  EXPECT_EQ(mean.bounds.hi, fromUnorm(2, 16));
}

TEST(ResolveDepth, AddsOnePlaneOfOneSample) {
  Scene scene = testing::sceneOf({{0, 0, 0.25}, {4.5, 0, 0.25}, {4.5, 8, 0.25}, {0, 8, 0.25}}, 8, 4);
  scene.state.topology = PrimitiveTopology::TRIANGLE_FAN;
  scene.target.depthFormat = DepthFormat::D32_SFLOAT;
  scene.state.depthTestEnable = scene.state.depthWriteEnable = true;
  scene.target.depthResolveMode = ResolveMode::MIN;
  const Frame frame = drawn(scene);
  ASSERT_EQ(frame.resolved.size(), 1U);
  EXPECT_EQ(frame.resolved[0].name, "depth");
  EXPECT_EQ(frame.resolved[0].values.at(4, 1, 0), 0.25F);  // two of four samples
  EXPECT_EQ(frame.resolved[0].values.at(6, 1, 0), 1.0F);   // cleared
  scene.target.depthResolveMode = ResolveMode::MAX;
  EXPECT_EQ(drawn(scene).resolved[0].values.at(4, 1, 0), 1.0F);
}

}  // namespace
}  // namespace rasterdiff::rasterizer
