// Widths that a device draws, and the parameter along a line.
#include <gtest/gtest.h>

#include "rasterizer/lines/line_parameter.hpp"
#include "rasterizer/lines/line_width.hpp"
#include "tests/lines/line_support.hpp"

namespace rasterdiff::rasterizer {
namespace {

using namespace rasterdiff::rasterizer::testing;
using Mode = LineRasterizationMode;

TEST(LineWidth, IsTheNearestMultipleOfTheGranularity) {
  const Limits limits = wideLimits();
  EXPECT_EQ(lineWidth(1, limits).nominal, 256);
  EXPECT_EQ(lineWidth(255, limits).nominal, 255 * 256);
  EXPECT_EQ(lineWidth(0.25F, limits).nominal, 256);
  EXPECT_EQ(lineWidth(1000, limits).nominal, 255 * 256);
  EXPECT_EQ(lineWidth(2 + 0.9F / 128, limits).nominal, 2 * 256 + 2);
  const LineWidth between = lineWidth(1.3F, limits);
  EXPECT_EQ(between.nominal, 332);  // 1.296875
  EXPECT_LE(between.narrowest, 332);
  EXPECT_GE(between.widest, 333);
  const LineWidth exact = lineWidth(1.5F, limits);
  EXPECT_EQ(exact.narrowest, exact.widest);
  Limits narrow;
  EXPECT_EQ(lineWidth(5, narrow).nominal, 256);
  EXPECT_EQ(lineWidth(std::numeric_limits<float>::quiet_NaN(), limits).nominal, 256);
}

TEST(BresenhamWidth, IsAWholeNumberOfPixelsAndAtLeastOne) {
  const Limits limits = wideLimits();
  EXPECT_EQ(bresenhamWidth(0.2F, limits).nominal, 1);
  EXPECT_EQ(bresenhamWidth(2.49F, limits).nominal, 2);
  EXPECT_EQ(bresenhamWidth(2.51F, limits).nominal, 3);
  EXPECT_EQ(bresenhamWidth(300, limits).nominal, 255);
  EXPECT_EQ(bresenhamWidth(2.5F, limits).nominal, 3);
  EXPECT_EQ(bresenhamWidth(2.5F, limits).other, 2);
  EXPECT_EQ(bresenhamWidth(2.4F, limits).other, 2);
}

TEST(LineParameter, RunsFromZeroToOneBetweenTheEnds) {
  Random random(21);
  Limits nonStrict = wideLimits();
  nonStrict.strictLines = false;
  for (int i = 0; i < 300; ++i) {
    const double ax = random.onGrid(1, 50) / 256.0, ay = random.onGrid(1, 50) / 256.0;
    const double bx = random.onGrid(1, 50) / 256.0, by = random.onGrid(1, 50) / 256.0;
    if (ax == bx && ay == by) continue;
    const LineEnds ends = endsOf(ax, ay, bx, by);
    const double dx = bx - ax, dy = by - ay;
    for (const Mode mode : {Mode::RECTANGULAR, Mode::BRESENHAM, Mode::DEFAULT}) {
      const LineParameter t =
          lineParameter(ends, styleOf(mode, 4), rulesOf("reference", mode == Mode::DEFAULT ? nonStrict : wideLimits()));
      EXPECT_NEAR(t.at(ax, ay), 0, 1e-9);
      EXPECT_NEAR(t.at(bx, by), 1, 1e-9);
      const LineParameter strict = lineParameter(ends, styleOf(Mode::RECTANGULAR, 4), rulesOf("reference"));
      EXPECT_NEAR(strict.at(ax - dy, ay + dx), 0, 1e-9) << "perpendicular to the line";
      EXPECT_EQ(strict.alternative, 0);
      // Inside the line the two ways to interpolate differ by no more than is said.
      const bool xMajor = std::fabs(dx) >= std::fabs(dy);
      const double x = ax + 0.3 * dx + (xMajor ? 0 : 1.9), y = ay + 0.3 * dy + (xMajor ? 1.9 : 0);
      if (mode != Mode::RECTANGULAR) {
        EXPECT_LE(std::fabs(strict.at(x, y) - t.at(x, y)), t.alternative);
        EXPECT_NEAR(xMajor ? t.dy : t.dx, 0, 0) << "one value a column or row";
      }
    }
  }
}

TEST(LineParameter, IsZeroForALineWithoutLength) {
  const LineParameter t = lineParameter(endsOf(3, 4, 3, 4), styleOf(Mode::RECTANGULAR), rulesOf("reference"));
  EXPECT_EQ(t.at(100, 100), 0);
}

}  // namespace
}  // namespace rasterdiff::rasterizer
