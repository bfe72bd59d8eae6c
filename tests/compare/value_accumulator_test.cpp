// Statistics of one plane: what counts as same, allowed and differing, and which numbers are kept.
#include "harness/compare/value_accumulator.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace rasterdiff::harness {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

ValueStats statsOf(float expected, float actual, Bounds legal) {
  ValueAccumulator accumulator("v");
  accumulator.add({1, 2, 3, 0}, expected, actual, legal);
  return accumulator.take();
}

void expectKinds(const ValueStats& stats, uint64_t same, uint64_t allowed, uint64_t differing) {
  EXPECT_EQ(stats.same, same);
  EXPECT_EQ(stats.allowed, allowed);
  EXPECT_EQ(stats.differing, differing);
  EXPECT_EQ(stats.compared, same + allowed + differing);
}

TEST(ValueAccumulator, EqualBitsAreSame) {
  expectKinds(statsOf(1.5F, 1.5F, {1.5F, 1.5F}), 1, 0, 0);
  expectKinds(statsOf(kNaN, kNaN, {-kInfinity, kInfinity}), 1, 0, 0);
  expectKinds(statsOf(kInfinity, kInfinity, {0, 1}), 1, 0, 0);
}

TEST(ValueAccumulator, SignOfZeroDoesNotMatter) {
  expectKinds(statsOf(0.0F, -0.0F, {0, 0}), 1, 0, 0);
  expectKinds(statsOf(-0.0F, 0.0F, {0.5F, 1}), 1, 0, 0);
}

TEST(ValueAccumulator, ClosedIntervalIsAllowedAndOneUlpBeyondDiffers) {
  expectKinds(statsOf(1, 2, {0.5F, 2}), 0, 1, 0);
  expectKinds(statsOf(1, 0.5F, {0.5F, 2}), 0, 1, 0);
  expectKinds(statsOf(1, std::nextafter(2.0F, 3.0F), {0.5F, 2}), 0, 0, 1);
  expectKinds(statsOf(1, std::nextafter(0.5F, 0.0F), {0.5F, 2}), 0, 0, 1);
}

TEST(ValueAccumulator, NotANumberIsInNoInterval) {
  expectKinds(statsOf(1, kNaN, {-kInfinity, kInfinity}), 0, 0, 1);
  expectKinds(statsOf(1, kNaN, {0, 2}), 0, 0, 1);
}

TEST(ValueAccumulator, InfinityIsAllowedInAnUnboundedIntervalOnly) {
  expectKinds(statsOf(1, kInfinity, {-kInfinity, kInfinity}), 0, 1, 0);
  expectKinds(statsOf(1, kInfinity, {0, 2}), 0, 0, 1);
}

TEST(ValueAccumulator, RatioIsTheErrorOverTheReachOnItsSide) {
  EXPECT_DOUBLE_EQ(statsOf(1, 1.5F, {0, 2}).maxRatio, 0.5);
  EXPECT_DOUBLE_EQ(statsOf(1, 0.25F, {0.5F, 9}).maxRatio, 1.5);
  EXPECT_DOUBLE_EQ(statsOf(1, 4, {0, 2}).maxRatio, 3);
  EXPECT_DOUBLE_EQ(statsOf(1, 1, {0, 2}).maxRatio, 0);
}

TEST(ValueAccumulator, KeepsTheWorstAndTheFirstThatDiffers) {
  ValueAccumulator accumulator("v");
  const Bounds legal{0, 2};
  accumulator.add({0, 0, 0, 0}, 1, 1.25F, legal);
  accumulator.add({1, 0, 0, 1}, 1, 3, legal);
  accumulator.add({2, 0, 0, 2}, 1, 100, legal);
  accumulator.add({3, 0, 0, 3}, 1, 4, legal);
  const ValueStats stats = accumulator.take();
  expectKinds(stats, 0, 1, 3);
  ASSERT_TRUE(stats.firstDiffering);
  EXPECT_EQ(stats.firstDiffering->x, 1U);
  EXPECT_EQ(stats.firstDiffering->actual, 3);
  ASSERT_TRUE(stats.worst);
  EXPECT_EQ(stats.worst->x, 2U);
  EXPECT_EQ(stats.worst->component, 2U);
  EXPECT_EQ(stats.worst->actual, 100);
  EXPECT_EQ(stats.maxAbs, 99);
  EXPECT_EQ(stats.name, "v");
}

TEST(ValueAccumulator, MeanIsOverAllComparedValues) {
  ValueAccumulator accumulator("v");
  accumulator.add({}, 1, 1, {0, 2});
  accumulator.add({}, 1, 1, {0, 2});
  accumulator.add({}, 1, std::nextafter(1.0F, 2.0F), {0, 2});
  accumulator.add({}, 2, std::nextafter(2.0F, 1.0F), {0, 3});
  const ValueStats stats = accumulator.take();
  EXPECT_DOUBLE_EQ(stats.meanUlp, 0.5);
  EXPECT_EQ(stats.maxUlp, 1);
}

TEST(ValueAccumulator, UndrawnSamplesMustHoldTheClearValueBitByBit) {
  ValueAccumulator accumulator("v");
  accumulator.addUndrawn({}, 0.5F, 0.5F, {0.5F, 0.5F});
  accumulator.addUndrawn({4, 5, 0, 0}, 0.5F, std::nextafter(0.5F, 1.0F), {0.5F, 0.5F});
  const ValueStats stats = accumulator.take();
  EXPECT_EQ(stats.differing, 1U);
  ASSERT_TRUE(stats.firstDiffering);
  EXPECT_EQ(stats.firstDiffering->x, 4U);
}

}  // namespace
}  // namespace rasterdiff::harness
