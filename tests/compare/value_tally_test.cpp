// Values at once against values one by one, on every instruction set.
#include "harness/compare/value_tally.hpp"

#include <bit>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "harness/compare/value_accumulator.hpp"
#include "tests/rasterizer/kernels/every_target.hpp"

namespace rasterdiff::harness {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

struct Values {
  std::vector<float> expected, actual;
  std::vector<Bounds> legal;
  std::vector<uint32_t> drawn;

  void add(float e, float a, Bounds bounds, uint32_t primitive = 1) {
    expected.push_back(e);
    actual.push_back(a);
    legal.push_back(bounds);
    drawn.push_back(primitive);
  }
  void fill(size_t values) {
    while (expected.size() < values) add(1, 1, {1, 1});
  }
  [[nodiscard]] std::optional<ValueTally> tally() const {
    return tallyValues({expected.data(), actual.data(), legal.data(), drawn.data(), expected.size()});
  }
};

/// The statistics of a tally, with the place of the worst found as its user does.
ValueStats statsOf(const Values& v, const ValueTally& tally) {
  ValueAccumulator sum("v");
  uint64_t compared = 0;
  for (const uint32_t drawn : v.drawn) compared += drawn != 0 ? 1U : 0U;
  EXPECT_EQ(sum.addTally(tally, compared), tally.unequal);
  return sum.take();
}

ValueStats oneByOne(const Values& v) {
  ValueAccumulator sum("v");
  for (size_t i = 0; i < v.expected.size(); ++i) {
    if (v.drawn[i] != 0) {
      sum.add({static_cast<uint32_t>(i), 0, 0, 0}, v.expected[i], v.actual[i], v.legal[i]);
    } else {
      sum.addUndrawn({static_cast<uint32_t>(i), 0, 0, 0}, v.expected[i], v.actual[i], v.legal[i]);
    }
  }
  return sum.take();
}

void expectSame(const ValueStats& a, const ValueStats& b) {
  EXPECT_EQ(a.compared, b.compared);
  EXPECT_EQ(a.same, b.same);
  EXPECT_EQ(a.allowed, b.allowed);
  EXPECT_EQ(a.differing, b.differing);
  EXPECT_EQ(a.maxUlp, b.maxUlp);
  EXPECT_EQ(a.meanUlp, b.meanUlp);
  EXPECT_EQ(a.maxAbs, b.maxAbs);
  EXPECT_EQ(a.maxRatio, b.maxRatio);
}

/// A value and another one near it or not, of any magnitude and sign, inside of an interval around both.
void addRandom(Values& v, std::mt19937& random) {
  const auto finite = [&] {
    float value = 0;
    do value = std::bit_cast<float>(static_cast<uint32_t>(random()));
    while (!std::isfinite(value));
    return value;
  };
  const float expected = finite();
  float actual = expected;
  switch (random() % 4) {
    case 0: break;
    case 1: actual = std::nextafter(expected, random() % 2 ? 3e38F : -3e38F); break;
    case 2: actual = finite(); break;
    case 3: actual = -expected; break;
  }
  const float low = std::min(expected, actual), high = std::max(expected, actual);
  const Bounds legal = random() % 4 == 0 ? Bounds{-kInfinity, kInfinity} : random() % 3 == 0 ? Bounds{low, high} : Bounds{low - std::fabs(low), high + std::fabs(high)};
  v.add(expected, actual, legal);
}

TEST(ValueTally, IsWhatOneByOneGivesOnEveryInstructionSet) {
  rasterizer::testing::onEveryTarget([] {
    std::mt19937 random(7);
    for (int round = 0; round < 400; ++round) {
      Values v;
      while (v.expected.size() < kTallyStep * 3) {
        if (round % 3 == 0 && random() % 4 == 0) {
          v.add(0.5F, 0.5F, {0.5F, 0.5F}, 0);
        } else {
          addRandom(v, random);
        }
      }
      const std::optional<ValueTally> tally = v.tally();
      ASSERT_TRUE(tally);
      expectSame(statsOf(v, *tally), oneByOne(v));
    }
  });
}

TEST(ValueTally, ZerosOfEitherSignAreTheSameAndStillNotAlike) {
  rasterizer::testing::onEveryTarget([] {
    Values v;
    v.add(0.0F, -0.0F, {0, 0});
    v.fill(kTallyStep);
    const std::optional<ValueTally> tally = v.tally();
    ASSERT_TRUE(tally);
    EXPECT_TRUE(tally->unequal);
    EXPECT_EQ(tally->allowed, 0U);
    expectSame(statsOf(v, *tally), oneByOne(v));
  });
}

TEST(ValueTally, TheLargestDistanceOfFiniteFloatsFits) {
  rasterizer::testing::onEveryTarget([] {
    constexpr float kLargest = std::numeric_limits<float>::max();
    Values v;
    for (size_t i = 0; i < kTallyStep; ++i) v.add(-kLargest, kLargest, {-kLargest, kLargest});
    const std::optional<ValueTally> tally = v.tally();
    ASSERT_TRUE(tally);
    EXPECT_EQ(tally->maxUlp, 2U * 0x7F7FFFFFU);
    EXPECT_EQ(tally->ulpSum, kTallyStep * 2ULL * 0x7F7FFFFFU);
    expectSame(statsOf(v, *tally), oneByOne(v));
  });
}

TEST(ValueTally, WhatIsAlikeInEveryBitNeedsNoIntervalAndNoNumber) {
  rasterizer::testing::onEveryTarget([] {
    Values v;
    v.add(kNaN, kNaN, {0, 1});
    v.add(kInfinity, kInfinity, {kNaN, kNaN});
    v.add(3, 3, {0, 1}, 0);
    v.add(1, std::nextafter(1.0F, 2.0F), {0, 2});  // so that the others are computed with
    v.fill(kTallyStep);
    const std::optional<ValueTally> tally = v.tally();
    ASSERT_TRUE(tally);
    EXPECT_EQ(tally->maxUlp, 1U);
    expectSame(statsOf(v, *tally), oneByOne(v));
  });
}

TEST(ValueTally, WhatNeedsACloserLookIsNotTallied) {
  struct Case {
    float expected, actual;
    Bounds legal;
    uint32_t drawn;
  };
  const std::vector<Case> cases{{1, 2, {0, 1.5F}, 1},           {1, 0.5F, {0.75F, 2}, 1},           {1, 2, {0, 3}, 0},
                                {kNaN, 2, {0, 3}, 1},           {2, kNaN, {0, 3}, 1},               {2, kInfinity, {0, kInfinity}, 1},
                                {-kInfinity, 2, {-3, 3}, 1},    {2, 3, {kNaN, kNaN}, 1},            {0.0F, -0.0F, {1, 2}, 1}};
  rasterizer::testing::onEveryTarget([&] {
    for (const Case& one : cases) {
      for (size_t place = 0; place < kTallyStep; ++place) {
        Values v;
        v.fill(place);
        v.add(one.expected, one.actual, one.legal, one.drawn);
        v.fill(kTallyStep);
        EXPECT_FALSE(v.tally()) << one.expected << " " << one.actual << " at " << place;
      }
    }
  });
}

TEST(DrawnIfAlike, CountsWhatIsDrawnAndSeesEveryDifference) {
  rasterizer::testing::onEveryTarget([] {
    std::vector<uint32_t> primitives(kTallyStep * 2), counts(kTallyStep * 2);
    for (size_t i = 0; i < primitives.size(); i += 3) primitives[i] = counts[i] = 0xFFFFFFFFU - static_cast<uint32_t>(i);
    const auto ask = [&](const std::vector<uint32_t>& p, const std::vector<uint32_t>& c) {
      return drawnIfAlike(primitives.data(), p.data(), counts.data(), c.data(), primitives.size());
    };
    EXPECT_EQ(ask(primitives, counts), 11U);
    for (size_t i = 0; i < primitives.size(); ++i) {
      std::vector<uint32_t> other = primitives;
      other[i] ^= 0x80000000U;
      EXPECT_FALSE(ask(other, counts));
      other = counts;
      other[i] ^= 1U;
      EXPECT_FALSE(ask(primitives, other));
    }
  });
}

}  // namespace
}  // namespace rasterdiff::harness
