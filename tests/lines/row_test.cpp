// A line's rows at once are what its samples are one by one, and what is one verdict a pixel is that at each of its samples.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/lines/line_support.hpp"

namespace rasterdiff::rasterizer {
namespace {

using namespace rasterdiff::rasterizer::testing;
using Mode = LineRasterizationMode;

constexpr int32_t kSide = 40;  // pixels

/// Random lines on a coarse grid, where samples lie on edges; some are horizontal, vertical, or have their ends outside.
class Lines {
 public:
  LineEnds next() {
    const double step = chance() ? 1.0 / 256 : 0.5;
    const double ax = place(step), ay = place(step);
    const auto kind = random_() % 4;
    return endsOf(ax, ay, kind == 0 ? ax : place(step), kind == 1 ? ay : place(step));
  }
  float width() { return chance() ? static_cast<float>(1 + random_() % 40) : 1 + static_cast<float>(random_() % 256) / 8; }
  PixelArea area() {
    if (random_() % 3 == 0) return {0, 0, kSide, kSide};
    const auto left = static_cast<int32_t>(random_() % 20), top = static_cast<int32_t>(random_() % 20);
    return {left, top, left + 1 + static_cast<int32_t>(random_() % 20), top + 1 + static_cast<int32_t>(random_() % 20)};
  }
  bool chance() { return random_() % 2 == 0; }

 private:
  double place(double step) { return std::floor((static_cast<double>(random_() % (60 * 256)) / 256 - 10) / step) * step; }

  std::mt19937 random_{7};
};

/// Samples of a row by `covers`.
RowCoverage oneByOne(const Shape& shape, int32_t y, SubpixelPosition offset, RowSpan columns, bool& oneSpan) {
  RowCoverage row{{columns.end, columns.begin}, 0};
  int32_t covered = 0;
  for (int32_t x = columns.begin; x < columns.end; ++x) {
    bool tie = false;
    if (shape.covers(x * 256 + offset.x, y * 256 + offset.y, tie)) {
      row.covered = {std::min(row.covered.begin, x), std::max(row.covered.end, x + 1)};
      ++covered;
    }
    row.ties += tie ? 1 : 0;
  }
  oneSpan = covered == row.covered.length();
  return row;
}

TEST(LineRow, IsWhatItsSamplesAreOneByOne) {
  Lines lines;
  const Rules rules = rulesOf("lavapipe");
  size_t covered = 0, ties = 0, cut = 0;
  for (int k = 0; k < 1500; ++k) {
    const uint32_t samples = lines.chance() ? 1 : 4;
    LineStyle style = styleOf(lines.chance() ? Mode::RECTANGULAR : Mode::BRESENHAM, lines.width(), samples);
    style.area = lines.area();
    style.leaky = lines.chance();
    const auto shape = makeLineShape(lines.next(), style, rules);
    if (!shape) continue;
    const std::vector<SubpixelPosition> pattern = *samplePattern(samples, rules);
    for (const SubpixelPosition offset : pattern)
      for (int32_t y = 0; y < kSide; ++y) {
        RowSpan columns = shape->columns(y);
        columns = {std::max(columns.begin, 0), std::min(columns.end, kSide)};
        if (columns.empty()) continue;
        const auto row = shape->coverRow(y, offset, columns);
        ASSERT_TRUE(row);
        bool oneSpan = false;
        const RowCoverage expected = oneByOne(*shape, y, offset, columns, oneSpan);
        ASSERT_TRUE(oneSpan);
        ASSERT_EQ(row->covered.empty(), expected.covered.empty()) << k << " row " << y;
        ASSERT_EQ(row->ties, expected.ties) << k << " row " << y;
        if (expected.covered.empty()) continue;
        ASSERT_EQ(row->covered.begin, expected.covered.begin) << k << " row " << y;
        ASSERT_EQ(row->covered.end, expected.covered.end) << k << " row " << y;
        ++covered, ties += static_cast<size_t>(row->ties);
        if (row->covered.begin == style.area.left || row->covered.end == style.area.right) ++cut;
      }
  }
  EXPECT_GT(covered, 10'000u);
  EXPECT_GT(ties, 1'000u);
  EXPECT_GT(cut, 1'000u);
}

TEST(LineRow, OfDashesThereIsNone) {
  LineStyle style = styleOf(Mode::RECTANGULAR, 3);
  style.stipple.enabled = true, style.stipple.pattern = 0x0F0F;
  const auto shape = makeLineShape(endsOf(1, 4, 39, 4.5), style, rulesOf("lavapipe"));
  ASSERT_TRUE(shape);
  EXPECT_FALSE(shape->coverRow(4, {128, 128}, {0, kSide}));
}

TEST(LineRow, OneVerdictAPixelIsTheOneOfEachSample) {
  Lines lines;
  Limits limits = wideLimits();
  limits.smoothLines = true;
  const Rules rules = Rules::specification(limits);
  const std::vector<SubpixelPosition> pattern = *samplePattern(4, rules);
  size_t smooth = 0, others = 0, free = 0;
  for (int k = 0; k < 200; ++k) {
    const Mode mode = lines.chance() ? Mode::RECTANGULAR_SMOOTH : lines.chance() ? Mode::RECTANGULAR : Mode::BRESENHAM;
    const auto shape = makeLineShape(lines.next(), styleOf(mode, lines.width(), 4), rules);
    if (!shape) continue;
    (shape->classifiesPixels() ? smooth : others) += 1;
    ASSERT_EQ(shape->classifiesPixels(), mode == Mode::RECTANGULAR_SMOOTH);
    if (!shape->classifiesPixels()) continue;
    for (int32_t y = 0; y < kSide; ++y)
      for (int32_t x = 0; x < kSide; ++x) {
        const Coverage first = shape->classify(x * 256 + pattern[0].x, y * 256 + pattern[0].y).coverage;
        free += first == Coverage::Either ? 1 : 0;
        for (const SubpixelPosition offset : pattern) ASSERT_EQ(shape->classify(x * 256 + offset.x, y * 256 + offset.y).coverage, first);
      }
  }
  EXPECT_GT(smooth, 50u);
  EXPECT_GT(others, 50u);
  EXPECT_GT(free, 1'000u);
}

}  // namespace
}  // namespace rasterdiff::rasterizer
