// Triangles that are drawn nearest first leave what they leave in their own order: the same depths, and of those that are equally deep the
// first one.
#include "rasterizer/kernels/value_order.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>

#include "rasterizer/kernels/value_kernel.hpp"
#include "value_support.hpp"

namespace rasterdiff::rasterizer {
namespace {

using testing::ValueLoad;

constexpr uint32_t kWidth = 203, kHeight = 101;
constexpr ValueNeeds kInOrder{true, true, true, 0}, kNumbered{true, false, true, 0}, kDepthOnly{false, false, true, 0};

SnappedTriangle someTriangle(int32_t reach, Prng& random) {
  const int32_t x = random.between(0, 256 * static_cast<int32_t>(kWidth)), y = random.between(0, 256 * static_cast<int32_t>(kHeight));
  SnappedTriangle t;
  for (SubpixelPosition& v : t.v) v = {x + random.between(-reach, reach), y + random.between(-reach, reach)};
  return t;
}

/// Many layers of every size that a kernel has a way of its own for: small, high, medium, wide, and beyond the fast range if `far`.
std::vector<SnappedTriangle> layers(size_t count, bool far, Prng& random) {
  std::vector<SnappedTriangle> triangles;
  while (triangles.size() < count) {
    SnappedTriangle t = someTriangle(256 * 40, random);
    switch (triangles.size() % 9) {
      case 0: t = someTriangle(256 * 4, random); break;
      case 1: t = someTriangle(256 * 300, random); break;
      case 2: t.v[2] = {t.v[0].x + 256 * 3, t.v[0].y}, t.v[1].y = t.v[0].y + 256 * 90; break;
      case 3: if (far) t.v[1] = {t.v[0].x + (1 << 23), t.v[0].y + 256 * 30}; break;
    }
    triangles.push_back(t);
  }
  return triangles;
}

ValueTarget targetOf(uint32_t samples, ValueNeeds needs) { return *ValueTarget::create(kWidth, kHeight, samples, needs); }

bool isReordered(const ValueLoad& load, const ValueTarget& target) {
  const std::vector<uint32_t> order = nearestFirst(load.view(), target);
  return !order.empty() && !std::ranges::is_sorted(order);
}

void expectSameInAnyOrder(const ValueLoad& load, uint32_t samples) {
  ValueTarget inOrder = targetOf(samples, kInOrder);
  ASSERT_TRUE(nearestFirst(load.view(), inOrder).empty());
  drawValues(load.view(), inOrder);
  const auto bits = [](float v) { return std::bit_cast<uint32_t>(v); };
  testing::onEveryTarget([&] {
    for (const unsigned threads : {1u, 3u})
      for (const ValueNeeds& needs : {kNumbered, kDepthOnly}) {
        ValueTarget target = targetOf(samples, needs);
        ASSERT_TRUE(isReordered(load, target));
        for (int round = 0; round < 2; ++round) {  // the second one finds itself
          drawValues(load.view(), target, threads);
          EXPECT_TRUE(std::ranges::equal(target.depth, inOrder.depth, {}, bits, bits)) << threads << " threads, round " << round;
          if (!needs.primitive) continue;
          EXPECT_EQ(target.primitive, inOrder.primitive) << threads << " threads, round " << round;
        }
      }
  });
}

TEST(ValueOrder, OfUnlikeDepthsChangesNothing) {
  Prng random(61);
  const ValueLoad load = testing::makeLoad(layers(600, true, random), {}, random);
  for (const uint32_t samples : {1u, 4u}) expectSameInAnyOrder(load, samples);
}

TEST(ValueOrder, KeepsTheFirstOfEquallyDeepOnes) {
  Prng random(62);
  for (int round = 0; round < 6; ++round) {
    std::vector<SnappedTriangle> triangles = layers(300, round < 2, random);
    const size_t size = triangles.size();
    for (size_t k = 0; k < size; ++k) triangles.push_back(triangles[random.below(static_cast<uint32_t>(size))]);
    ValueLoad load = testing::makeLoad(std::move(triangles), {}, random);
    // In one of three planes; flat ones have sums of the same step, tilted ones have not, wherever they overlap.
    const float slope = round % 2 == 0 ? 0.0F : 0x1p-24F;
    for (size_t t = 0; t < load.positions.size(); ++t)
      for (size_t i = 0; i < 3; ++i)
        load.depth[3 * t + i] = 0.5F + static_cast<float>(load.positions[t].v[i].x + 2 * load.positions[t].v[i].y) * slope + 0x1p-10F * static_cast<float>(t * 7 % 3);
    for (const uint32_t samples : {1u, 4u}) expectSameInAnyOrder(load, samples);
  }
}

/// Triangles whose nearest edges lie in rows of centres, which they cover, and are as deep there as what hides the rest of them: a flat
/// triangle, drawn first; zeros of either sign are equally deep.
TEST(ValueOrder, KeepsTheFirstWhereOnlyItsNearestEdgeMeets) {
  Prng random(67);
  for (const int32_t width : {40, 190})
    for (const float level : {0.5F, 0.0F, -0.0F})
      for (const int32_t reach : {256 * 1000, 1 << 23}) {
        ValueLoad load;
        const auto add = [&](const SnappedTriangle& t, const std::array<float, 3>& depth) {
          load.positions.push_back(t);
          load.depth.insert(load.depth.end(), depth.begin(), depth.end());
        };
        for (int k = 0; k < 12; ++k) {
          const int32_t x = random.between(0, 10 * 256), y = 256 * random.between(0, 60) + 128;
          add({{SubpixelPosition{x, y}, {x + 256 * width, y}, {x, y + 256 * 40}}}, {level, level, 0.9F});
        }
        add({{SubpixelPosition{-256, -256}, {-256, reach}, {reach, -256}}}, {level, level, level});
        add({{SubpixelPosition{-256, -256}, {reach, -256}, {-256, reach}}}, {level, level, level});
        add({{SubpixelPosition{-256, -256}, {256 * 20, -256}, {-256, reach / 8}}}, {-0.25F, -0.25F, -0.25F});
        for (const uint32_t samples : {1u, 4u}) expectSameInAnyOrder(load, samples);
        ValueTarget target = targetOf(1, kNumbered);
        drawValues(load.view(), target);
        EXPECT_TRUE(std::ranges::any_of(target.primitive, [](uint32_t number) { return number > 0 && number <= 12; }));
      }
}

TEST(ValueOrder, OfZerosOfEitherSignChangesNothing) {
  Prng random(64);
  constexpr std::array kDepths{0.0F, -0.0F, 1e-45F, -1e-45F};
  for (const uint32_t kinds : {2u, 3u, 4u}) {
    ValueLoad load = testing::makeLoad(layers(400, true, random), {}, random);
    for (float& z : load.depth) z = kDepths[random.below(kinds)];
    for (size_t t = 0; t < load.positions.size(); t += 2) std::fill_n(&load.depth[3 * t], 3, t % 4 == 0 ? -0.0F : 0.0F);
    for (size_t t = 0; t < load.positions.size(); t += 5) load.depth[3 * t] = 0.5F;
    for (const uint32_t samples : {1u, 4u}) expectSameInAnyOrder(load, samples);
  }
}

/// Some of them not numbers, or so large that all others are in one step.
TEST(ValueOrder, OfOddDepthsChangesNothing) {
  Prng random(68);
  constexpr float kMost = std::numeric_limits<float>::max(), kInfinity = std::numeric_limits<float>::infinity();
  constexpr std::array kOdd{kInfinity, -kInfinity, std::numeric_limits<float>::quiet_NaN(), kMost, -kMost, 1e-45F, 0.75F};
  for (const uint32_t kinds : {4u, 7u}) {
    ValueLoad load = testing::makeLoad(layers(400, true, random), {}, random);
    for (float& z : load.depth)
      if (random.below(40) == 0) z = kOdd[kOdd.size() - 1 - random.below(kinds)];
    for (size_t t = 3; t < load.positions.size(); t += 11) std::fill_n(&load.depth[3 * t], 3, kOdd[random.below(7)]);
    expectSameInAnyOrder(load, 1);
  }
}

TEST(ValueOrder, HoldsAllTrianglesTheNearestFirst) {
  Prng random(65);
  const ValueLoad load = testing::makeLoad(layers(2000, true, random), {}, random);
  std::vector<uint32_t> order = nearestFirst(load.view(), targetOf(1, kDepthOnly));
  const auto sum = [&](uint32_t t) { return load.depth[3 * t] + load.depth[3 * t + 1] + load.depth[3 * t + 2]; };
  for (size_t k = 1; k < order.size(); ++k) EXPECT_GT(sum(order[k]), sum(order[k - 1]) - 0.01F) << "no more than some steps back";
  std::ranges::sort(order);
  std::vector<uint32_t> all(load.positions.size());
  std::iota(all.begin(), all.end(), 0u);
  EXPECT_EQ(order, all);
}

TEST(ValueOrder, IsTheirOwnWherePlanesDependOnItOrNothingIsGained) {
  Prng random(66);
  ValueLoad load = testing::makeLoad(layers(600, true, random), {}, random);
  EXPECT_TRUE(isReordered(load, targetOf(1, kDepthOnly)));
  EXPECT_TRUE(nearestFirst(load.view(), targetOf(1, kInOrder)).empty()) << "how many pass depends on the order";
  EXPECT_TRUE(nearestFirst(load.view(), targetOf(1, {.primitive = true})).empty()) << "the last one is wanted";
  const ValueLoad few = testing::makeLoad(std::vector(10, someTriangle(256 * 30, random)), {}, random);
  EXPECT_TRUE(nearestFirst(few.view(), targetOf(1, kDepthOnly)).empty()) << "few layers";
  const ValueLoad small = testing::makeLoad(std::vector(20000, SnappedTriangle{{SubpixelPosition{0, 0}, {2560, 0}, {0, 2560}}}), {}, random);
  EXPECT_TRUE(nearestFirst(small.view(), targetOf(1, kDepthOnly)).empty()) << "of small triangles nothing is hidden as a whole";
}

}  // namespace
}  // namespace rasterdiff::rasterizer
