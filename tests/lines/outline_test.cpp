// Rectangles and parallelograms against the oracle, sample by sample.
#include <gtest/gtest.h>

#include "tests/lines/exact_oracle.hpp"
#include "tests/lines/line_support.hpp"

namespace rasterdiff::rasterizer {
namespace {

using namespace rasterdiff::rasterizer::testing;
using Mode = LineRasterizationMode;
using Inside = bool (*)(SubpixelPosition, SubpixelPosition, int64_t, const RationalPoint&);

struct Tally {
  int covered = 0, ties = 0;
};

/// Checks every sample of 8 × 8 pixels, and that rows and columns of the shape hold all that is covered.
void expectLikeOracle(const LineEnds& ends, const LineStyle& style, const Rules& rules, Inside inside, Tally& tally) {
  const std::unique_ptr<Shape> shape = makeLineShape(ends, style, rules);
  const bool point = ends.a.snapped == ends.b.snapped;
  ASSERT_EQ(shape == nullptr, point);
  if (point) return;
  const auto width = static_cast<int64_t>(style.width * 256);
  for (const SubpixelPosition offset : patternOf(style.samples, rules)) {
    for (int32_t y = 0; y < 8; ++y) {
      const RowSpan columns = shape->columns(y);
      for (int32_t x = 0; x < 8; ++x) {
        const SubpixelPosition sample{x * 256 + offset.x, y * 256 + offset.y};
        bool tie = false;
        const bool covered = shape->covers(sample.x, sample.y, tie);
        ASSERT_EQ(covered, inside(ends.a.snapped, ends.b.snapped, width, moved(sample)))
            << "from " << ends.a.snapped.x << "," << ends.a.snapped.y << " to " << ends.b.snapped.x << ","
            << ends.b.snapped.y << " width " << style.width << " sample " << sample.x << "," << sample.y;
        if (covered) {
          ASSERT_TRUE(y >= shape->rows().first && y <= shape->rows().last && x >= columns.begin && x < columns.end);
        }
        ASSERT_EQ(shape->classify(sample.x, sample.y).coverage, covered ? Coverage::In : Coverage::Out);
        tally.covered += covered ? 1 : 0;
        tally.ties += tie ? 1 : 0;
      }
    }
  }
}

Tally randomLines(Mode mode, const Rules& rules, Inside inside, uint32_t seed) {
  constexpr std::array kWidths{1.0F, 2.0F, 3.0F, 1.5F, 2.25F, 7.0F / 128 * 32, 5.0078125F, 16.0F};
  constexpr std::array<uint32_t, 5> kSamples{1, 2, 4, 8, 16};
  Random random(seed);
  Tally tally;
  for (int i = 0; i < 400; ++i) {
    const int32_t step = std::array{128, 128, 64, 1}[static_cast<size_t>(random.below(4))];
    const auto position = [&] { return SubpixelPosition{random.onGrid(step, 8), random.onGrid(step, 8)}; };
    const SubpixelPosition a = position();
    SubpixelPosition b = position();
    if (i % 8 == 1) b.x = a.x;
    if (i % 8 == 2) b.y = a.y;
    if (i % 8 == 3) b.y = a.y + (b.x - a.x);
    if (i % 8 == 4) b.y = a.y - (b.x - a.x);
    if (i % 8 == 5) b = {a.x + 3 * step, a.y + 4 * step};  // corners of even widths are on the grid
    const float width = kWidths[static_cast<size_t>(random.below(kWidths.size()))];
    const uint32_t samples = kSamples[static_cast<size_t>(i) % kSamples.size()];
    expectLikeOracle(subpixelEnds(a, b), styleOf(mode, width, samples), rules, inside, tally);
    if (::testing::Test::HasFatalFailure()) break;
  }
  return tally;
}

TEST(RectangularLine, CoversWhatTheDistanceAndTheProjectionSay) {
  const Tally tally = randomLines(Mode::RECTANGULAR, rulesOf("reference"), inRectangle, 1);
  EXPECT_GT(tally.covered, 15000);
  EXPECT_GT(tally.ties, 400);
}

TEST(RectangularLine, IsWhatDefaultMeansOnAStrictDevice) {
  const Tally tally = randomLines(Mode::DEFAULT, rulesOf("reference"), inRectangle, 2);
  EXPECT_GT(tally.ties, 400);
}

TEST(NonStrictLine, IsTheParallelogramAlongItsMajorAxis) {
  Limits limits = wideLimits();
  limits.strictLines = false;
  const Tally tally = randomLines(Mode::DEFAULT, rulesOf("reference", limits), inParallelogram, 3);
  EXPECT_GT(tally.covered, 15000);
  EXPECT_GT(tally.ties, 400);
}

TEST(RectangularLine, AllWidthsOfTheRangeCoverTheirRows) {
  const Rules rules = rulesOf("reference");
  for (int width = 1; width <= 255; ++width) {
    const auto shape =
        makeLineShape(endsOf(0, 150, 4, 150), styleOf(Mode::RECTANGULAR, static_cast<float>(width)), rules);
    int rows = 0;
    for (int32_t y = 0; y < 300; ++y) {
      bool tie = false;
      rows += shape->covers(2 * 256 + 128, y * 256 + 128, tie) ? 1 : 0;
    }
    EXPECT_EQ(rows, width);
  }
}

TEST(RectangularLine, NeighboursOfOneStraightLineShareNoSampleAndMissNone) {
  const Rules rules = rulesOf("reference");
  const LineStyle style = styleOf(Mode::RECTANGULAR, 3);
  const std::array<SubpixelPosition, 4> points{
      {{128, 128}, {128 + 384, 128 + 256}, {128 + 768, 128 + 512}, {128 + 1536, 128 + 1024}}};
  const auto whole = makeLineShape(subpixelEnds(points[0], points[3]), style, rules);
  std::array<std::unique_ptr<Shape>, 3> parts;
  for (size_t i = 0; i < 3; ++i) parts[i] = makeLineShape(subpixelEnds(points[i], points[i + 1]), style, rules);
  int shared = 0;
  for (int32_t y = 0; y < 8 * 256; y += 64) {
    for (int32_t x = 0; x < 8 * 256; x += 64) {
      int count = 0;
      bool tie = false, anyTie = false;
      for (const auto& part : parts) {
        count += part->covers(x, y, tie) ? 1 : 0;
        anyTie = anyTie || tie;
      }
      shared += anyTie ? 1 : 0;
      EXPECT_EQ(count, whole->covers(x, y, tie) ? 1 : 0) << x << "," << y;
    }
  }
  EXPECT_GT(shared, 10);
}

TEST(RectangularLine, TieMutantsCoverBothEndsOrNone) {
  Rules rules = rulesOf("reference");
  const LineEnds ends = endsOf(1.5, 1, 5.5, 1);
  const LineStyle style = styleOf(Mode::RECTANGULAR, 1);
  EXPECT_EQ(textOf(makeLineShape(ends, style, rules).get(), 8, 2), ".####...\n........\n");
  rules.error = DeliberateError::TiesCoveredByBoth;
  EXPECT_EQ(textOf(makeLineShape(ends, style, rules).get(), 8, 2), ".#####..\n.#####..\n");
  rules.error = DeliberateError::TiesCoveredByNone;
  EXPECT_EQ(textOf(makeLineShape(ends, style, rules).get(), 8, 2), "........\n........\n");
  rules.error = DeliberateError::TieOwnerBottomRight;
  EXPECT_EQ(textOf(makeLineShape(ends, style, rules).get(), 8, 2), "........\n..####..\n");
}

TEST(Lines, FarEndsDoNotOverflow) {
  Limits limits = wideLimits();
  constexpr int32_t kFar = 1 << 28;
  for (const bool strict : {true, false}) {
    limits.strictLines = strict;
    const auto shape = makeLineShape(subpixelEnds({-kFar, -kFar}, {kFar, kFar}), styleOf(Mode::DEFAULT, 2),
                                     rulesOf("reference", limits));
    bool tie = false;
    EXPECT_TRUE(shape->covers(1000 * 256 + 128, 1000 * 256 + 128, tie));
    EXPECT_TRUE(shape->covers(1000 * 256 + 128, 1000 * 256 + 300, tie));
    EXPECT_FALSE(shape->covers(1000 * 256 + 128, 1000 * 256 + 600, tie));
    EXPECT_FALSE(shape->covers(16000 * 256 + 128, 10, tie));
    const RowSpan columns = shape->columns(1000);
    EXPECT_LE(columns.length(), 16);
    EXPECT_TRUE(columns.begin <= 1000 && columns.end > 1000);
  }
}

}  // namespace
}  // namespace rasterdiff::rasterizer
