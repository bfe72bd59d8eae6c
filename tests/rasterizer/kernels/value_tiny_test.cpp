// Tiny triangles, which a kernel may draw a vector at a time, are drawn in their order and where they are, whatever they are beside.
#include <algorithm>
#include <array>
#include <bit>
#include <optional>

#include "rasterizer/kernels/value_kernel.hpp"
#include "rasterizer/kernels/value_oracle.hpp"
#include "value_support.hpp"

namespace rasterdiff::rasterizer {
namespace {

using testing::ValueLoad;

constexpr uint32_t kWidth = 45, kHeight = 31;
constexpr ValueNeeds kAll{true, true, true, 0};

/// In a box of `columns` x `rows` pixels, over the target's edges too.
SnappedTriangle within(int32_t columns, int32_t rows, Prng& random) {
  const int32_t x = random.between(-300, 256 * static_cast<int32_t>(kWidth)), y = random.between(-300, 256 * static_cast<int32_t>(kHeight));
  SnappedTriangle t;
  for (SubpixelPosition& v : t.v) v = {x + random.between(0, 256 * columns), y + random.between(0, 256 * rows)};
  return t;
}

/// Runs of tiny ones of up to `rows` rows, one in `others` of which is a little more, or is not drawn at all.
std::vector<SnappedTriangle> manyTiny(size_t count, int32_t rows, uint32_t others, Prng& random) {
  std::vector<SnappedTriangle> triangles;
  while (triangles.size() < count) {
    SnappedTriangle t = within(random.between(1, 7), random.between(1, rows), random);
    switch (random.below(6 * others)) {
      case 0: t = within(12, 4, random); break;            // too wide
      case 1: t = within(3, 9, random); break;             // too high
      case 2: t.v[1].x += 1 << 23; break;                  // beyond the fast range
      case 3: t.v[2] = t.v[1]; break;                      // no area
      case 4: for (SubpixelPosition& v : t.v) v.y += 256 * 40; break;  // below
      case 5: t = within(40, 30, random); break;
    }
    triangles.push_back(t);
  }
  return triangles;
}

ValueTarget drawn(const ValueLoad& load, uint32_t samples, ValueNeeds needs) {
  ValueTarget target = *ValueTarget::create(kWidth, kHeight, samples, needs);
  drawValues(load.view(), target);
  return target;
}

TEST(ValueTiny, IndexAndCountEqualTheOracle) {
  for (const uint32_t others : {100000u, 50u, 8u})
    for (const uint32_t samples : {1u, 4u, 16u}) {
      Prng random(samples + others);
      const ValueLoad load = testing::makeLoad(manyTiny(900, samples == 1 ? 4 : 3, others, random), {}, random);
      auto expected = *ValueTarget::create(kWidth, kHeight, samples, {.primitive = true, .count = true});
      drawValuesOracle(load.view(), expected);
      testing::onEveryTarget([&] {
        for (const ValueNeeds needs : {ValueNeeds{.primitive = true}, ValueNeeds{.count = true}}) {
          const ValueTarget target = drawn(load, samples, needs);
          EXPECT_TRUE(!needs.primitive || target.primitive == expected.primitive) << samples << " samples";
          EXPECT_TRUE(!needs.count || target.count == expected.count) << samples << " samples";
        }
      });
    }
}

/// More chunks of one batch than the list holds; with rows of up to 6, 8 and 9 pixels.
TEST(ValueTiny, OfManySamplesAreAllDrawn) {
  for (const int32_t base : {1700, 2040, 2150}) {
    ValueLoad load;
    for (int32_t k = 0; k < 64; ++k) {
      const int32_t x = 400 * (k % 20), y = 1500 * (k / 20);
      load.positions.push_back({{SubpixelPosition{x, y}, {x + base, y}, {x, y + 760}}});
      load.depth.insert(load.depth.end(), 3, 0.5F);
    }
    auto expected = *ValueTarget::create(kWidth, kHeight, 16, kAll);
    drawValuesOracle(load.view(), expected);
    testing::onEveryTarget([&] { EXPECT_EQ(drawn(load, 16, kAll).differing(expected), 0u) << base; });
  }
}

/// In a target of four rows even those beyond the fast range are low. Edges pass through centres, from afar.
TEST(ValueTiny, AreNotThoseBeyondTheFastRange) {
  Prng random(72);
  ValueLoad load;
  while (load.positions.size() < 400) {
    const SubpixelPosition centre{256 * random.between(8, 40) + 128, 256 * random.between(0, 3) + 128};
    const int32_t dx = random.between(1 << 19, 1 << 20), dy = random.between(1 << 19, 1 << 20), aside = random.between(-7 * 256, 7 * 256);
    const auto along = [&](int32_t times) { return SubpixelPosition{centre.x + times * dx, centre.y + times * dy}; };
    load.positions.push_back({{along(-1001), along(1000), SubpixelPosition{centre.x + aside, centre.y}}});
  }
  auto expected = *ValueTarget::create(kWidth, 4, 1, {.count = true});
  const ValueTarget cleared = expected;
  drawValuesOracle(load.view(), expected);
  testing::onEveryTarget([&] {
    ValueTarget target = cleared;
    drawValues(load.view(), target);
    EXPECT_EQ(target.count, expected.count);
  });
}

TEST(ValueTiny, DepthsAreThoseOfTrianglesDrawnOneByOne) {
  for (const uint32_t others : {100000u, 30u})
    for (const uint32_t samples : {1u, 4u, 16u}) {
      Prng random(samples + others);
      ValueLoad load = testing::makeLoad(manyTiny(500, samples == 1 ? 4 : 3, others, random), {}, random);
      for (size_t t = 0; t < load.positions.size(); t += 3) std::fill_n(&load.depth[3 * t], 3, 0.25F);  // equally deep
      // A vector with a large one is not drawn as tiny ones are.
      const std::array large{SnappedTriangle{{SubpixelPosition{0, 0}, {256 * 40, 0}, {0, 256 * 30}}}};
      const ValueTarget expected = testing::drawnApart(load, *ValueTarget::create(kWidth, kHeight, samples, kAll), large);
      testing::onEveryTarget([&] {
        EXPECT_EQ(drawn(load, samples, kAll).differing(expected), 0u) << samples << " samples";
        const ValueTarget numbered = drawn(load, samples, {true, false, true, 0});
        EXPECT_EQ(numbered.primitive, expected.primitive);
        EXPECT_EQ(numbered.depth, expected.depth);
        EXPECT_EQ(drawn(load, samples, {false, false, true, 0}).depth, expected.depth);
      });
    }
}

/// Bands of a target, and planes through corners.
TEST(ValueTiny, PlanesThroughCornersAreTheSameInBandsAndOnEveryInstructionSet) {
  Prng random(71);
  const ValueLoad load = testing::makeLoad(manyTiny(900, 3, 30, random), {}, random);
  std::vector<DepthCorners> corners;
  for (size_t t = 0; t < load.positions.size(); ++t) {
    DepthCorners c;
    for (size_t i = 0; i < 3; ++i) c.x[i] = load.positions[t].v[i].x / 256.0 + 0.001, c.y[i] = load.positions[t].v[i].y / 256.0, c.z[i] = load.depth[3 * t + i];
    corners.push_back(c);
  }
  const ValueTriangles triangles{load.positions, {}, {}, {}, corners};
  for (const uint32_t samples : {1u, 4u}) {
    std::optional<ValueTarget> expected;
    testing::onEveryTarget([&] {
      ValueTarget whole = *ValueTarget::create(kWidth, kHeight, samples, kAll);
      drawBand(triangles, whole, 0, kHeight, 0);
      if (!expected) expected = whole;
      EXPECT_EQ(whole.differing(*expected), 0u);
      for (const uint32_t top : {8u, 16u}) {
        ValueTarget band = *ValueTarget::create(kWidth, 16, samples, kAll);
        const ValueTarget cleared = band;
        drawBand(triangles, band, top, top + 8, 0);
        const auto below = static_cast<ptrdiff_t>(band.index(0, 8, 0));
        EXPECT_TRUE(std::equal(band.primitive.begin() + below, band.primitive.end(), cleared.primitive.begin() + below));
        for (uint32_t y = 0; y < 8; ++y)
          for (uint32_t s = 0; s < samples; ++s)
            for (uint32_t x = 0; x < kWidth; ++x) {
              const size_t i = band.index(x, y, s), k = expected->index(x, top + y, s);
              ASSERT_EQ(band.primitive[i], expected->primitive[k]);
              ASSERT_EQ(band.count[i], expected->count[k]);
              ASSERT_EQ(std::bit_cast<uint32_t>(band.depth[i]), std::bit_cast<uint32_t>(expected->depth[k]));
            }
      }
    });
  }
}

}  // namespace
}  // namespace rasterdiff::rasterizer
