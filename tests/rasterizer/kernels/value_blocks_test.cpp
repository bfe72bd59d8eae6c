// Blocks that hide triangles as a whole change nothing: whatever is drawn together equals, bit for bit, what is drawn one by one.
#include <bit>
#include <cmath>
#include <limits>

#include "rasterizer/kernels/value_kernel.hpp"
#include "value_support.hpp"

namespace rasterdiff::rasterizer {
namespace {

using testing::ValueLoad;

constexpr float kInfinity = std::numeric_limits<float>::infinity();

std::vector<SnappedTriangle> some(const testing::Family& family, size_t count, Prng& random) {
  std::vector<SnappedTriangle> triangles;
  while (triangles.size() < count) triangles.push_back(family.make(random));
  return triangles;
}

std::vector<SnappedTriangle> wide(size_t count, Prng& random) { return some(testing::hardFamilies(700, 200)[6], count, random); }

/// Many layers, over the edges of width x height pixels too, each of some hundred pixels.
std::vector<SnappedTriangle> layers(size_t count, int32_t width, int32_t height, Prng& random) {
  std::vector<SnappedTriangle> triangles;
  while (triangles.size() < count) {
    const int32_t x = random.between(-10 * 256, (width + 10) * 256), y = random.between(-10 * 256, (height + 10) * 256);
    SnappedTriangle t;
    for (SubpixelPosition& v : t.v) v = {x + random.between(-30 * 256, 30 * 256), y + random.between(-30 * 256, 30 * 256)};
    triangles.push_back(t);
  }
  return triangles;
}

ValueTarget farTarget(uint32_t width, uint32_t height, uint32_t samples, bool onlyDepth = false) {
  ValueTarget target = *ValueTarget::create(width, height, samples, {!onlyDepth, !onlyDepth, true, 0});
  std::ranges::fill(target.depth, kInfinity);
  return target;
}

void expectSameTogether(const ValueLoad& load, const ValueTarget& cleared) {
  const ValueTarget apart = testing::drawnApart(load, cleared);
  testing::onEveryTarget([&] {
    for (const unsigned threads : {1u, 3u}) {
      ValueTarget together = cleared;
      drawValues(load.view(), together, threads);
      EXPECT_EQ(together.differing(apart), 0u) << threads << " threads";
    }
    ValueTarget onlyDepth = farTarget(cleared.width(), cleared.height(), cleared.samples(), true);
    onlyDepth.depth = cleared.depth;
    drawValues(load.view(), onlyDepth);
    const auto bits = [](float v) { return std::bit_cast<uint32_t>(v); };
    EXPECT_TRUE(std::ranges::equal(onlyDepth.depth, apart.depth, {}, bits, bits));
  });
}

TEST(ValueBlocks, CoverWhatIsCoveredWithoutADepthTest) {
  Prng random(30);
  for (const auto& [width, height] : {std::pair{101, 61}, {40, 2200}, {16384, 60}}) {
    std::vector<SnappedTriangle> triangles = layers(width == 101 ? 100 : 10, width, height, random);
    for (const size_t family : {2u, 6u, 7u, 8u, 10u, 11u})
      for (const SnappedTriangle& t : some(testing::hardFamilies(width, height)[family], width == 101 ? 30 : 3, random)) triangles.push_back(t);
    for (const uint32_t samples : {1u, 4u}) {
      const ValueTarget cleared = farTarget(static_cast<uint32_t>(width), static_cast<uint32_t>(height), samples);
      const ValueTarget withoutDepth = *ValueTarget::create(cleared.width(), cleared.height(), samples, {.primitive = true});
      for (const SnappedTriangle& t : triangles) {
        const ValueLoad load = testing::makeLoad({t}, {}, random);
        ValueTarget covered = withoutDepth;
        drawValues(load.view(), covered);
        testing::onEveryTarget([&] {
          ValueTarget drawn = cleared;
          drawValues(load.view(), drawn);
          EXPECT_EQ(drawn.primitive, covered.primitive);
        });
      }
    }
  }
}

TEST(ValueBlocks, OfWideTrianglesChangeNothing) {
  Prng random(31);
  const ValueLoad load = testing::makeLoad(some(testing::hardFamilies(700, 300)[6], 60, random), {}, random);
  for (const uint32_t samples : {1u, 4u}) expectSameTogether(load, farTarget(700, 300, samples));
}

TEST(ValueBlocks, OfMediumTrianglesChangeNothing) {
  Prng random(32);
  ValueLoad load = testing::makeLoad(layers(400, 101, 61, random), {}, random);
  load.depth[7] = std::numeric_limits<float>::quiet_NaN();
  for (const uint32_t samples : {1u, 4u, 16u}) expectSameTogether(load, farTarget(101, 61, samples));
}

/// Of layers that are a unit in the last place apart, one after another nearer or farther, no rounding of a test hides a pixel.
TEST(ValueBlocks, OfLayersThatAreHardlyApartChangeNothing) {
  Prng random(34);
  for (const float scale : {1.0F, 0x1p-140F, 0x1p-126F, 0x1p90F, 0x1p99F, 0x1p120F}) {
    for (const int32_t width : {101, 700}) {
      ValueLoad load = testing::makeLoad(width == 101 ? layers(300, 101, 61, random) : wide(40, random), {}, random);
      const uint32_t base = std::bit_cast<uint32_t>(0.75F * scale);
      for (size_t t = 0; t < load.positions.size(); ++t) {
        const uint32_t layer = base - static_cast<uint32_t>(random.between(0, 2) != 0 ? t : t / 2);
        for (size_t i = 0; i < 3; ++i) load.depth[3 * t + i] = std::bit_cast<float>(layer - random.below(3));
      }
      expectSameTogether(load, farTarget(static_cast<uint32_t>(width), width == 101 ? 61 : 200, 1));
    }
  }
}

TEST(ValueBlocks, OfDepthsThatAreNoNumbersOrHugeChangeNothing) {
  constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
  constexpr std::array kDepths{kInfinity, -kInfinity, kNaN, 3e38F, -3e38F, 2e30F, -1e30F, 1e-45F, 0.0F, -0.0F, 0.5F};
  Prng random(35);
  for (const size_t kinds : {3u, 11u})
    for (const int32_t width : {101, 700}) {
      ValueLoad load = testing::makeLoad(width == 101 ? layers(200, 101, 61, random) : wide(40, random), {}, random);
      for (float& z : load.depth)
        if (random.below(3) == 0) z = kDepths[kDepths.size() - 1 - random.below(static_cast<uint32_t>(kinds))];
      for (size_t t = 0; t < load.positions.size(); t += 4) std::fill_n(&load.depth[3 * t], 3, kDepths[random.below(11)]);
      expectSameTogether(load, farTarget(static_cast<uint32_t>(width), width == 101 ? 61 : 200, 1));
    }
}

TEST(ValueBlocks, OfPlanesThroughNearlyAllFloatsChangeNothing) {
  Prng random(37);
  ValueLoad load = testing::makeLoad(wide(60, random), {}, random);
  for (float& z : load.depth) z = static_cast<float>(random.between(-3e38, 3e38));
  expectSameTogether(load, farTarget(700, 200, 1));
}

/// A block that hides a triangle but for one pixel, where that is nearer by a unit in the last place. Where a row begins the triangle is
/// nearer by far, so that what is added from block to block has roundings that are larger than what it is added to.
TEST(ValueBlocks, AreDrawnForTheSakeOfOnePixel) {
  Prng random(38);
  for (int k = 0; k < 2000; ++k) {
    const uint32_t width = k % 2 == 0 ? 101 : 700;
    ValueLoad load = testing::makeLoad(k % 2 == 0 ? layers(1, 101, 61, random) : some(testing::hardFamilies(700, 61)[6], 1, random), {}, random);
    const auto& v = load.positions[0].v;
    for (size_t i = 0; i < 3; ++i) load.depth[i] = v[i].x == std::min({v[0].x, v[1].x, v[2].x}) ? 1e-4F : 1 - load.depth[i] / 2;
    ValueTarget alone = farTarget(width, 61, 1);
    drawValues(load.view(), alone);
    float nearest = kInfinity;  // in one block
    const uint32_t column = random.below(width) / 8 * 8, row = random.below(61) / 8 * 8;
    for (uint32_t y = row; y < std::min(row + 8, 61u); ++y)
      for (uint32_t x = column; x < std::min(column + 8, width); ++x) nearest = std::min(nearest, alone.depth[alone.index(x, y, 0)]);
    if (nearest == kInfinity) continue;
    const float before = std::nextafter(nearest, 1.0F);
    const SnappedTriangle all{{SubpixelPosition{-256, -256}, {3 * 256 * 700, -256}, {-256, 3 * 256 * 700}}};
    load.positions.insert(load.positions.begin(), all);
    load.depth.insert(load.depth.begin(), 3, before);
    expectSameTogether(load, farTarget(width, 61, 1));
  }
}

/// Where a plane's roundings come nearer than its nearest vertex, which lies on a pixel's centre.
TEST(ValueBlocks, OfPlanesThatRoundPastTheirNearestVertexChangeNothing) {
  Prng random(39);
  const SnappedTriangle all{{SubpixelPosition{-256, -256}, {256 * 300, -256}, {-256, 256 * 200}}};
  for (int k = 0; k < 300; ++k) {
    SnappedTriangle t;
    for (SubpixelPosition& v : t.v) v = {random.between(0, 99) * 256 + 128, random.between(0, 59) * 256 + 128};
    ValueLoad load = testing::makeLoad({all, t}, {}, random);
    std::fill_n(load.depth.begin(), 3, 1e-3F);
    load.depth[4] = 1e-3F;
    for (const size_t far : {3u, 5u}) load.depth[far] = static_cast<float>(random.between(1e8, 1e9));
    expectSameTogether(load, farTarget(101, 61, 1));
  }
}

/// Block rows of more blocks than a list holds, at the largest numbers of blocks and rows.
TEST(ValueBlocks, OfTheWidestAndTheHighestTargetChangeNothing) {
  Prng random(36);
  for (const auto& [width, height] : {std::pair{16384u, 17u}, {17u, 16384u}}) {
    const auto w = static_cast<int32_t>(256 * width), h = static_cast<int32_t>(256 * height);
    std::vector<SnappedTriangle> triangles;
    for (int k = 0; k < 12; ++k) {
      SnappedTriangle t{{SubpixelPosition{0, 0}, {w, h}, {w / 2 + random.between(-9000, 9000), h / 2 + random.between(-9000, 9000)}}};
      for (SubpixelPosition& v : t.v) v = {v.x + random.between(-2000, 2000), v.y + random.between(-2000, 2000)};
      triangles.push_back(t);
    }
    expectSameTogether(testing::makeLoad(std::move(triangles), {}, random), farTarget(width, height, 1));
  }
}

}  // namespace
}  // namespace rasterdiff::rasterizer
