// The fast value kernel: coverage equals the oracle bit for bit, values keep their stated bound, and neither depends on the
// instruction set or on the number of threads.
#include "rasterizer/kernels/value_kernel.hpp"

#include <bit>
#include <cmath>
#include <limits>

#include "rasterizer/kernels/value_bins.hpp"
#include "rasterizer/kernels/value_oracle.hpp"
#include "value_support.hpp"

namespace rasterdiff::rasterizer {
namespace {

using testing::ValueLoad;
constexpr std::array kAllKinds{ValueKind::Perspective, ValueKind::Noperspective, ValueKind::Flat, ValueKind::Perspective};

std::vector<SnappedTriangle> some(const testing::Family& family, size_t count, Prng& random) {
  std::vector<SnappedTriangle> triangles;
  while (triangles.size() < count) triangles.push_back(family.make(random));
  return triangles;
}

std::vector<SnappedTriangle> someOfEach(int32_t width, int32_t height, Prng& random) {
  constexpr size_t kEach = 20;
  std::vector<SnappedTriangle> triangles;
  for (const auto& family : testing::hardFamilies(width, height)) {
    for (const SnappedTriangle& triangle : some(family, kEach, random)) triangles.push_back(triangle);
  }
  return triangles;
}

double halfUlp(float value) {
  const float magnitude = std::fabs(value);
  return 0.5 * (double{std::nextafter(magnitude, std::numeric_limits<float>::infinity())} - magnitude);
}

TEST(ValueKernel, IndexAndCountEqualTheOracleOnHardTriangles) {
  for (const auto& family : testing::hardFamilies(131, 77))
    for (const uint32_t samples : {1u, 2u, 4u, 8u}) {
      Prng random(samples);
      const ValueLoad load = testing::makeLoad(some(family, 90, random), {}, random);
      auto expected = *ValueTarget::create(131, 77, samples, {.primitive = true, .count = true});
      drawValuesOracle(load.view(), expected);
      testing::onEveryTarget([&] {
        auto drawn = *ValueTarget::create(131, 77, samples, {.primitive = true, .count = true});
        drawValues(load.view(), drawn);
        EXPECT_EQ(drawn.differing(expected), 0u) << family.name << ", " << samples << " samples";
      });
    }
}

/// Rows and pixels by the thousand.
TEST(ValueKernel, IndexAndCountEqualTheOracleOnHighAndWideTargets) {
  for (const auto& [width, height] : {std::pair{40, 2200}, {16384, 60}})
    for (const size_t family : {6u, 7u, 8u, 10u}) {
      Prng random(family);
      const ValueLoad load = testing::makeLoad(some(testing::hardFamilies(width, height)[family], 30, random), {}, random);
      auto expected = *ValueTarget::create(static_cast<uint32_t>(width), static_cast<uint32_t>(height), 1, {.primitive = true, .count = true});
      const ValueTarget cleared = expected;
      drawValuesOracle(load.view(), expected);
      testing::onEveryTarget([&] {
        ValueTarget drawn = cleared;
        drawValues(load.view(), drawn);
        EXPECT_EQ(drawn.differing(expected), 0u) << width << " x " << height << ", " << family;
      });
    }
}

TEST(ValueKernel, PlanesThatAreNotNeededDoNotChangeTheOthers) {
  Prng random(11);
  const ValueLoad load = testing::makeLoad(some(testing::hardFamilies(131, 77)[5], 200, random), {}, random);
  for (const bool depth : {false, true}) {
    auto all = *ValueTarget::create(131, 77, 4, {true, true, depth, 0});
    drawValues(load.view(), all);
    for (const auto& [primitive, count] : {std::pair{true, false}, {false, true}, {false, false}}) {
      auto one = *ValueTarget::create(131, 77, 4, {primitive, count, depth, 0});
      drawValues(load.view(), one);
      EXPECT_TRUE(!primitive || one.primitive == all.primitive);
      EXPECT_TRUE(!count || one.count == all.count);
      EXPECT_TRUE(!depth || one.depth == all.depth);
    }
  }
}

/// Each triangle alone, so that every covered sample is judged.
TEST(ValueKernel, DepthAndVaryingsKeepTheirBoundOnHardTriangles) {
  uint64_t judged = 0, nearest = 0, neighbours = 0;
  for (const auto& family : testing::hardFamilies(67, 45)) {
    Prng random(17);
    for (int k = 0; k < 60; ++k) {
      const ValueLoad load = testing::makeLoad(some(family, 1, random), {kAllKinds.begin(), kAllKinds.end()}, random);
      const SnappedTriangle& t = load.positions[0];
      if (std::abs(t.v[0].x) > 1 << 22 || std::abs(t.v[1].x) > 1 << 22 || std::abs(t.v[2].x) > 1 << 22 ||
          std::abs(t.v[0].y) > 1 << 22 || std::abs(t.v[1].y) > 1 << 22 || std::abs(t.v[2].y) > 1 << 22)
        continue;
      auto drawn = *ValueTarget::create(67, 45, 4, {true, false, true, 4});
      std::ranges::fill(drawn.depth, 2.0F);
      drawValues(load.view(), drawn);
      const auto judge = [&](float value, double exact, double bound) {
        ++judged;
        nearest += value == static_cast<float>(exact) ? 1u : 0u;
        neighbours += std::fabs(value - exact) <= 2 * halfUlp(value) ? 1u : 0u;
        ASSERT_LE(std::fabs(value - exact), halfUlp(value) + bound) << family.name;
      };
      for (uint32_t y = 0; y < 45; ++y)
        for (uint32_t x = 0; x < 67; ++x)
          for (uint32_t s = 0; s < 4; ++s) {
            const size_t i = drawn.index(x, y, s);
            if (drawn.primitive[i] == 0) continue;
            const SubpixelPosition corner{static_cast<int32_t>(256 * x), static_cast<int32_t>(256 * y)};
            const SubpixelPosition centre{corner.x + 128, corner.y + 128};
            const SubpixelPosition at{corner.x + drawn.locations()[s].x * kSampleUnit, corner.y + drawn.locations()[s].y * kSampleUnit};
            const auto vertices = [](const std::array<float, 3>& v) { return std::array<double, 3>{v[0], v[1], v[2]}; };
            const std::array<float, 3> z{load.depth[0], load.depth[1], load.depth[2]};
            const std::array<float, 3> w{load.reciprocalW[0], load.reciprocalW[1], load.reciprocalW[2]};
            judge(drawn.depth[i], exactValue(t, at, z), linearValueBound(t, at, vertices(z)));
            for (size_t c = 0; c < 4; ++c) {
              const std::array<float, 3> a{load.values[c], load.values[4 + c], load.values[8 + c]};
              const float value = drawn.varyings[c][i];
              switch (load.kinds[c]) {
                case ValueKind::Flat: EXPECT_EQ(value, a[0]); break;
                case ValueKind::Noperspective: judge(value, exactValue(t, centre, a), varyingBound(t, centre, a, {1, 1, 1})); break;
                case ValueKind::Perspective: judge(value, exactPerspectiveValue(t, centre, a, w), varyingBound(t, centre, a, w)); break;
              }
            }
          }
      if (HasFatalFailure()) return;
    }
  }
  EXPECT_GT(judged, 1'000'000u);
  EXPECT_GT(static_cast<double>(nearest), 0.9999 * static_cast<double>(judged)) << "the error is a rounding, not a habit";
  EXPECT_EQ(neighbours, judged) << "no family is so hard that a value is not one of the two next to the exact one";
}

TEST(ValueKernel, EveryInstructionSetAndThreadCountDrawsTheSameBits) {
  for (const auto& family : testing::hardFamilies(331, 203)) {
    Prng random(23);
    const ValueLoad load = testing::makeLoad(some(family, 150, random), {kAllKinds.begin(), kAllKinds.end()}, random);
    for (const uint32_t samples : {1u, 4u}) {
      auto expected = *ValueTarget::create(331, 203, samples, {true, true, true, 4});
      drawValues(load.view(), expected);
      const auto expectSame = [&](unsigned threads) {
        auto drawn = *ValueTarget::create(331, 203, samples, {true, true, true, 4});
        drawValues(load.view(), drawn, threads);
        EXPECT_EQ(drawn.differing(expected), 0u) << family.name << ", " << threads << " threads";
        for (size_t c = 0; c < 4; ++c)
          for (uint32_t row = 0; row < 203 * samples; ++row) {
            const size_t first = row * drawn.stride();
            ASSERT_TRUE(std::equal(&drawn.varyings[c][first], &drawn.varyings[c][first] + 331, &expected.varyings[c][first])) << family.name;
          }
      };
      testing::onEveryTarget([&] { expectSame(1); });
      for (const unsigned threads : {2u, 3u, 7u}) expectSame(threads);
    }
  }
}

/// Where all components are in perspective some are fetched together: each is what it is beside a flat one, which is fetched alone.
TEST(ValueKernel, PerspectiveComponentsAreTheSameInAnyCompany) {
  constexpr uint32_t kWidth = 150, kHeight = 90;
  Prng random(41);
  const std::vector<SnappedTriangle> triangles = someOfEach(kWidth, kHeight, random);
  for (const size_t count : {1u, 3u, 4u, 5u, 8u, 11u, 16u}) {
    const ValueLoad load = testing::makeLoad(triangles, std::vector(count, ValueKind::Perspective), random);
    std::vector<ValueRows<float>> expected;
    for (size_t c = 0; c < count; ++c) {
      std::vector<float> values;
      for (size_t i = 0; i < 3 * triangles.size(); ++i) values.insert(values.end(), {load.values[i * count + c], 0});
      const std::vector kinds{ValueKind::Perspective, ValueKind::Flat};
      const ValueRows<float> carried = carriedValues(load.reciprocalW, values, 2);
      auto target = *ValueTarget::create(kWidth, kHeight, 1, {true, false, true, 2});
      drawValues({load.positions, load.depth, carried, kinds}, target);
      expected.push_back(target.varyings[0]);
    }
    testing::onEveryTarget([&] {
      auto target = *ValueTarget::create(kWidth, kHeight, 1, {true, false, true, static_cast<uint32_t>(count)});
      drawValues(load.view(), target);
      for (size_t c = 0; c < count; ++c)
        for (uint32_t y = 0; y < kHeight; ++y)
          ASSERT_TRUE(std::equal(&target.varyings[c][target.index(0, y, 0)], &target.varyings[c][target.index(kWidth, y, 0)],
                                 &expected[c][target.index(0, y, 0)]))
              << "component " << c << " of " << count << ", row " << y;
    });
  }
}

/// So many varyings that they are stored past the caches, where the instruction set can.
TEST(ValueKernel, VaryingsOfALargeTargetAreThoseOfASmallOne) {
  constexpr uint32_t kWidth = 700, kHeight = 400, kColumns = 128;
  Prng random(37);
  std::vector<SnappedTriangle> triangles = someOfEach(kColumns, kHeight, random);
  triangles.push_back({{SubpixelPosition{0, 0}, {256 * 700, 0}, {256 * 700, 256 * 400}}});
  const ValueLoad load = testing::makeLoad(std::move(triangles), {kAllKinds.begin(), kAllKinds.end()}, random);
  auto small = *ValueTarget::create(kColumns, kHeight, 1, {true, false, true, 4});
  drawValues(load.view(), small);
  testing::onEveryTarget([&] {
    auto large = *ValueTarget::create(kWidth, kHeight, 1, {true, false, true, 4});
    drawValues(load.view(), large);
    for (size_t c = 0; c < 4; ++c)
      for (uint32_t y = 0; y < kHeight; ++y)
        ASSERT_TRUE(std::equal(&small.varyings[c][small.index(0, y, 0)], &small.varyings[c][small.index(kColumns, y, 0)],
                               &large.varyings[c][large.index(0, y, 0)]))
            << "component " << c << ", row " << y;
  });
}

/// Of a target so large that it is drawn band by band; drawBand draws it at once.
TEST(ValueKernel, BandsOfALargeTargetChangeNothing) {
  constexpr uint32_t kWidth = 1500, kHeight = 1001, kSamples = 4;
  Prng random(33);
  const ValueLoad load = testing::makeLoad(someOfEach(kWidth, kHeight, random), {}, random);
  auto atOnce = *ValueTarget::create(kWidth, kHeight, kSamples, {true, true, true, 0});
  ASSERT_LT(nearRows(load.view(), atOnce), kHeight);
  drawBand(load.view(), atOnce, 0, kHeight, 0);
  for (const unsigned threads : {1u, 3u}) {
    auto inBands = *ValueTarget::create(kWidth, kHeight, kSamples, {true, true, true, 0});
    drawValues(load.view(), inBands, threads);
    EXPECT_EQ(inBands.differing(atOnce), 0u) << threads;
  }
}

TEST(ValueBins, HoldEachTriangleInTheBandsThatItReachesInOrder) {
  const auto triangle = [](int32_t top, int32_t bottom) { return SnappedTriangle{{SubpixelPosition{0, top}, {256, bottom}, {0, bottom}}}; };
  const std::vector<SnappedTriangle> triangles{triangle(16 * 256, 17 * 256), triangle(-9000, -1), triangle(-1, 0), triangle(24 * 256 - 1, 40 * 256 - 1),
                                               triangle(50 * 256, 60 * 256), triangle(-1000000, 1000000)};
  const ValueBins bins(triangles, {}, 16, 50, 8);  // rows 16, 24, 32, 40, 48
  ASSERT_EQ(bins.size(), 5u);
  const std::vector<std::vector<uint32_t>> expected{{0, 3, 5}, {3, 5}, {3, 5}, {5}, {5}};
  for (size_t band = 0; band < 5; ++band)
    EXPECT_TRUE(std::ranges::equal(std::span(bins.of(band).places, bins.of(band).size), expected[band])) << band;
}

TEST(ValueKernel, TheNearerOfTwoTrianglesWinsAndTheFirstOfTwoAlike) {
  Prng random(1);
  const SnappedTriangle t{{SubpixelPosition{0, 0}, {8192, 0}, {0, 8192}}};
  ValueLoad load = testing::makeLoad({t, t, t}, {}, random);
  load.depth = {0.5F, 0.5F, 0.5F, 0.25F, 0.25F, 0.25F, 0.25F, 0.25F, 0.25F};
  auto target = *ValueTarget::create(16, 16, 1, {true, true, true, 0});
  drawValues(load.view(), target);
  EXPECT_EQ(target.primitive[target.index(3, 3, 0)], 2u);
  EXPECT_EQ(target.count[target.index(3, 3, 0)], 2u);
  EXPECT_EQ(target.depth[target.index(3, 3, 0)], 0.25F);
}

TEST(ValueTarget, RefusesWhatItCannotHold) {
  EXPECT_FALSE(ValueTarget::create(0, 4, 1, {}).has_value());
  EXPECT_FALSE(ValueTarget::create(4, 20000, 1, {}).has_value());
  EXPECT_FALSE(ValueTarget::create(4, 4, 3, {}).has_value());
  EXPECT_FALSE(ValueTarget::create(4, 4, 1, {.primitive = false, .components = 1}).has_value());
  EXPECT_FALSE(ValueTarget::create(4, 4, 1, {.primitive = true, .components = 17}).has_value());
  EXPECT_TRUE(ValueTarget::create(4, 4, 1, {})->depth.empty());
}

}  // namespace
}  // namespace rasterdiff::rasterizer
