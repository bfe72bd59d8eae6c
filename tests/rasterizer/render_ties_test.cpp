// Samples exactly on edges and vertices, drawn as text. [vk:primsrast-polygons-basic] Left and top edges own theirs here.
#include <gtest/gtest.h>

#include "rasterizer/render.hpp"
#include "tests/support/scenes.hpp"
#include "tests/support/text_mask.hpp"

namespace rasterdiff::rasterizer {
namespace {

using testing::Point;

std::string maskOf(const std::vector<Point>& points, TieOwner owner = TieOwner::TopLeft) {
  Rules rules = testing::referenceRules();
  rules.choices.tieOwner = owner;
  return testing::textMask(render(testing::sceneOf(points, 8), rules).value());
}

std::string countsOf(const Scene& scene, const Rules& rules = testing::referenceRules()) {
  return testing::textCounts(render(scene, rules).value());
}

const std::vector<Point> kSquare{{1.5, 1.5}, {5.5, 1.5}, {5.5, 5.5}, {1.5, 1.5}, {5.5, 5.5}, {1.5, 5.5}};

TEST(RenderTies, SquareFromCentreToCentreKeepsItsTopAndLeftSide) {
  EXPECT_EQ(countsOf(testing::sceneOf(kSquare, 8)),
            "........\n"
            ".1111...\n"
            ".1111...\n"
            ".1111...\n"
            ".1111...\n"
            "........\n"
            "........\n"
            "........\n");
}

TEST(RenderTies, OtherOwnersKeepTheirOwnTwoSides) {
  EXPECT_EQ(maskOf(kSquare, TieOwner::BottomRight),
            "........\n........\n..####..\n..####..\n..####..\n..####..\n........\n........\n");
  EXPECT_EQ(maskOf(kSquare, TieOwner::TopRight),
            "........\n..####..\n..####..\n..####..\n..####..\n........\n........\n........\n");
  EXPECT_EQ(maskOf(kSquare, TieOwner::BottomLeft),
            "........\n........\n.####...\n.####...\n.####...\n.####...\n........\n........\n");
}

TEST(RenderTies, DiagonalBelongsToTheTriangleOnItsRight) {
  // The left leg and the top are owned, the falling diagonal is a right edge here.
  EXPECT_EQ(maskOf({{1.5, 1.5}, {6.5, 6.5}, {1.5, 6.5}}),
            "........\n"
            "........\n"
            ".#......\n"
            ".##.....\n"
            ".###....\n"
            ".####...\n"
            "........\n"
            "........\n");
  // Here it is a left edge.
  EXPECT_EQ(maskOf({{1.5, 1.5}, {6.5, 1.5}, {6.5, 6.5}}),
            "........\n"
            ".#####..\n"
            "..####..\n"
            "...###..\n"
            "....##..\n"
            ".....#..\n"
            "........\n"
            "........\n");
}

TEST(RenderTies, RisingDiagonalBelongsToTheTriangleOnItsRight) {
  EXPECT_EQ(maskOf({{1.5, 6.5}, {6.5, 1.5}, {6.5, 6.5}}),
            "........\n"
            "........\n"
            ".....#..\n"
            "....##..\n"
            "...###..\n"
            "..####..\n"
            "........\n"
            "........\n");
  EXPECT_EQ(maskOf({{1.5, 1.5}, {6.5, 1.5}, {1.5, 6.5}}),
            "........\n"
            ".#####..\n"
            ".####...\n"
            ".###....\n"
            ".##.....\n"
            ".#......\n"
            "........\n"
            "........\n");
}

TEST(RenderTies, VertexOnASampleIsCoveredWhereBothItsEdgesOwn) {
  // A vertex between two left edges, between left and top, between top and right ...
  EXPECT_EQ(maskOf({{2.5, 4.5}, {6.5, 2.25}, {6.5, 6.75}}).substr(4 * 9, 8), "..####..") << "left corner";
  EXPECT_EQ(maskOf({{6.5, 4.5}, {2.5, 2.25}, {2.5, 6.75}}).substr(4 * 9, 8), "..####..") << "right corner is not";
  EXPECT_EQ(maskOf({{4.5, 1.5}, {6.75, 5.75}, {2.25, 5.75}}).substr(1 * 9, 8), "........") << "top corner has a right edge";
  EXPECT_EQ(maskOf({{1.5, 1.5}, {6.75, 1.5}, {1.5, 5.75}}).substr(1 * 9, 8), ".######.") << "top left corner";
}

TEST(RenderTies, MaskDoesNotDependOnVertexOrderOrWinding) {
  const std::vector<Point> v{{1.5, 2.5}, {6.5, 0.5}, {4.5, 7.5}};
  const std::string expected = maskOf(v);
  for (const auto& order : std::vector<std::array<size_t, 3>>{{1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}) {
    EXPECT_EQ(maskOf({v[order[0]], v[order[1]], v[order[2]]}), expected);
  }
}

TEST(RenderTies, FanAroundASampleCoversEachSampleOnce) {
  std::vector<Point> rim{{6.5, 3.5}, {6.5, 6.5}, {3.5, 6.5}, {0.5, 6.5}, {0.5, 3.5}, {0.5, 0.5}, {3.5, 0.5}, {6.5, 0.5}};
  std::vector<Point> fan;
  for (size_t i = 0; i < rim.size(); ++i) {
    for (const Point& p : {Point{3.5, 3.5}, rim[i], rim[(i + 1) % rim.size()]}) fan.push_back(p);
  }
  for (const auto owner : {TieOwner::TopLeft, TieOwner::TopRight, TieOwner::BottomLeft, TieOwner::BottomRight}) {
    Rules rules = testing::referenceRules();
    rules.choices.tieOwner = owner;
    const Frame frame = *render(testing::sceneOf(fan, 8), rules);
    size_t covered = 0;
    for (const uint32_t count : frame.count.data) {
      EXPECT_LE(count, 1U);
      covered += count;
    }
    EXPECT_EQ(covered, 36U);
  }
}

TEST(RenderTies, EverySampleOfAPixelIsDecidedOnItsOwn) {
  // A vertical edge through sample 0 (6/16) and between the others; the interior is to its right.
  const Scene scene = testing::sceneOf({{2.375, 0}, {8, 0}, {8, 8}, {2.375, 0}, {8, 8}, {2.375, 8}}, 8, 4);
  const Frame frame = *render(scene, testing::referenceRules());
  for (uint32_t y = 0; y < 8; ++y) {
    EXPECT_EQ(frame.count.at(2, y, 0), 1U) << "on the left edge: owned";
    EXPECT_EQ(frame.count.at(2, y, 1), 1U);
    EXPECT_EQ(frame.count.at(2, y, 2), 0U);
    EXPECT_EQ(frame.count.at(2, y, 3), 1U);
  }
  const Scene left = testing::sceneOf({{2.375, 0}, {0, 0}, {0, 8}, {2.375, 0}, {0, 8}, {2.375, 8}}, 8, 4);
  EXPECT_EQ(render(left, testing::referenceRules())->count.at(2, 3, 0), 0U) << "on the right edge: not owned";
}

TEST(RenderTies, ZeroAreaCoversNothing) {
  EXPECT_EQ(maskOf({{1.5, 1.5}, {6.5, 6.5}, {3.5, 3.5}, {2.5, 2.5}, {2.5, 2.5}, {6.5, 2.5}, {4.5, 4.5}, {4.5, 4.5}, {4.5, 4.5}}),
            "........\n........\n........\n........\n........\n........\n........\n........\n");
}

TEST(RenderTies, TiesAreCountedOnce) {
  RuleCounts counts;
  ASSERT_TRUE(render(testing::sceneOf({{1.5, 1.5}, {5.5, 1.5}, {1.5, 5.5}}, 8), testing::referenceRules(), &counts));
  // Five samples on the top edge, five on the left one, five on the diagonal; three of them are corners.
  EXPECT_EQ(counts[Rule::TieBreak], 12U);
}

TEST(RenderTieMutants, BothAndNoneAreVisibleOnASharedEdge) {
  Rules rules = testing::referenceRules();
  rules.error = DeliberateError::TiesCoveredByBoth;
  EXPECT_EQ(countsOf(testing::sceneOf(kSquare, 8), rules),
            "........\n"
            ".21111..\n"
            ".12111..\n"
            ".11211..\n"
            ".11121..\n"
            ".11112..\n"
            "........\n"
            "........\n");
  rules.error = DeliberateError::TiesCoveredByNone;
  EXPECT_EQ(countsOf(testing::sceneOf(kSquare, 8), rules),
            "........\n"
            "........\n"
            "...11...\n"
            "..1.1...\n"
            "..11....\n"
            "........\n"
            "........\n"
            "........\n");
}

}  // namespace
}  // namespace rasterdiff::rasterizer
