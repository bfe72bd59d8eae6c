// The diamond-exit line against its own definition in rationals, and the properties that strips rely on.
#include "rasterizer/methods/diamond_exit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>

#include "scene/generators/prng.hpp"
#include "tests/methods/rational_geometry.hpp"

namespace rasterdiff::rasterizer {
namespace {

constexpr PixelArea kEverywhere = {-1 << 22, -1 << 22, 1 << 22, 1 << 22};
constexpr DiamondRule kRules[] = {DiamondRule::Vulkan, DiamondRule::Direct3D11};

std::vector<PixelIndex> line(SubpixelPosition a, SubpixelPosition b, DiamondRule rule) {
  return diamondExitPixels(a, b, rule, kEverywhere);
}

std::string describe(SubpixelPosition a, SubpixelPosition b, DiamondRule rule) {
  std::ostringstream text;
  text << '(' << a.x << ", " << a.y << ") - (" << b.x << ", " << b.y << ") / 256 under "
       << (rule == DiamondRule::Vulkan ? "Vulkan" : "Direct3D 11");
  return text.str();
}

/// Every pixel of the box around the segment, asked one by one.
std::vector<PixelIndex> definition(SubpixelPosition a, SubpixelPosition b, DiamondRule rule) {
  std::vector<PixelIndex> pixels;
  const int32_t left = (std::min(a.x, b.x) >> 8) - 1, right = (std::max(a.x, b.x) >> 8) + 1;
  const int32_t top = (std::min(a.y, b.y) >> 8) - 1, bottom = (std::max(a.y, b.y) >> 8) + 1;
  for (int32_t x = left; x <= right; ++x) {
    for (int32_t y = top; y <= bottom; ++y) {
      if (testing::producesPixel(a, b, {x, y}, rule)) pixels.push_back({x, y});
    }
  }
  return pixels;
}

void expectDefinition(SubpixelPosition a, SubpixelPosition b, DiamondRule rule) {
  std::vector<PixelIndex> drawn = line(a, b, rule);
  std::sort(drawn.begin(), drawn.end());
  EXPECT_EQ(drawn, definition(a, b, rule)) << describe(a, b, rule);
}

TEST(DiamondExit, AllSegmentsOnTheQuarterGridFromEveryPlaceInAPixelFollowTheDefinition) {
  // Every direction and every place of the ends on corners, edges, centres and between, within a pixel and a half.
  for (int32_t start = 0; start < 16; ++start) {
    const SubpixelPosition a{start % 4 * 64, start / 4 * 64};
    for (int32_t dx = -6; dx <= 6; ++dx) {
      for (int32_t dy = -6; dy <= 6; ++dy) {
        for (const DiamondRule rule : kRules) expectDefinition(a, {a.x + dx * 64, a.y + dy * 64}, rule);
      }
    }
  }
}

TEST(DiamondExit, RandomSegmentsOnTheSubpixelGridFollowTheDefinition) {
  Prng prng(11);
  for (int i = 0; i < 1500; ++i) {
    const int32_t step = prng.chance(50) ? 1 : prng.chance(50) ? 16 : 128;
    const auto coordinate = [&] { return prng.between(-5 * 256 / step, 5 * 256 / step) * step; };
    const SubpixelPosition a{coordinate(), coordinate()}, b{coordinate(), coordinate()};
    for (const DiamondRule rule : kRules) expectDefinition(a, b, rule);
  }
}

TEST(DiamondExit, DiagonalsThroughDiamondEdgesFollowTheDefinition) {
  Prng prng(12);
  for (int i = 0; i < 500; ++i) {
    const SubpixelPosition a{prng.between(-8, 8) * 64, prng.between(-8, 8) * 64};
    const int32_t length = prng.between(-20, 20) * 32;
    for (const DiamondRule rule : kRules) {
      expectDefinition(a, {a.x + length, a.y + length}, rule);
      expectDefinition(a, {a.x + length, a.y - length}, rule);
    }
  }
}

TEST(DiamondExit, BetweenPixelCentresTheFirstPixelIsDrawnAndTheLastIsNot) {
  for (const DiamondRule rule : kRules) {
    EXPECT_EQ(line({128, 128}, {128 + 3 * 256, 128}, rule), (std::vector<PixelIndex>{{0, 0}, {1, 0}, {2, 0}}));
    EXPECT_EQ(line({128 + 3 * 256, 128}, {128, 128}, rule), (std::vector<PixelIndex>{{3, 0}, {2, 0}, {1, 0}}));
    EXPECT_EQ(line({128, 128}, {128, 128 + 2 * 256}, rule), (std::vector<PixelIndex>{{0, 0}, {0, 1}}));
    EXPECT_EQ(line({128, 128}, {128 + 512, 128 + 512}, rule), (std::vector<PixelIndex>{{0, 0}, {1, 1}}));
  }
}

TEST(DiamondExit, HorizontalLineBetweenTwoRowsBelongsToTheUpperRow) {
  for (const DiamondRule rule : kRules) {
    EXPECT_EQ(line({128, 256}, {128 + 2 * 256, 256}, rule), (std::vector<PixelIndex>{{0, 0}, {1, 0}}));
  }
}

TEST(DiamondExit, CrossingBetweenTwoRowsIsWhereVulkanAndDirect3DDiffer) {
  // In the middle of column 1 this line passes exactly between rows 0 and 1.
  const SubpixelPosition a{128, 192}, b{128 + 2 * 256, 320};
  EXPECT_EQ(line(a, b, DiamondRule::Vulkan)[1], (PixelIndex{1, 1}));
  EXPECT_EQ(line(a, b, DiamondRule::Direct3D11)[1], (PixelIndex{1, 0}));
}

TEST(DiamondExit, ASegmentWithoutLengthDrawsNothing) {
  for (const DiamondRule rule : kRules) {
    for (const SubpixelPosition p : {SubpixelPosition{128, 128}, {0, 128}, {128, 256}, {13, 250}}) {
      EXPECT_TRUE(line(p, p, rule).empty());
    }
  }
}

TEST(DiamondExit, PiecesOfALineDrawEveryPixelOfItOnce) {
  Prng prng(13);
  for (int i = 0; i < 2000; ++i) {
    // Two pieces of one straight line: the joint lies on the grid and on the line.
    const int32_t dx = prng.between(-700, 700), dy = prng.between(-700, 700), first = prng.between(1, 3);
    const SubpixelPosition a{prng.between(-512, 512), prng.between(-512, 512)};
    const SubpixelPosition joint{a.x + dx * first, a.y + dy * first}, b{joint.x + dx, joint.y + dy};
    for (const DiamondRule rule : kRules) {
      std::vector<PixelIndex> pieces = line(a, joint, rule);
      const std::vector<PixelIndex> second = line(joint, b, rule);
      pieces.insert(pieces.end(), second.begin(), second.end());
      EXPECT_EQ(pieces, line(a, b, rule)) << describe(a, b, rule);
    }
  }
}

TEST(DiamondExit, APixelIsDrawnOncePerColumnInOrder) {
  Prng prng(14);
  for (int i = 0; i < 2000; ++i) {
    const auto coordinate = [&] { return prng.between(-40 * 256, 40 * 256); };
    const DiamondLine segment({coordinate(), coordinate()}, {coordinate(), coordinate()}, DiamondRule::Vulkan);
    for (int64_t k = 1; k < segment.count(); ++k) {
      const PixelIndex before = segment.pixel(k - 1), here = segment.pixel(k);
      EXPECT_EQ(std::abs(segment.xMajor() ? here.x - before.x : here.y - before.y), 1);
      EXPECT_LE(std::abs(segment.xMajor() ? here.y - before.y : here.x - before.x), 1);
    }
  }
}

TEST(DiamondExit, CutToAnAreaItDrawsWhatLiesInTheArea) {
  Prng prng(15);
  const PixelArea area{-3, 2, 9, 12};
  for (int i = 0; i < 2000; ++i) {
    const auto coordinate = [&] { return prng.between(-20 * 256, 20 * 256); };
    const SubpixelPosition a{coordinate(), coordinate()}, b{coordinate(), coordinate()};
    for (const DiamondRule rule : kRules) {
      std::vector<PixelIndex> expected = line(a, b, rule);
      std::erase_if(expected, [&](PixelIndex p) { return !area.contains(p.x, p.y); });
      EXPECT_EQ(diamondExitPixels(a, b, rule, area), expected) << describe(a, b, rule);
    }
  }
}

TEST(DiamondExit, HugeSegmentsCostOnlyTheirPartInTheArea) {
  constexpr int32_t kFar = 1 << 29;
  const std::vector<PixelIndex> pixels =
      diamondExitPixels({-kFar, -kFar + 128}, {kFar, kFar - 128}, DiamondRule::Vulkan, {0, 0, 4, 4});
  EXPECT_EQ(pixels, (std::vector<PixelIndex>{{0, 0}, {1, 1}, {2, 2}, {3, 3}}));
}

}  // namespace
}  // namespace rasterdiff::rasterizer
