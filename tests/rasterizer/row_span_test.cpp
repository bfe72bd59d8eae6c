#include "rasterizer/row_span.hpp"

#include <gtest/gtest.h>

#include <random>

namespace rasterdiff::rasterizer {
namespace {

TEST(RowSpan, IsTheSetOfPixelsThatTheEdgeFunctionsCover) {
  std::mt19937 random(3);
  int64_t ties = 0;
  for (int i = 0; i < 20000; ++i) {
    const int unit = i % 3 == 0 ? 128 : i % 3 == 1 ? 16 : 1;  // coarse grids make ties
    const auto coordinate = [&] { return static_cast<int32_t>(random() % (12 * 256 / static_cast<unsigned>(unit))) * unit - 512; };
    std::array<SubpixelPosition, 3> v{{{coordinate(), coordinate()}, {coordinate(), coordinate()}, {coordinate(), coordinate()}}};
    const int64_t area = doubleArea(v[0], v[1], v[2]);
    if (area == 0) continue;
    if (area < 0) std::swap(v[1], v[2]);
    const std::array<EdgeFunction, 3> edges{edgeFunction(v[0], v[1], TieOwner::TopLeft), edgeFunction(v[1], v[2], TieOwner::TopLeft),
                                            edgeFunction(v[2], v[0], TieOwner::TopLeft)};
    for (int y = -2; y < 10; ++y) {
      const RowSpan limits{-1, 9};
      const RowCoverage row = coverRow(edges, 128, y * 256 + 128, limits);
      int32_t expectedTies = 0;
      for (int x = limits.begin; x < limits.end; ++x) {
        bool covered = true, closed = true, onEdge = false;
        for (const EdgeFunction& edge : edges) {
          covered = covered && edge.covers(x * 256 + 128, y * 256 + 128);
          const int64_t value = edge.at(x * 256 + 128, y * 256 + 128);
          closed = closed && value >= 0;
          onEdge = onEdge || value == 0;
        }
        if (closed && onEdge) ++expectedTies;
        EXPECT_EQ(covered, x >= row.covered.begin && x < row.covered.end) << "triangle " << i << " at " << x << ", " << y;
      }
      EXPECT_EQ(row.ties, expectedTies);
      ties += row.ties;
    }
  }
  EXPECT_GT(ties, 1000);
}

}  // namespace
}  // namespace rasterdiff::rasterizer
