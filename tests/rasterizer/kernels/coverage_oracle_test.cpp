// The definition of coverage, by pictures.
#include "rasterizer/kernels/coverage_oracle.hpp"

#include <gtest/gtest.h>

#include <string>

#include "rasterizer/kernels/integer_spans.hpp"

namespace rasterdiff::rasterizer {
namespace {

std::string picture(const CoverageMask& mask) {
  std::string text;
  for (uint32_t y = 0; y < mask.height(); ++y, text += '\n')
    for (uint32_t x = 0; x < mask.width(); ++x) text += mask.at(x, y, 0) ? '#' : '.';
  return text;
}

SnappedTriangle halfPixels(int x0, int y0, int x1, int y1, int x2, int y2) {
  return {{SubpixelPosition{x0 * 128, y0 * 128}, {x1 * 128, y1 * 128}, {x2 * 128, y2 * 128}}};
}

std::string drawn(const SnappedTriangle& t) {
  auto mask = CoverageMask::create(4, 4, 1);
  drawCoverageOracle({&t, 1}, *mask);
  return picture(*mask);
}

TEST(CoverageOracle, TopAndLeftEdgesOwnTheirSamplesOthersDoNot) {
  // Right angle at the centre of pixel (0, 0), legs of three pixels: the hypotenuse passes through centres.
  EXPECT_EQ(drawn(halfPixels(1, 1, 7, 1, 1, 7)), "###.\n##..\n#...\n....\n");
  // Right angle at the centre of pixel (3, 3): the hypotenuse is a left edge.
  EXPECT_EQ(drawn(halfPixels(7, 7, 7, 1, 1, 7)), "....\n..#.\n.##.\n....\n");
}

TEST(CoverageOracle, BothWindingsCoverTheSame) {
  EXPECT_EQ(drawn(halfPixels(1, 1, 7, 1, 1, 7)), drawn(halfPixels(1, 1, 1, 7, 7, 1)));
}

TEST(CoverageOracle, ZeroAreaCoversNothing) { EXPECT_EQ(drawn(halfPixels(1, 1, 3, 3, 7, 7)), "....\n....\n....\n....\n"); }

TEST(CoverageMask, RefusesImpossibleTargets) {
  EXPECT_FALSE(CoverageMask::create(0, 4, 1).has_value());
  EXPECT_FALSE(CoverageMask::create(4, 40000, 1).has_value());
  EXPECT_FALSE(CoverageMask::create(4, 4, 3).has_value());
}

TEST(IntegerSpans, TheWidestTriangleThatInt32HoldsIsExact) {
  constexpr int32_t kMost = 2147483647, kLeast = -2147483647 - 1;
  const SnappedTriangle t{{SubpixelPosition{kLeast, kLeast}, {kMost, kLeast}, {kLeast, kMost}}};
  // Its hypotenuse x + y = -1 passes just above the target's corner.
  EXPECT_GE(integerSpan(t, 0, {8, 8}, 64).begin, integerSpan(t, 0, {8, 8}, 64).end);
  const SnappedTriangle other{{SubpixelPosition{kMost, kMost}, {kMost, kLeast}, {kLeast, kMost}}};
  EXPECT_EQ(integerSpan(other, 0, {8, 8}, 64).begin, 0);
  EXPECT_EQ(integerSpan(other, 0, {8, 8}, 64).end, 64);
}

}  // namespace
}  // namespace rasterdiff::rasterizer
