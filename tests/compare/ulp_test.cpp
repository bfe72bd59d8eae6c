// Distance in units in the last place over the whole line of float32 numbers.
#include "harness/compare/ulp.hpp"

#include <gtest/gtest.h>

namespace rasterdiff::harness {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr float kSmallest = std::numeric_limits<float>::denorm_min();

TEST(Ulp, NeighboursAreOneApart) {
  for (const float value : {1.0F, -1.0F, 1e-40F, 3.4e38F, -0x1p-126F, 16777216.0F}) {
    EXPECT_EQ(ulpDistance(value, std::nextafter(value, kInfinity)), 1);
    EXPECT_EQ(ulpDistance(value, std::nextafter(value, -kInfinity)), 1);
    EXPECT_EQ(ulpDistance(value, value), 0);
  }
}

TEST(Ulp, CountsThroughZeroAndTakesItsSignsForOne) {
  EXPECT_EQ(ulpDistance(0.0F, -0.0F), 0);
  EXPECT_EQ(ulpDistance(kSmallest, -kSmallest), 2);
  EXPECT_EQ(ulpDistance(-0.0F, kSmallest), 1);
}

TEST(Ulp, IsSymmetricAndGrowsWithBinades) {
  EXPECT_EQ(ulpDistance(1, 2), 8388608);
  EXPECT_EQ(ulpDistance(2, 1), 8388608);
  EXPECT_EQ(ulpDistance(1, 4), 2 * 8388608);
  EXPECT_EQ(ulpDistance(-1, 1), 2 * ulpDistance(0, 1));
}

TEST(Ulp, LargestFiniteIsNextToInfinity) {
  EXPECT_EQ(ulpDistance(std::numeric_limits<float>::max(), kInfinity), 1);
  EXPECT_EQ(ulpDistance(kInfinity, kInfinity), 0);
}

TEST(Ulp, NotANumberIsInfinitelyFarFromEveryNumberAndEqualToItself) {
  EXPECT_EQ(ulpDistance(kNaN, kNaN), 0);
  EXPECT_EQ(ulpDistance(kNaN, 1), kInfinity);
  EXPECT_EQ(ulpDistance(kInfinity, kNaN), kInfinity);
}

}  // namespace
}  // namespace rasterdiff::harness
