// The eight comparisons, and their versions on intervals against all pairs of small integers.
#include "rasterizer/depth_test.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace rasterdiff::rasterizer {
namespace {

using enum CompareOp;
constexpr CompareOp kAll[] = {NEVER, LESS, EQUAL, LESS_OR_EQUAL, GREATER, NOT_EQUAL, GREATER_OR_EQUAL, ALWAYS};

struct Row {
  CompareOp op;
  bool less, equal, greater;  // passes where the fragment is less than, equal to, greater than what is stored
};

constexpr Row kTable[] = {
    {NEVER, false, false, false},     {LESS, true, false, false},    {EQUAL, false, true, false},
    {LESS_OR_EQUAL, true, true, false}, {GREATER, false, false, true}, {NOT_EQUAL, true, false, true},
    {GREATER_OR_EQUAL, false, true, true}, {ALWAYS, true, true, true}};

TEST(DepthTest, FollowsTheTableOfComparisons) {
  for (const Row& row : kTable) {
    EXPECT_EQ(depthTestPasses(row.op, 0.25F, 0.5F), row.less);
    EXPECT_EQ(depthTestPasses(row.op, 0.5F, 0.5F), row.equal);
    EXPECT_EQ(depthTestPasses(row.op, 0.75F, 0.5F), row.greater);
    EXPECT_EQ(depthTestPasses(row.op, -0.0F, 0.0F), row.equal);
  }
}

TEST(DepthTest, NegationIsTheOppositeForEveryPair) {
  for (const CompareOp op : kAll) {
    EXPECT_EQ(negated(negated(op)), op);
    for (const float a : {0.0F, 0.5F, 1.0F}) {
      for (const float b : {0.0F, 0.5F, 1.0F}) EXPECT_NE(depthTestPasses(op, a, b), depthTestPasses(negated(op), a, b));
    }
  }
}

TEST(DepthTest, IntervalsPassOrFailWhereSomePairOfTheirValuesDoes) {
  constexpr int kMost = 4;
  for (const CompareOp op : kAll) {
    for (int a = 0; a <= kMost; ++a) {
      for (int b = a; b <= kMost; ++b) {
        for (int c = 0; c <= kMost; ++c) {
          for (int d = c; d <= kMost; ++d) {
            bool somePasses = false, someFails = false;
            // Halves too: an interval holds more than its integers.
            for (int f = 2 * a; f <= 2 * b; ++f) {
              for (int s = 2 * c; s <= 2 * d; ++s) {
                (depthTestPasses(op, static_cast<float>(f) / 2, static_cast<float>(s) / 2) ? somePasses : someFails) = true;
              }
            }
            const Bounds fragment{static_cast<float>(a), static_cast<float>(b)};
            const Bounds stored{static_cast<float>(c), static_cast<float>(d)};
            EXPECT_EQ(depthTestMayPass(op, fragment, stored), somePasses) << static_cast<int>(op) << a << b << c << d;
            EXPECT_EQ(depthTestMayFail(op, fragment, stored), someFails) << static_cast<int>(op) << a << b << c << d;
          }
        }
      }
    }
  }
}

TEST(DepthTest, UnboundedIntervalMayPassAndFailEverythingThatIsNotConstant) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  for (const CompareOp op : kAll) {
    EXPECT_EQ(depthTestMayPass(op, {-kInfinity, kInfinity}, {0.5F, 0.5F}), op != NEVER);
    EXPECT_EQ(depthTestMayFail(op, {-kInfinity, kInfinity}, {0.5F, 0.5F}), op != ALWAYS);
  }
}

}  // namespace
}  // namespace rasterdiff::rasterizer
