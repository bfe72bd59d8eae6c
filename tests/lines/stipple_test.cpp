// Stipple patterns along Bresenham and rectangular lines, over strips, and what remains free.
#include <gtest/gtest.h>

#include "tests/lines/line_support.hpp"

namespace rasterdiff::rasterizer {
namespace {

using namespace rasterdiff::rasterizer::testing;
using Mode = LineRasterizationMode;

LineStyle stippled(Mode mode, uint16_t pattern, uint32_t factor = 1) {
  LineStyle style = styleOf(mode);
  style.stipple.enabled = true;
  style.stipple.pattern = pattern;
  style.stipple.factor = factor;
  return style;
}

/// Along the first row, over the pixels from..to - 1 (or to..from - 1 backwards). Bresenham lines run between centres.
LineEnds level(double from, double to, const LineStyle& style) {
  const double shift = style.mode == Mode::BRESENHAM ? (to > from ? 0.5 : -0.5) : 0;
  return endsOf(from + shift, 0.5, to + shift, 0.5);
}

std::string drawn(double from, double to, const LineStyle& style, const Rules& rules, int32_t width) {
  return textOf(makeLineShape(level(from, to, style), style, rules).get(), width, 1);
}

TEST(Stipple, BitZeroComesFirstAndEachBitLastsItsFactor) {
  const Rules rules = rulesOf("reference");
  for (const Mode mode : {Mode::BRESENHAM, Mode::RECTANGULAR}) {
    EXPECT_EQ(drawn(0, 18, stippled(mode, 0x0001), rules, 18), "#...............#.\n");
    EXPECT_EQ(drawn(0, 18, stippled(mode, 0x8000), rules, 18), "...............#..\n");
    EXPECT_EQ(drawn(0, 18, stippled(mode, 0x0005, 3), rules, 18), "###...###.........\n");
    EXPECT_EQ(drawn(18, 0, stippled(mode, 0x0005, 3), rules, 18), ".........###...###\n")
        << "from the start, wherever it is";
    EXPECT_EQ(drawn(0, 18, stippled(mode, 0x0000), rules, 18), "..................\n");
    EXPECT_EQ(drawn(0, 18, stippled(mode, 0xFFFF, 256), rules, 18), "##################\n");
  }
}

TEST(Stipple, TheCounterGoesOnAlongAStrip) {
  const Rules rules = rulesOf("reference");
  for (const Mode mode : {Mode::BRESENHAM, Mode::RECTANGULAR}) {
    LineStyle style = stippled(mode, 0x00FF);
    EXPECT_EQ(stippleAfter(level(0, 5, style), style, rules).s, 5U);
    style.stipple.start = stippleAfter(level(0, 5, style), style, rules);
    EXPECT_EQ(drawn(5, 18, style, rules, 18), ".....###........##\n");
    style.stipple.start = stippleAfter(level(5, 18, style), style, rules);
    EXPECT_EQ(style.stipple.start.s, 18U);
  }
}

// https://github.com/KhronosGroup/VK-GL-CTS/issues/279: the remainder of 10.5 pixels may be carried, or not.
TEST(Stipple, SegmentsOfTenAndAHalfPixelsMayCarryTheRemainder) {
  const Rules rules = rulesOf("spec");
  LineStyle style = stippled(Mode::RECTANGULAR, 0x0F0F);
  const LineEnds first = endsOf(0, 0.5, 10.5, 0.5), second = endsOf(10.5, 0.5, 21, 0.5);
  style.stipple.start = stippleAfter(first, style, rules);
  EXPECT_EQ(style.stipple.start.s, 11U);
  EXPECT_EQ(style.stipple.start.lowest, 11U);
  EXPECT_EQ(style.stipple.start.highest, 11U);
  EXPECT_NEAR(style.stipple.start.carried, 10.5 * 256, style.stipple.start.uncertainty);
  // Without carry the second segment starts with bit 11; with carry the rest of bit 10 comes first.
  const auto shape = makeLineShape(second, style, rules);
  const auto at = [&](double x) { return shape->classify(static_cast<int64_t>(x * 256), 100); };
  EXPECT_EQ(at(10.75).coverage, Coverage::In) << "bit 10 or 11: both draw";
  EXPECT_EQ(at(11.75).coverage, Coverage::Either) << "bit 12 or 11";
  EXPECT_EQ(at(11.75).freedom, Freedom::StippleCarry);
  EXPECT_EQ(at(13.25).coverage, Coverage::Out) << "bit 13 or 12: none draws";
}

TEST(Stipple, AClippedLineLeavesTheCounterFree) {
  const Rules rules = rulesOf("spec");
  LineStyle style = stippled(Mode::RECTANGULAR, 0x00FF);
  LineEnds ends = endsOf(0, 0.5, 8, 0.5);
  ends.b.made = true;
  style.stipple.start = stippleAfter(ends, style, rules);
  EXPECT_TRUE(style.stipple.start.free);
  const auto shape = makeLineShape(endsOf(8, 0.5, 12, 0.5), style, rules);
  const BandVerdict verdict = shape->classify(10 * 256, 128);
  EXPECT_EQ(verdict.coverage, Coverage::Either);
  EXPECT_EQ(verdict.freedom, Freedom::LineClip);
}

TEST(Stipple, UnitsOfASlantedLineAreMeasuredAlongIt) {
  // 3-4-5: units end at multiples of (0.6, 0.8).
  const Rules rules = rulesOf("reference");
  const auto shape = makeLineShape(endsOf(0, 0, 6, 8), stippled(Mode::RECTANGULAR, 0x5555), rules);
  for (int unit = 0; unit < 10; ++unit) {
    for (const double t : {0.02, 0.5, 0.98}) {
      bool tie = false;
      const bool covered = shape->covers(std::lround((unit + t) * 0.6 * 256), std::lround((unit + t) * 0.8 * 256), tie);
      EXPECT_EQ(covered, unit % 2 == 0) << unit + t;
    }
  }
}

TEST(Stipple, BresenhamGapsFarFromTheirEndsAreCertain) {
  const Rules rules = rulesOf("spec");
  const auto shape = makeLineShape(endsOf(0.5, 0.5, 100.5, 0.5), stippled(Mode::BRESENHAM, 0x5555, 20), rules);
  EXPECT_EQ(shape->classify(10 * 256 + 128, 128).coverage, Coverage::Either);
  EXPECT_EQ(shape->classify(30 * 256 + 128, 128).coverage, Coverage::Out);
  EXPECT_EQ(shape->classify(22 * 256 + 128, 128).coverage, Coverage::Either) << "near the end of a dash";
}

}  // namespace
}  // namespace rasterdiff::rasterizer
