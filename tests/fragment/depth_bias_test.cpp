// Depth bias: its two terms, its clamp, what is legal for the slope and for the unit, and to which primitives it applies.
#include <cmath>

#include "fragment_support.hpp"
#include "rasterizer/depth/bias.hpp"
#include "rasterizer/depth/format.hpp"

namespace rasterdiff::rasterizer {
namespace {

Scene biasedScene(DepthFormat format, float constantFactor, float slopeFactor, float clamp = 0) {
  // ∂z/∂x = 3/128, ∂z/∂y = 4/128 a pixel: the length of the gradient is 5/128.
  Scene scene = coveringScene(8, 1, 0.125, 0.125 + 16 * 3 / 128.0, 0.125 + 16 * 4 / 128.0);
  useDepth(scene, format);
  scene.state.depthBiasEnable = true;
  scene.state.depthBiasConstantFactor = constantFactor;
  scene.state.depthBiasSlopeFactor = slopeFactor;
  scene.state.depthBiasClamp = clamp;
  return scene;
}

// Depth of the plane above at the centre of pixel (0, 0).
constexpr double kUnbiased = 0.125 + 3.5 / 128;

float depthUnder(const Scene& scene, const Rules& rules = testing::referenceRules()) { return drawn(scene, rules).depth->at(0, 0, 0); }
Bounds boundsUnder(const Scene& scene, const Rules& rules) { return drawn(scene, rules).depthBounds->at(0, 0, 0); }

TEST(DepthBias, SlopeTakesTheLargerComponentOfTheGradient) {
  EXPECT_EQ(depthUnder(biasedScene(DepthFormat::D32_SFLOAT, 0, 2)), static_cast<float>(kUnbiased + 2 * 4 / 128.0));
  EXPECT_EQ(depthUnder(biasedScene(DepthFormat::D32_SFLOAT, 0, -2)), static_cast<float>(kUnbiased - 2 * 4 / 128.0));
}

TEST(DepthBias, SlopeMayBeTheLengthOfTheGradientUnderOpenRulesOnly) {
  const Scene scene = biasedScene(DepthFormat::D32_SFLOAT, 0, 2);
  const auto byLength = static_cast<float>(kUnbiased + 2 * 5 / 128.0);
  EXPECT_TRUE(contains(boundsUnder(scene, specificationRules()), byLength));
  EXPECT_FALSE(contains(boundsUnder(scene, testing::referenceRules()), byLength));
  // Neither less than the larger component nor more than the length.
  EXPECT_FALSE(contains(boundsUnder(scene, specificationRules()), static_cast<float>(kUnbiased + 2 * 3.9 / 128.0)));
  EXPECT_FALSE(contains(boundsUnder(scene, specificationRules()), static_cast<float>(kUnbiased + 2 * 5.1 / 128.0)));
}

// [vk:primsrast-depthbias-computation] the unit of a float format follows the exponent of the greatest depth.
TEST(DepthBias, UnitOfFloatFormatsFollowsTheBinadeOfTheGreatestDepth) {
  for (int exponent = -10; exponent <= -1; ++exponent) {
    const double z = std::ldexp(1.5, exponent);
    Scene scene = coveringScene(8, 1, z, z, z);
    useDepth(scene);
    scene.state.depthBiasEnable = true;
    scene.state.depthBiasConstantFactor = 3;
    const float expected = static_cast<float>(z + 3 * std::ldexp(1.0, exponent - 23));
    EXPECT_EQ(depthUnder(scene), expected) << "exponent " << exponent;
    for (const Rules& rules : {testing::referenceRules(), specificationRules()}) {
      const Bounds bounds = boundsUnder(scene, rules);
      EXPECT_TRUE(contains(bounds, expected));
      // Evaluation leaves a few of the roundings that the unit is one of, and no more: sums of weighted vertices, five for each of four
      // terms, 20 · 2^-24 · z to either side, which is 30 units, and more outside of the triangle.
      EXPECT_LT(bounds.hi - bounds.lo, std::ldexp(48.0F, exponent - 23));
    }
  }
}

TEST(DepthBias, UnitOfAFloatDepthOfExactlyAPowerOfTwoMayBeThatOfEitherBinade) {
  const Interval unit = smallestDifference(0, {0.5, std::nextafter(0.5F, 0.0F), 0.5}, specificationRules());
  EXPECT_EQ(unit.lo, 0x1p-25);
  EXPECT_EQ(unit.hi, 0x1p-24);
  EXPECT_EQ(unit.value, 0x1p-24);
  const Interval none = smallestDifference(0, {0, 0, 0}, specificationRules());
  EXPECT_EQ(none.hi, 0);
}

TEST(DepthBias, UnitOfFixedPointIsOneStepAndMayBeTwo) {
  const Rules reference = testing::referenceRules(), open = specificationRules();
  Rules twoSteps = reference;
  twoSteps.choices.depthBiasUnit = DepthBiasUnit::TwoSteps;
  for (const uint32_t bits : {16U, 24U}) {
    const double step = std::ldexp(1.0, -static_cast<int>(bits));
    EXPECT_EQ(smallestDifference(bits, {}, reference).value, step);
    EXPECT_EQ(smallestDifference(bits, {}, reference).hi, step);
    EXPECT_EQ(smallestDifference(bits, {}, open).lo, step);
    EXPECT_EQ(smallestDifference(bits, {}, open).hi, 2 * step);
    EXPECT_EQ(smallestDifference(bits, {}, twoSteps).value, 2 / (1 / step - 1));
  }
}

TEST(DepthBias, IsClampedFromAboveByAPositiveAndFromBelowByANegativeClamp) {
  const Rules rules = testing::referenceRules();
  const auto bias = [&](float factor, float clamp) {
    return depthBias(biasedScene(DepthFormat::D32_SFLOAT, 0, factor, clamp).state, 0, rules, {{0.25, 0, 0}, {}}).value;
  };
  EXPECT_EQ(bias(1, 0), 0.25);
  EXPECT_EQ(bias(1, 0.125F), 0.125);
  EXPECT_EQ(bias(-1, 0.125F), -0.25);
  EXPECT_EQ(bias(-1, -0.125F), -0.125);
  EXPECT_EQ(bias(1, -0.125F), 0.25);
  EXPECT_EQ(bias(1, std::numeric_limits<float>::quiet_NaN()), 0.25);
}

// Two draws, one just below and one just above, tell one unit: LESS passes only where the bias lowered the depth.
TEST(DepthBias, OfOneUnitDecidesComparisons) {
  for (const float factor : {-1.0F, 0.0F, 1.0F}) {
    Scene scene = coveringScene(8, 1, 0.75, 0.75, 0.75);
    useDepth(scene);
    scene.target.depthClearValue = 0.75F;
    scene.state.depthCompareOp = CompareOp::LESS;
    scene.state.depthBiasEnable = true;
    scene.state.depthBiasConstantFactor = factor;
    EXPECT_EQ(drawn(scene).primitive.at(3, 3, 0), factor < 0 ? 1U : 0U) << factor;
  }
}

TEST(DepthBias, AppliesToTrianglesInEveryPolygonMode) {
  for (const PolygonMode mode : {PolygonMode::FILL, PolygonMode::LINE, PolygonMode::POINT}) {
    Scene scene = testing::sceneOf({{1.5, 1.5, 0.25}, {6.5, 1.5, 0.25 + 5 / 64.0}, {1.5, 6.5, 0.25}}, 8);
    useDepth(scene);
    scene.state.polygonMode = mode;
    scene.state.depthBiasEnable = true;
    scene.state.depthBiasSlopeFactor = 4;
    for (const Rules& rules : {testing::referenceRules(), specificationRules()}) {
      const Frame frame = drawn(scene, rules);
      ASSERT_EQ(frame.primitive.at(1, 1, 0), 1U);
      EXPECT_EQ(frame.depth->at(1, 1, 0), 0.25F + 4 / 64.0F);
      EXPECT_FALSE(contains(frame.depthBounds->at(1, 1, 0), 0.25F));
    }
  }
}

TEST(DepthBias, MayOrMayNotApplyToLinesAndPoints) {
  for (const auto topology : {PrimitiveTopology::POINT_LIST, PrimitiveTopology::LINE_LIST}) {
    Scene scene = testing::sceneOf({{1.5, 1.5, 0.25}, {6.5, 1.5, 0.25}}, 8);
    useDepth(scene);
    scene.state.topology = topology;
    scene.state.depthBiasEnable = true;
    scene.state.depthBiasConstantFactor = 1024;
    const float biased = 0.25F + 1024 * 0x1p-25F;
    for (const bool open : {false, true}) {
      const Frame frame = drawn(scene, open ? specificationRules() : testing::referenceRules());
      ASSERT_EQ(frame.primitive.at(1, 1, 0), 1U);
      EXPECT_EQ(frame.depth->at(1, 1, 0), 0.25F);
      EXPECT_EQ(contains(frame.depthBounds->at(1, 1, 0), biased), open);
      EXPECT_TRUE(contains(frame.depthBounds->at(1, 1, 0), 0.25F));
    }
  }
}

}  // namespace
}  // namespace rasterdiff::rasterizer
