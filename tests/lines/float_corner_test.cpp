// Lines as lavapipe 22.3.6 draws them. The masks were read back from the driver.
#include <gtest/gtest.h>

#include "rasterizer/lines/float_corners.hpp"
#include "rasterizer/lines/tile_binning.hpp"
#include "tests/lines/line_support.hpp"

namespace rasterdiff::rasterizer {
namespace {

using namespace rasterdiff::rasterizer::testing;
using Mode = LineRasterizationMode;

TEST(FloatCorners, HalvesAreRoundedAwayFromZero) {
  // 1/512 pixel is half a subpixel; snapping to nearest even would give 0 and 2.
  const auto outline = rectangularOutline({1.0F / 512, 3.0F / 512}, {9, 3.0F / 512}, 2, 0);
  ASSERT_TRUE(outline);
  EXPECT_EQ((*outline)[0].x, 1);
  EXPECT_EQ(((*outline)[0].y + (*outline)[3].y) / 2, 2);
  const auto below = rectangularOutline({-1.0F / 512, 0}, {9, 0}, 2, 0);
  EXPECT_EQ((*below)[0].x, -1);
}

TEST(FloatCorners, NoLengthNoOutline) {
  EXPECT_FALSE(rectangularOutline({3, 4}, {3, 4}, 1, 0.5F));
  EXPECT_FALSE(bresenhamOutline({3, 4}, {3, 4}, 1, 0.5F));
}

TEST(LavapipeLine, RectangularAtOneSample) {
  const auto shape = makeLineShape(endsOf(2.3, 1.2, 13.7, 9.6), styleOf(Mode::RECTANGULAR), rulesOf("lavapipe"));
  EXPECT_EQ(textOf(shape.get(), 16, 11),
            "................\n"
            "..##............\n"
            "...##...........\n"
            ".....#..........\n"
            "......##........\n"
            ".......##.......\n"
            ".........#......\n"
            "..........##....\n"
            "...........##...\n"
            ".............#..\n"
            "................\n");
}

TEST(LavapipeLine, RectangularAtFourSamples) {
  const Rules rules = rulesOf("lavapipe");
  const auto shape = makeLineShape(endsOf(2.3, 1.2, 13.7, 9.6), styleOf(Mode::RECTANGULAR, 1, 4), rules);
  EXPECT_EQ(sampleText(shape.get(), 16, 11, rules),
            "..8.............\n"
            "..fc............\n"
            "...3d...........\n"
            "....3fc.........\n"
            ".....2fc........\n"
            ".......3d4......\n"
            "........3fc.....\n"
            ".........2bc....\n"
            "...........3f4..\n"
            "............35..\n"
            "................\n");
}

TEST(LavapipeLine, BresenhamCoversAllSamplesOfItsPixels) {
  const Rules rules = rulesOf("lavapipe");
  const auto shape = makeLineShape(endsOf(2.3, 1.2, 13.7, 9.6), styleOf(Mode::BRESENHAM, 1, 4), rules);
  EXPECT_EQ(sampleText(shape.get(), 16, 11, rules),
            "................\n"
            "..f.............\n"
            "...ff...........\n"
            ".....f..........\n"
            "......f.........\n"
            ".......ff.......\n"
            ".........f......\n"
            "..........ff....\n"
            "............f...\n"
            "................\n"
            "................\n");
}

TEST(LavapipeLine, WideBresenham) {
  const auto shape = makeLineShape(endsOf(2.3, 1.2, 13.7, 9.6), styleOf(Mode::BRESENHAM, 5), rulesOf("lavapipe"));
  EXPECT_EQ(textOf(shape.get(), 16, 12),
            "..###...........\n"
            "..####..........\n"
            "..#####.........\n"
            "..#######.......\n"
            "...#######......\n"
            ".....#######....\n"
            "......#######...\n"
            ".......######...\n"
            ".........####...\n"
            "..........###...\n"
            "............#...\n"
            "................\n");
}

// The reference covers two samples a row here; the driver's bounding box of the line is empty.
TEST(LavapipeLine, FourSamplesLoseALineThatStaysInOneColumn) {
  const Rules rules = rulesOf("lavapipe");
  const LineEnds ends = endsOf(7.5, 1, 7.5, 14);
  const LineStyle style = styleOf(Mode::RECTANGULAR, 0.5F, 4);
  EXPECT_EQ(sampleText(makeLineShape(ends, style, rules).get(), 16, 2, rules), "................\n................\n");
  Limits limits = wideLimits();
  limits.lineWidthMin = 0.5F;
  const auto expected = makeLineShape(ends, style, rulesOf("reference", limits));
  EXPECT_EQ(sampleText(expected.get(), 16, 2, rules), "................\n.......9........\n");
}

// A multisampled line loses the part before its first pixel corner where that is in another tile of 64 pixels.
TEST(LavapipeLine, FourSamplesLoseTheColumnBeforeATile) {
  const Rules rules = rulesOf("lavapipe");
  const LineEnds ends = endsOf(63.25, 5.5, 70, 5.5);
  const LineStyle style = styleOf(Mode::RECTANGULAR, 1, 4);
  const auto driver = makeLineShape(ends, style, rules), right = makeLineShape(ends, style, rulesOf("reference"));
  const auto covered = [&](const Shape& shape, int32_t x) {
    bool tie = false;
    return shape.covers(x * 256 + 14 * 16, 5 * 256 + 6 * 16, tie);
  };
  EXPECT_TRUE(covered(*right, 63));
  EXPECT_FALSE(covered(*driver, 63));
  EXPECT_TRUE(covered(*driver, 64));
}

TEST(TileBinning, WholeTilesOfTheBoxOfPixelCorners) {
  const auto binned = [](int32_t left, int32_t top, int32_t right, int32_t bottom, PixelArea region) {
    return binnedArea({{{left, top}, {right, top}, {right, bottom}, {left, bottom}}}, region);
  };
  const PixelArea target{0, 0, 128, 128};
  const PixelArea one = binned(10 * 256, 10 * 256, 20 * 256, 20 * 256, target);
  EXPECT_TRUE(one.left == 0 && one.top == 0 && one.right == 64 && one.bottom == 64);
  const PixelArea two = binned(63 * 256 + 1, 63 * 256, 70 * 256, 64 * 256, target);
  EXPECT_TRUE(two.left == 64 && two.right == 128 && two.top == 0 && two.bottom == 64);
  EXPECT_EQ(binned(10, 10, 200, 2560, target).right, 0) << "no corner between 10/256 and 200/256";
  EXPECT_EQ(binned(10 * 256, 0, 20 * 256, 2560, {30, 0, 60, 60}).right, 0) << "outside the scissor";
}

TEST(LavapipeLine, StippleIsCutInFloatsAndStartsAnewInStrips) {
  const Rules rules = rulesOf("lavapipe");
  LineStyle style = styleOf(Mode::RECTANGULAR);
  style.stipple.enabled = true;
  style.stipple.pattern = 0x0F0F;
  const LineEnds ends = endsOf(1, 1.5, 21.5, 1.5);
  EXPECT_EQ(textOf(makeLineShape(ends, style, rules).get(), 24, 2),
            "........................\n.####....####....####...\n");
  EXPECT_EQ(stippleAfter(ends, style, rules).s, 0U);
  style.ofPolygon = true;
  EXPECT_EQ(stippleAfter(ends, style, rules).s, 21U);
}

}  // namespace
}  // namespace rasterdiff::rasterizer
