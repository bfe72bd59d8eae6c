// Runs, ties and ends of rows counted in vectors are those that integers count.
#include "rasterizer/kernels/row_tally.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "every_target.hpp"
#include "kernel_families.hpp"

namespace rasterdiff::rasterizer {
namespace {

int64_t doubleAreaOf(const SnappedTriangle& t) {
  return (int64_t{t.v[1].x} - t.v[0].x) * (int64_t{t.v[2].y} - t.v[0].y) - (int64_t{t.v[1].y} - t.v[0].y) * (int64_t{t.v[2].x} - t.v[0].x);
}

SnappedTriangle halfPixels(int32_t ax, int32_t ay, int32_t bx, int32_t by, int32_t cx, int32_t cy) {
  return {{{{ax * 128, ay * 128}, {bx * 128, by * 128}, {cx * 128, cy * 128}}}};
}

TEST(RowTally, CountsInsideTiesAndCutQuads) {
  const std::array<SubpixelPosition, 1> centre{{{128, 128}}};
  // A square's upper left half between the centres of pixels 0 and 4: ties on all of its edges, of which top and left are owned.
  const RowTally tally = tallyRowsExactly(halfPixels(1, 1, 9, 1, 1, 9), {8, 0, 8, centre});
  EXPECT_EQ(tally.inside, 4U + 3U + 2U + 1U);
  EXPECT_EQ(tally.ties, 5U + 2U + 2U + 2U + 1U);
  EXPECT_EQ(tally.cutQuads, 2U) << "rows of 3 and of 1 pixels";
  EXPECT_EQ(tally.partlyCovered, 0U);
}

TEST(RowTally, OfVectorsIsThatOfIntegersOnHardTriangles) {
  const std::array<SubpixelPosition, 1> centre{{{128, 128}}};
  const std::array<SubpixelPosition, 4> four{{{96, 32}, {224, 96}, {32, 160}, {160, 224}}};
  uint64_t ties = 0, partly = 0;
  for (const auto& family : testing::hardFamilies(131, 77)) {
    Prng random(3);
    std::vector<SnappedTriangle> triangles;
    for (int k = 0; k < 400; ++k) {  // some families have triangles without area
      SnappedTriangle t = family.make(random);
      for (SubpixelPosition& v : t.v) v = {std::clamp(v.x, -(1 << 29), 1 << 29), std::clamp(v.y, -(1 << 29), 1 << 29)};
      if (doubleAreaOf(t) < 0) std::swap(t.v[1], t.v[2]);
      if (doubleAreaOf(t) > 0) triangles.push_back(t);
    }
    for (const std::span<const SubpixelPosition> pattern : {std::span<const SubpixelPosition>(centre), std::span<const SubpixelPosition>(four)}) {
      const TallyArea area{131, 8, 77, pattern};
      RowTally expected;
      for (const SnappedTriangle& t : triangles) expected += tallyRowsExactly(t, area);
      testing::onEveryTarget([&] {
        const RowTally tally = tallyRows(triangles, area);
        EXPECT_EQ(tally.inside, expected.inside) << family.name;
        EXPECT_EQ(tally.ties, expected.ties) << family.name;
        EXPECT_EQ(tally.cutQuads, expected.cutQuads) << family.name;
        EXPECT_EQ(tally.partlyCovered, expected.partlyCovered) << family.name;
      });
      ties += expected.ties, partly += expected.partlyCovered;
    }
  }
  EXPECT_GT(ties, 1000U);
  EXPECT_GT(partly, 1000U);
}

}  // namespace
}  // namespace rasterdiff::rasterizer
