// Bresenham lines against the oracle, wide and thin, at every sample count; strips and joints.
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "rasterizer/lines/bresenham_rules.hpp"
#include "tests/lines/exact_oracle.hpp"
#include "tests/lines/line_support.hpp"

namespace rasterdiff::rasterizer {
namespace {

using namespace rasterdiff::rasterizer::testing;
using Mode = LineRasterizationMode;

std::vector<PixelIndex> pixelsOf(const LineEnds& ends, const LineStyle& style, const Rules& rules) {
  const auto shape = makeLineShape(ends, style, rules);
  std::vector<PixelIndex> pixels;
  for (int32_t y = 0; y < style.area.bottom; ++y) {
    for (int32_t x = 0; x < style.area.right; ++x) {
      bool tie = false;
      if (shape && shape->covers(x * 256 + 128, y * 256 + 128, tie)) pixels.push_back({x, y});
    }
  }
  return pixels;
}

TEST(BresenhamLine, IsTheDiamondExitRuleInAllOctantsAndOnAllBorders) {
  Random random(4);
  const Rules rules = rulesOf("reference");
  for (int i = 0; i < 500; ++i) {
    const int32_t step = std::array{128, 64, 32, 1}[static_cast<size_t>(random.below(4))];  // corners, edges, anything
    const auto position = [&] { return SubpixelPosition{random.onGrid(step, 6), random.onGrid(step, 6)}; };
    const SubpixelPosition a = position();
    SubpixelPosition b = position();
    if (i % 6 == 1) b.y = a.y + (b.x - a.x);  // slope 1 and -1 are x-major
    if (i % 6 == 2) b.y = a.y - (b.x - a.x);
    if (i % 6 == 3) b = {a.x + random.below(3) * step, a.y + random.below(3) * step};
    const auto shape = makeLineShape(subpixelEnds(a, b), styleOf(Mode::BRESENHAM), rules);
    for (int32_t y = -7; y < 13; ++y) {
      for (int32_t x = -1; x < 7; ++x) {
        bool tie = false;
        const bool covered = shape && shape->covers(x * 256 + 128, y * 256 + 128, tie);
        const auto beside = [](int32_t pixel, int32_t p, int32_t q) {
          return pixel < (std::min(p, q) >> 8) - 1 || pixel > (std::max(p, q) >> 8) + 1;
        };
        const bool far = beside(x, a.x, b.x) || beside(y, a.y, b.y);
        ASSERT_EQ(covered, !far && isFragment(a, b, x, y))
            << a.x << "," << a.y << " to " << b.x << "," << b.y << " pixel " << x << "," << y;
        if (covered) {
          const RowSpan columns = shape->columns(y);
          ASSERT_TRUE(y >= shape->rows().first && y <= shape->rows().last && x >= columns.begin && x < columns.end);
        }
      }
    }
  }
}

TEST(BresenhamLine, WideOnesRepeatTheFragmentsOfTheMovedLine) {
  Random random(5);
  const Rules rules = rulesOf("reference");
  for (int i = 0; i < 40; ++i) {
    const int32_t step = i % 2 == 0 ? 64 : 1;
    const auto position = [&] {
      return SubpixelPosition{random.onGrid(step, 6) + 2048, random.onGrid(step, 6) + 2048};
    };
    const SubpixelPosition a = position(), b = position();
    const int32_t width = random.below(7) + 1;
    const bool xMajor = std::abs(b.x - a.x) >= std::abs(b.y - a.y);
    const int32_t shift = (width - 1) * 128;
    const SubpixelPosition movedA = xMajor ? SubpixelPosition{a.x, a.y - shift} : SubpixelPosition{a.x - shift, a.y};
    const SubpixelPosition movedB = xMajor ? SubpixelPosition{b.x, b.y - shift} : SubpixelPosition{b.x - shift, b.y};
    // Every sample of a pixel follows the pixel, at every count.
    const LineStyle style = styleOf(Mode::BRESENHAM, static_cast<float>(width) + 0.25F, 16);
    const auto shape = makeLineShape(subpixelEnds(a, b), style, rules);
    for (int32_t y = 2; y < 22; ++y) {
      for (int32_t x = 2; x < 22; ++x) {
        bool expected = false;
        for (int32_t k = 0; k < width && !expected; ++k) {
          expected = xMajor ? isFragment(movedA, movedB, x, y - k) : isFragment(movedA, movedB, x - k, y);
        }
        for (const SubpixelPosition offset : patternOf(16, rules)) {
          bool tie = false;
          ASSERT_EQ(shape && shape->covers(x * 256 + offset.x, y * 256 + offset.y, tie), expected)
              << x << "," << y << " width " << width;
        }
      }
    }
  }
}

TEST(BresenhamLine, StripsProducePixelsOnceAndWithoutGaps) {
  Random random(6);
  for (const DiamondExit rule : {DiamondExit::Vulkan, DiamondExit::Direct3D11}) {
    Rules rules = rulesOf("reference");
    rules.choices.diamondExit = rule;
    for (int i = 0; i < 200; ++i) {
      const int32_t step = std::array{128, 64, 1}[static_cast<size_t>(i % 3)];
      const bool leftward = i % 2 == 0;
      std::map<int32_t, int> columns;
      SubpixelPosition a{random.onGrid(step, 2), 4096}, b = a;
      const SubpixelPosition begin = a;
      for (int k = 0; k < 8; ++k, a = b) {
        const int32_t run = random.onGrid(step, 4);
        if (run == 0) continue;
        b = {a.x + run, a.y + random.below(2 * run / step + 1) * step - run};
        LineStyle style = styleOf(Mode::BRESENHAM);
        style.area = {0, 0, 48, 48};
        const LineEnds ends = leftward ? subpixelEnds(b, a) : subpixelEnds(a, b);
        for (const PixelIndex p : pixelsOf(ends, style, rules)) ++columns[p.x];
      }
      if (columns.empty()) continue;
      for (const auto& [column, count] : columns) EXPECT_EQ(count, 1) << "column " << column;
      EXPECT_EQ(columns.rbegin()->first - columns.begin()->first + 1, static_cast<int32_t>(columns.size()));
      EXPECT_LE(std::abs(columns.begin()->first - (begin.x >> 8)), 1);
    }
  }
}

// The start lies in the middle of an edge of the diamond of pixel (2, 2), and the line leaves it there.
TEST(BresenhamLine, VulkanAndDirect3DOwnOppositeEdgesOfTheDiamond) {
  struct Case {
    double x, y, toX, toY;
    bool vulkan, direct3D;
  };
  constexpr std::array kCases{
      Case{2.75, 2.75, 5.5, 3.5, true, true},    // lower right
      Case{2.75, 2.25, 5.5, 1.5, true, false},   // upper right
      Case{2.25, 2.75, 0.5, 3.5, false, true},   // lower left
      Case{2.25, 2.25, 0.5, 1.5, false, false},  // upper left
      Case{2.5, 3.0, 3.25, 5.5, false, true},    // bottom corner, y-major
      Case{3.0, 2.5, 5.5, 2.75, true, false},    // right corner, x-major
      Case{3.0, 2.5, 3.25, 5.5, true, true},     // right corner, y-major
  };
  for (const Case& c : kCases) {
    Rules rules = rulesOf("reference");
    for (const bool vulkan : {true, false}) {
      rules.choices.diamondExit = vulkan ? DiamondExit::Vulkan : DiamondExit::Direct3D11;
      const auto shape = makeLineShape(endsOf(c.x, c.y, c.toX, c.toY), styleOf(Mode::BRESENHAM), rules);
      bool tie = false;
      EXPECT_EQ(shape->covers(2 * 256 + 128, 2 * 256 + 128, tie), vulkan ? c.vulkan : c.direct3D)
          << (vulkan ? "Vulkan " : "Direct3D ") << c.x << "," << c.y;
    }
  }
}

TEST(BresenhamRules, AcceptTheDiamondExitRuleItself) {
  Random random(7);
  const Rules rules = rulesOf("spec");
  LineStyle style = styleOf(Mode::BRESENHAM);
  style.area = {0, 0, 24, 24};
  for (int i = 0; i < 200; ++i) {
    style.width = static_cast<float>(random.below(6) + 1);
    const auto position = [&] { return SubpixelPosition{random.onGrid(1, 24), random.onGrid(1, 24)}; };
    const LineEnds ends = subpixelEnds(position(), position());
    EXPECT_EQ(checkBresenhamPixels(pixelsOf(ends, style, rules), ends, style, rules).fault, BresenhamFault::None);
  }
}

TEST(BresenhamRules, NameWhatIsBroken) {
  const Rules rules = rulesOf("spec");
  LineStyle style = styleOf(Mode::BRESENHAM);
  style.area = {0, 0, 16, 16};
  const LineEnds ends = endsOf(2.5, 5.5, 10.5, 7.5);
  const std::vector<PixelIndex> ideal = pixelsOf(ends, style, rules);
  ASSERT_EQ(ideal.size(), 8U);
  const auto faultOf = [&](const std::vector<PixelIndex>& pixels) {
    return checkBresenhamPixels(pixels, ends, style, rules).fault;
  };
  std::vector<PixelIndex> pixels = ideal;
  for (PixelIndex& p : pixels) ++p.y;
  EXPECT_EQ(faultOf(pixels), BresenhamFault::None) << "one pixel aside is legal";
  for (PixelIndex& p : pixels) ++p.y;
  EXPECT_EQ(faultOf(pixels), BresenhamFault::TooFar);
  pixels = ideal;
  pixels.pop_back();
  EXPECT_EQ(faultOf(pixels), BresenhamFault::None) << "one less is legal";
  pixels.pop_back();
  EXPECT_EQ(faultOf(pixels), BresenhamFault::TooFew);
  pixels = ideal;
  pixels.push_back({10, 7});
  EXPECT_EQ(faultOf(pixels), BresenhamFault::None) << "one more is legal";
  pixels.push_back({11, 7});
  EXPECT_EQ(faultOf(pixels), BresenhamFault::TooMany);
  pixels = ideal;
  pixels.push_back({ideal[3].x, ideal[3].y + 1});
  EXPECT_EQ(faultOf(pixels), BresenhamFault::TwoInAColumn);
  style.width = 3;
  pixels = pixelsOf(ends, style, rules);
  EXPECT_EQ(faultOf(pixels), BresenhamFault::None);
  pixels.erase(pixels.begin());
  EXPECT_EQ(faultOf(pixels), BresenhamFault::WrongWidth);
}

}  // namespace
}  // namespace rasterdiff::rasterizer
