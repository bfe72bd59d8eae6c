// The lecture's lines: right where the lecture promises it, and wrong in the ways that docs/methods.md lists.
#include "rasterizer/methods/line_methods.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "rasterizer/methods/method_inputs.hpp"

namespace rasterdiff::rasterizer {
namespace {

SubpixelPosition centre(int32_t x, int32_t y) { return {x * 256 + 128, y * 256 + 128}; }

std::set<PixelIndex> asSet(const std::vector<PixelIndex>& pixels) { return {pixels.begin(), pixels.end()}; }

TEST(LineMethods, NamesAreUnique) {
  std::set<std::string_view> names;
  for (const LineMethod& method : lineMethods()) names.insert(method.name);
  EXPECT_EQ(names.size(), lineMethods().size());
  EXPECT_TRUE(names.contains("diamond-exit-vulkan"));
}

TEST(LineMethods, BetweenCentresTheLectureDrawsTheExactPixelsAndTheLastOne) {
  // No slope with an even numerator over an even extent: then no crossing lies between two rows.
  for (const PixelIndex end : {PixelIndex{7, 3}, {3, 7}, {-7, 2}, {5, -3}, {-3, -5}, {0, 6}, {6, 0}, {5, 5}, {-5, 5}}) {
    std::set<PixelIndex> expected = asSet(drawLineDiamondVulkan(centre(0, 0), centre(end.x, end.y)));
    expected.insert(end);
    EXPECT_EQ(asSet(drawLineFourOctants(centre(0, 0), centre(end.x, end.y))), expected) << end.x << ", " << end.y;
    EXPECT_EQ(asSet(drawLineLongAxis(centre(0, 0), centre(end.x, end.y))), expected) << end.x << ", " << end.y;
  }
}

TEST(LineMethods, TrimmedLinesLoseTheFirstPixelToo) {
  std::set<PixelIndex> expected = asSet(drawLineDiamondVulkan(centre(0, 0), centre(7, 3)));
  expected.erase({0, 0});
  EXPECT_EQ(asSet(drawLineLongAxisTrimmed(centre(0, 0), centre(7, 3))), expected);
}

TEST(LineMethods, TheLectureIgnoresDirection) {
  EXPECT_EQ(drawLineLongAxis(centre(0, 0), centre(7, 3)), drawLineLongAxis(centre(7, 3), centre(0, 0)));
  EXPECT_NE(asSet(drawLineDiamondVulkan(centre(0, 0), centre(7, 3))),
            asSet(drawLineDiamondVulkan(centre(7, 3), centre(0, 0))));
}

TEST(LineMethods, NoMethodFailsOnAnyPairOfEnds) {
  Prng prng(3);
  for (int i = 0; i < 2000; ++i) {
    const LineEnds ends = hardLine(prng);
    for (const LineMethod& method : lineMethods()) {
      EXPECT_LE(method.draw(ends.a, ends.b).size(), 34u) << method.name;  // 32 pixels, and one more at either end
      EXPECT_LE(method.draw(ends.a, ends.a).size(), 1u) << method.name;
    }
  }
}

}  // namespace
}  // namespace rasterdiff::rasterizer
