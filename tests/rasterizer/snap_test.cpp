#include "rasterizer/snap.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/support/int128.hpp"

namespace rasterdiff::rasterizer {
namespace {

using testing::Int128;

// A viewport 512 pixels wide at 0: pixel = 256 ndc + 256, exact in float32 for the numbers used here.
const ViewportAxis kAxis{256, 0, 256};

float ndcOf(double pixels) { return static_cast<float>((pixels - 256) / 256); }

TEST(Snap, ExactHalvesGoToTheEvenNeighbour) {
  EXPECT_EQ(snapExactly(ndcOf(1 + 0.5 / 256), 1, kAxis, 8, SnapRounding::NearestEven), 256);
  EXPECT_EQ(snapExactly(ndcOf(1 + 1.5 / 256), 1, kAxis, 8, SnapRounding::NearestEven), 258);
  EXPECT_EQ(snapExactly(ndcOf(1 + 1.5 / 256), 1, kAxis, 8, SnapRounding::NearestUp), 258);
  EXPECT_EQ(snapExactly(ndcOf(1 + 0.5 / 256), 1, kAxis, 8, SnapRounding::NearestUp), 257);
}

TEST(Snap, FloorAndTruncationDifferBelowZero) {
  const float x = ndcOf(-1 - 0.25 / 256);
  EXPECT_EQ(snapExactly(x, 1, kAxis, 8, SnapRounding::Floor), -257);
  EXPECT_EQ(snapExactly(x, 1, kAxis, 8, SnapRounding::TowardZero), -256);
}

TEST(Snap, CoarserGridsAreSubsetsOfTheFineOne) {
  EXPECT_EQ(snapExactly(ndcOf(3 + 5.0 / 256), 1, kAxis, 4, SnapRounding::NearestEven), 3 * 256);
  EXPECT_EQ(snapExactly(ndcOf(3 + 9.0 / 256), 1, kAxis, 4, SnapRounding::NearestEven), 3 * 256 + 16);
}

TEST(Snap, DividesExactlyWhereDoublesCannotDecide) {
  // x / w is a hair off a half: x = 3 · (h ± 2^-52 relative) cannot be told from the half in double division.
  std::mt19937_64 random(7);
  int halves = 0;
  for (int i = 0; i < 20000; ++i) {
    const float w = static_cast<float>(random() % 4093 + 1);
    const double target = (static_cast<double>(random() % 1024) + 0.5) / 256;  // a half in grid units
    const auto x = static_cast<float>((target / 256 - 1) * static_cast<double>(w));
    const int32_t snapped = snapExactly(x, w, kAxis, 8, SnapRounding::NearestEven);
    // Independent check in 128-bit integers: v = 65536 x / w + 65536 (grid units), with x scaled by 2^40.
    const auto scaledX = static_cast<Int128>(std::ldexp(static_cast<long double>(x), 60));
    const auto w60 = static_cast<Int128>(std::ldexp(static_cast<long double>(w), 60));
    const Int128 twiceError = 2 * (65536 * scaledX + (65536 - static_cast<Int128>(snapped)) * w60);
    EXPECT_LE(twiceError, w60);
    EXPECT_GE(twiceError, -w60);
    if (twiceError == w60 || twiceError == -w60) {
      ++halves;
      EXPECT_EQ(snapped % 2, 0);
    }
  }
  EXPECT_GT(halves, 5);
}

TEST(LegalSnaps, PointOnTheGridStaysAndAnyOtherHasTwoNeighbours) {
  const SnapRange on = legalSnaps(ndcOf(5 + 7.0 / 256), 1, kAxis, 8, 0);
  EXPECT_EQ(on.lowest, 5 * 256 + 7);
  EXPECT_EQ(on.highest, 5 * 256 + 7);
  const SnapRange off = legalSnaps(ndcOf(5 + 7.25 / 256), 1, kAxis, 8, 0);
  EXPECT_EQ(off.lowest, 5 * 256 + 7);
  EXPECT_EQ(off.highest, 5 * 256 + 8);
  const SnapRange coarse = legalSnaps(ndcOf(5 + 7.0 / 256), 1, kAxis, 4, 0);
  EXPECT_EQ(coarse.lowest, 5 * 256);
  EXPECT_EQ(coarse.highest, 5 * 256 + 16);
}

TEST(LegalSnaps, ContainTheNominalSnapOfEveryProfile) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<float> ndc(-1, 1), weight(0.01F, 50);
  const ViewportAxis axis{960, 0.25, 960};
  const Rules lavapipe = *Rules::profile("lavapipe", Limits{});
  const Rules reference = *Rules::profile("reference", Limits{});
  for (int i = 0; i < 100000; ++i) {
    const float w = weight(random), x = ndc(random) * w;
    const SnapRange legal = legalSnaps(x, w, axis, 8, viewportArithmeticBound(x, w, axis));
    for (const uint32_t samples : {1U, 4U}) {
      for (const Rules* rules : {&lavapipe, &reference}) {
        const int32_t snapped = snapUnder(*rules, samples, x, w, axis);
        EXPECT_GE(snapped, legal.lowest);
        EXPECT_LE(snapped, legal.highest);
      }
    }
  }
}

TEST(ViewportArithmetic, BoundIsZeroWhereFloatsAreExact) {
  EXPECT_EQ(viewportArithmeticBound(0.5F, 1, kAxis), 0);
  EXPECT_EQ(viewportArithmeticBound(0.25F, 0.5F, kAxis), 0);
  EXPECT_GT(viewportArithmeticBound(0.5F, 3, kAxis), 0);
  EXPECT_GT(viewportArithmeticBound(0.1F, 1, ViewportAxis{960, 0, 960}), 0);
}

TEST(ViewportArithmetic, BoundHoldsForBothFloatOrders) {
  std::mt19937_64 random(13);
  std::uniform_real_distribution<float> ndc(-1, 1), weight(0.01F, 50), size(1, 4000), origin(-500, 500);
  for (int i = 0; i < 200000; ++i) {
    const double width = static_cast<double>(size(random));
    const ViewportAxis axis{width / 2, static_cast<double>(origin(random)), width / 2};
    const float w = weight(random), x = ndc(random) * w;
    const long double exact = static_cast<long double>(x) / w * axis.scale + axis.origin + axis.centre;
    for (const ViewportArithmetic arithmetic : {ViewportArithmetic::Float32, ViewportArithmetic::Float32Fma}) {
      const float computed = toFramebufferFloat(x, w, axis, arithmetic);
      EXPECT_LE(std::fabs(static_cast<double>(computed - exact)), viewportArithmeticBound(x, w, axis));
    }
  }
}

}  // namespace
}  // namespace rasterdiff::rasterizer
