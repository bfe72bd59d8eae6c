// Depth clamping comes after the bias, to the range of the primitive's viewport in either order; without it, depths
// outside of that range are undefined.
#include "fragment_support.hpp"
#include "rasterizer/depth/format.hpp"

namespace rasterdiff::rasterizer {
namespace {

// z from -0.5 at the left edge to 1.5 at the right one.
Scene unclippedScene(DepthFormat format, bool clamp) {
  Scene scene = coveringScene(8, 1, -0.5, 3.5, -0.5);
  useDepth(scene, format);
  scene.state.depthClampEnable = clamp;
  scene.state.depthClipEnable = false;
  return scene;
}

TEST(DepthClamp, HoldsDepthInTheViewportsRangeInEitherOrder) {
  for (const bool reversed : {false, true}) {
    Scene scene = unclippedScene(DepthFormat::D32_SFLOAT, true);
    scene.viewport.minDepth = reversed ? 0.75F : 0.25F;
    scene.viewport.maxDepth = reversed ? 0.25F : 0.75F;
    const Frame frame = drawn(scene);
    EXPECT_EQ(frame.depth->at(0, 0, 0), scene.viewport.minDepth);
    EXPECT_EQ(frame.depth->at(7, 0, 0), scene.viewport.maxDepth);
    for (const Bounds& bounds : frame.depthBounds->data) {
      EXPECT_GE(bounds.lo, 0.25F);
      EXPECT_LE(bounds.hi, 0.75F);
    }
  }
}

TEST(DepthClamp, OfAnEmptyRangeIsThatDepth) {
  Scene scene = unclippedScene(DepthFormat::D16_UNORM, true);
  scene.viewport.minDepth = scene.viewport.maxDepth = 0.5F;
  const Frame frame = drawn(scene);
  for (const float depth : frame.depth->data) EXPECT_EQ(depth, fromUnorm(32768, 16));
}

TEST(DepthClamp, ComesAfterTheBias) {
  Scene scene = unclippedScene(DepthFormat::D32_SFLOAT, true);
  scene.state.depthBiasEnable = true;
  scene.state.depthBiasSlopeFactor = 1;  // m = 1/4
  const Frame frame = drawn(scene);
  EXPECT_EQ(frame.depth->at(7, 0, 0), 1.0F);
  EXPECT_EQ(frame.depth->at(2, 0, 0), -0.5F + 2.5F / 4 + 0.25F);
}

TEST(DepthClamp, WithoutItDepthsOutsideOfTheRangeAreUndefined) {
  for (const DepthFormat format : {DepthFormat::D32_SFLOAT, DepthFormat::D16_UNORM}) {
    const Frame frame = drawn(unclippedScene(format, false), specificationRules());
    for (const uint32_t x : {0U, 1U, 6U, 7U}) {
      EXPECT_TRUE(contains(frame.depthBounds->at(x, 0, 0), 0.0F));
      EXPECT_TRUE(contains(frame.depthBounds->at(x, 0, 0), 1.0F));
    }
    // Pixel 3: z = 0.375 is defined.
    EXPECT_NEAR(frame.depth->at(3, 0, 0), 0.375F, 0x1p-16F);  // a step of D16
    EXPECT_LT(frame.depthBounds->at(3, 0, 0).hi, 0.4F);
    EXPECT_GT(frame.depthBounds->at(3, 0, 0).lo, 0.35F);
  }
}

TEST(DepthClamp, ClippedDepthsOnThePlanesKeepTheirBounds) {
  Scene scene = coveringScene(8, 1, 0, 2, 0);  // the far plane cuts at half the target
  useDepth(scene, DepthFormat::D32_SFLOAT);
  for (const Rules& rules : {testing::referenceRules(), specificationRules()}) {
    const Frame frame = drawn(scene, rules);
    int bounded = 0;
    for (const Bounds& bounds : frame.depthBounds->data) bounded += bounds.hi - bounds.lo < 0.5F ? 1 : 0;
    EXPECT_EQ(bounded, 64);
  }
}

TEST(DepthClamp, IsCounted) {
  RuleCounts counts;
  drawn(unclippedScene(DepthFormat::D16_UNORM, true), testing::referenceRules(), &counts);
  EXPECT_GT(counts[Rule::DepthClamp], 0U);
  EXPECT_GT(counts[Rule::DepthConversion], 0U);
}

}  // namespace
}  // namespace rasterdiff::rasterizer
