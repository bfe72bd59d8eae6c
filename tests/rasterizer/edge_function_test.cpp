#include "rasterizer/edge_function.hpp"

#include <gtest/gtest.h>

#include "tests/support/int128.hpp"

namespace rasterdiff::rasterizer {
namespace {

using testing::Int128;

constexpr SubpixelPosition px(int x, int y) { return {x * kSubpixelOne, y * kSubpixelOne}; }

TEST(EdgeFunction, IsTwiceTheAreaAtTheThirdVertex) {
  const EdgeFunction edge = edgeFunction(px(0, 0), px(4, 0), TieOwner::TopLeft);
  EXPECT_EQ(edge.at(0, 3 * kSubpixelOne), doubleArea(px(0, 0), px(4, 0), px(0, 3)));
  EXPECT_EQ(doubleArea(px(0, 0), px(4, 0), px(0, 3)), 12 * kSubpixelOne * kSubpixelOne);
}

TEST(EdgeFunction, SampleOnLeftEdgeIsCovered) {
  const EdgeFunction upward = edgeFunction(px(1, 4), px(1, 0), TieOwner::TopLeft);  // interior to the right
  EXPECT_TRUE(upward.covers(kSubpixelOne, 2 * kSubpixelOne));
}

TEST(EdgeFunction, SampleOnRightEdgeIsNotCovered) {
  const EdgeFunction downward = edgeFunction(px(1, 0), px(1, 4), TieOwner::TopLeft);
  EXPECT_FALSE(downward.covers(kSubpixelOne, 2 * kSubpixelOne));
}

TEST(EdgeFunction, SampleOnTopEdgeIsCoveredAndOnBottomEdgeIsNot) {
  EXPECT_TRUE(edgeFunction(px(0, 1), px(4, 1), TieOwner::TopLeft).covers(512, kSubpixelOne));
  EXPECT_FALSE(edgeFunction(px(4, 1), px(0, 1), TieOwner::TopLeft).covers(512, kSubpixelOne));
}

TEST(EdgeFunction, EveryOwnerGivesEachDirectionToExactlyOneSide) {
  for (const TieOwner owner : {TieOwner::TopLeft, TieOwner::TopRight, TieOwner::BottomLeft, TieOwner::BottomRight}) {
    for (int dx = -2; dx <= 2; ++dx) {
      for (int dy = -2; dy <= 2; ++dy) {
        if (dx == 0 && dy == 0) continue;
        EXPECT_NE(ownsTies(owner, dx, dy), ownsTies(owner, -dx, -dy)) << dx << ", " << dy;
      }
    }
  }
}

TEST(EdgeFunction, DoesNotOverflowAtTheGuardBand) {
  constexpr int32_t kFar = 1 << 28;  // 2^20 pixels
  const EdgeFunction edge = edgeFunction({-kFar, -kFar}, {kFar, kFar - 1}, TieOwner::TopLeft);
  const Int128 expected = static_cast<Int128>(edge.dx) * (kFar - edge.ay) - static_cast<Int128>(edge.dy) * (-kFar - edge.ax);
  EXPECT_TRUE(static_cast<Int128>(edge.at(-kFar, kFar)) == expected);
}

}  // namespace
}  // namespace rasterdiff::rasterizer
