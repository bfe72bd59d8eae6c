// What a depth becomes in each format: nearest step, both neighbours legal, and comparisons on what is stored.
#include <array>
#include <cmath>

#include "fragment_support.hpp"
#include "rasterizer/depth/format.hpp"

namespace rasterdiff::rasterizer {
namespace {

constexpr std::array kFormats{DepthFormat::D16_UNORM, DepthFormat::X8_D24_UNORM_PACK32, DepthFormat::D32_SFLOAT,
                              DepthFormat::D24_UNORM_S8_UINT, DepthFormat::D32_SFLOAT_S8_UINT};

TEST(DepthFormat, HasTheBitsOfItsName) {
  EXPECT_EQ(unormBits(DepthFormat::D16_UNORM), 16U);
  EXPECT_EQ(unormBits(DepthFormat::X8_D24_UNORM_PACK32), 24U);
  EXPECT_EQ(unormBits(DepthFormat::D24_UNORM_S8_UINT), 24U);
  EXPECT_EQ(unormBits(DepthFormat::D32_SFLOAT), 0U);
  EXPECT_EQ(unormBits(DepthFormat::D32_SFLOAT_S8_UINT), 0U);
}

TEST(DepthFormat, FixedPointRoundsToTheNearestStepAndAllowsItsNeighbours) {
  // 0.3 · 65535 = 19660.5: a tie, to even; either neighbour is legal.
  const Interpolated tie = stored({0.3, 0.3, 0.3}, DepthFormat::D16_UNORM);
  EXPECT_EQ(tie.value, fromUnorm(19660, 16));
  EXPECT_EQ(tie.bounds.lo, fromUnorm(19660, 16));
  EXPECT_EQ(tie.bounds.hi, fromUnorm(19661, 16));
  const double near = 19660.75 / 65535;
  const Interpolated up = stored({near, near, near}, DepthFormat::D16_UNORM);
  EXPECT_EQ(up.value, fromUnorm(19661, 16));
  EXPECT_EQ(up.bounds.lo, fromUnorm(19660, 16));
}

TEST(DepthFormat, FixedPointKeepsItsEndsAndClampsWhatIsBeyond) {
  for (const DepthFormat format : {DepthFormat::D16_UNORM, DepthFormat::X8_D24_UNORM_PACK32}) {
    for (const auto& [z, expected] : {std::pair{0.0, 0.0F}, {1.0, 1.0F}, {-3.0, 0.0F}, {1.5, 1.0F}}) {
      const Interpolated result = stored({z, z, z}, format);
      EXPECT_EQ(result.value, expected);
      EXPECT_EQ(result.bounds.lo, expected);
      EXPECT_EQ(result.bounds.hi, expected);
    }
  }
}

TEST(DepthFormat, FloatFormatsHoldAnyFloat) {
  for (const DepthFormat format : {DepthFormat::D32_SFLOAT, DepthFormat::D32_SFLOAT_S8_UINT}) {
    const double z = 0x1.234566p-9;
    const Interpolated result = stored({z, z, z}, format);
    EXPECT_EQ(result.value, 0x1.234566p-9F);
    EXPECT_EQ(result.bounds.lo, result.bounds.hi);
  }
}

TEST(DepthFormat, ClearValuesAreStoredToo) {
  Scene scene = coveringScene();
  scene.draws[0].positions = {{2, 2, 0, 1}, {3, 2, 0, 1}, {2, 3, 0, 1}};  // nothing on the screen
  scene.target.depthClearValue = 0.5F;
  useDepth(scene, DepthFormat::D16_UNORM);
  const Frame frame = drawn(scene);
  for (const float depth : frame.depth->data) EXPECT_EQ(depth, fromUnorm(32768, 16));  // 32767.5, to even
  for (const Bounds& bounds : frame.depthBounds->data) {
    EXPECT_EQ(bounds.lo, fromUnorm(32767, 16));
    EXPECT_EQ(bounds.hi, fromUnorm(32768, 16));
  }
}

TEST(DepthFormat, EveryStoredDepthIsAStepOfItsFormat) {
  for (const DepthFormat format : kFormats) {
    Scene scene = coveringScene(8, 4, 0.1, 0.9, 0.3);
    useDepth(scene, format);
    const Frame frame = drawn(scene);
    const Frame exact = drawn([&] {
      Scene unrounded = scene;
      unrounded.target.depthFormat = DepthFormat::D32_SFLOAT;
      return unrounded;
    }());
    for (size_t i = 0; i < frame.depth->data.size(); ++i) {
      const float depth = frame.depth->data[i];
      EXPECT_TRUE(contains(frame.depthBounds->data[i], depth));
      const uint32_t bits = unormBits(format);
      if (bits == 0) {
        EXPECT_EQ(depth, exact.depth->data[i]);
      } else {
        const double k = std::nearbyint(double{depth} * (std::ldexp(1.0, static_cast<int>(bits)) - 1));
        EXPECT_EQ(depth, fromUnorm(k, bits));
        // Half a step, and the rounding of the two float32 numbers.
        EXPECT_LE(std::fabs(double{depth} - exact.depth->data[i]), 0.5 * std::ldexp(1.0, -static_cast<int>(bits)) + 0x1p-23);
      }
    }
  }
}

// Two depths that are different floats but the same step: EQUAL passes on what is stored.
TEST(DepthFormat, ComparisonsSeeStoredDepths) {
  const float first = 0.25F, second = std::nextafter(first, 1.0F);
  for (const auto& [format, passes] : {std::pair{DepthFormat::D16_UNORM, true}, {DepthFormat::D32_SFLOAT, false}}) {
    Scene scene = coveringScene(8, 1, double{first}, double{first}, double{first});
    useDepth(scene, format);
    scene.target.depthClearValue = second;
    scene.state.depthCompareOp = CompareOp::EQUAL;
    const Frame frame = drawn(scene);
    EXPECT_EQ(frame.primitive.at(1, 1, 0), passes ? 1U : 0U);
  }
}

}  // namespace
}  // namespace rasterdiff::rasterizer
