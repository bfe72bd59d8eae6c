// Polygon methods against the winding number, and the winding number against rationals.
#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "rasterizer/edge_function.hpp"
#include "rasterizer/methods/method_inputs.hpp"
#include "rasterizer/methods/polygon_methods.hpp"
#include "rasterizer/methods/triangle_pixels.hpp"
#include "scene/polygon/triangulation.hpp"
#include "tests/methods/rational_geometry.hpp"

namespace rasterdiff::rasterizer {
namespace {

constexpr FillRule kRules[] = {FillRule::EvenOdd, FillRule::NonZero};

/// Vertices in half pixels.
Polygon inHalves(std::vector<SubpixelPosition> vertices) {
  for (SubpixelPosition& v : vertices) v = {v.x * 128, v.y * 128};
  return {std::move(vertices)};
}

std::string text(const PixelMask& mask) {
  std::string result;
  for (int32_t y = 0; y < mask.height; ++y) {
    for (int32_t x = 0; x < mask.width; ++x) result += mask.at(x, y) != 0 ? '#' : '.';
    result += '\n';
  }
  return result;
}

/// A star of five points that crosses itself: its middle has winding number 2.
const Polygon kStar = inHalves({{8, 0}, {13, 15}, {0, 6}, {16, 6}, {3, 15}});

TEST(Polygon, TopLeftBordersBelongToASquareAndBottomRightOnesDoNot) {
  const Polygon square = inHalves({{1, 1}, {5, 1}, {5, 5}, {1, 5}});
  for (const PolygonMethod& method : polygonMethods()) {
    EXPECT_EQ(text(*method.draw(square, FillRule::NonZero, 4, 4)), "##..\n##..\n....\n....\n") << method.name;
  }
}

TEST(Polygon, EvenOddLeavesTheMiddleOfAStarEmptyAndNonZeroFillsIt) {
  // By hand, row 4 (y = 4.5): the left arm is [2.17, 2.5), the right one [5.5, 5.83), so only the right one has a
  // centre.
  EXPECT_EQ(text(*drawPolygonScanline(kStar, FillRule::EvenOdd, 8, 8)),
            "........\n...#....\n...##...\n.##..##.\n.....#..\n..####..\n..#..#..\n........\n");
  EXPECT_EQ(text(*drawPolygonScanline(kStar, FillRule::NonZero, 8, 8)),
            "........\n...#....\n...##...\n.######.\n..####..\n..####..\n..#..#..\n........\n");
}

TEST(Polygon, WindingNumberAgreesWithRationalsAtEveryPixelCentre) {
  Prng prng(5);
  for (int i = 0; i < 60; ++i) {
    for (const auto make : {convexPolygon, concavePolygon, crossingPolygon}) {
      const Polygon polygon = make(prng);
      for (int32_t y = 0; y < kInputExtent; y += 2) {
        for (int32_t x = 0; x < kInputExtent; ++x) {
          const SubpixelPosition centre{x * 256 + 128, y * 256 + 128};
          ASSERT_EQ(windingNumber(polygon, centre), testing::rationalWinding(polygon, centre)) << x << ", " << y;
        }
      }
    }
  }
}

TEST(Polygon, WindingNumberOfATriangleAgreesWithEdgeFunctions) {
  Prng prng(6);
  for (int i = 0; i < 3000; ++i) {
    SnappedTriangle triangle;
    for (SubpixelPosition& v : triangle.v) v = {prng.between(-4, 36) * 128, prng.between(-4, 36) * 128};
    PixelMask mask(16, 16);
    addTrianglePixels(triangle, mask);
    const Polygon polygon{{triangle.v.begin(), triangle.v.end()}};
    EXPECT_EQ(mask.covered, drawPolygonByWinding(polygon, FillRule::NonZero, 16, 16).covered);
  }
}

TEST(Polygon, ScanlineIsExactForEveryPolygonUnderBothRules) {
  Prng prng(7);
  for (int i = 0; i < 2000; ++i) {
    for (const auto make : {convexPolygon, concavePolygon, crossingPolygon}) {
      const Polygon polygon = make(prng);
      for (const FillRule rule : kRules) {
        const PixelMask exact = drawPolygonByWinding(polygon, rule, kInputExtent, kInputExtent);
        ASSERT_EQ(drawPolygonScanline(polygon, rule, kInputExtent, kInputExtent)->differing(exact), 0u);
      }
    }
  }
}

TEST(Polygon, ScanlineIsExactWhereThePolygonReachesFarBeyondTheMask) {
  Prng prng(8);
  for (int i = 0; i < 500; ++i) {
    Polygon polygon;
    const int32_t reach = prng.chance(50) ? kMaxPolygonCoordinate : 64 * 256;
    for (int k = 0; k < 6; ++k) polygon.vertices.push_back({prng.between(-reach, reach), prng.between(-reach, reach)});
    for (const FillRule rule : kRules) {
      const PixelMask exact = drawPolygonByWinding(polygon, rule, 24, 17);
      ASSERT_EQ(drawPolygonScanline(polygon, rule, 24, 17)->differing(exact), 0u);
    }
  }
}

TEST(Polygon, FanIsExactForConvexPolygonsOnly) {
  Prng prng(9);
  uint64_t concaveWrong = 0;
  for (int i = 0; i < 1000; ++i) {
    const Polygon convex = convexPolygon(prng), concave = concavePolygon(prng);
    const auto wrong = [](const Polygon& polygon) {
      return drawPolygonFan(polygon, FillRule::NonZero, kInputExtent, kInputExtent)
          ->differing(drawPolygonByWinding(polygon, FillRule::NonZero, kInputExtent, kInputExtent));
    };
    EXPECT_EQ(wrong(convex), 0u);
    concaveWrong += wrong(concave);
  }
  EXPECT_GT(concaveWrong, 0u);
}

TEST(Triangulation, OfSimplePolygonsIsExactWithoutOverlapAndAddsNoVertex) {
  Prng prng(10);
  for (int i = 0; i < 1000; ++i) {
    const Polygon polygon = i % 2 == 0 ? concavePolygon(prng) : convexPolygon(prng);
    const Result<Triangulation> triangulation = triangulate(polygon, FillRule::NonZero);
    ASSERT_TRUE(triangulation.has_value());
    EXPECT_EQ(triangulation->roundedVertices, 0u);
    EXPECT_LE(triangulation->triangles.size(), polygon.vertices.size() - 2);  // fewer where neighbours are in line
    int64_t area = 0, polygonArea = 0;
    for (size_t k = 1; k + 1 < polygon.vertices.size(); ++k) {
      polygonArea += doubleArea(polygon.vertices[0], polygon.vertices[k], polygon.vertices[k + 1]);
    }
    uint64_t pixels = 0, once = 0;
    for (const auto& corners : triangulation->triangles) {
      const SnappedTriangle triangle{corners};
      area += std::abs(doubleArea(triangle.v[0], triangle.v[1], triangle.v[2]));
      PixelMask mask(kInputExtent, kInputExtent);
      addTrianglePixels(triangle, mask);
      for (const uint8_t covered : mask.covered) pixels += covered;
    }
    const PixelMask exact = drawPolygonByWinding(polygon, FillRule::NonZero, kInputExtent, kInputExtent);
    for (const uint8_t covered : exact.covered) once += covered;
    EXPECT_EQ(area, std::abs(polygonArea));
    EXPECT_EQ(pixels, once);
    EXPECT_EQ(drawPolygonTriangulated(polygon, FillRule::NonZero, kInputExtent, kInputExtent)->differing(exact), 0u);
  }
}

TEST(Triangulation, SaysWhenACrossingWasRoundedToTheGrid) {
  const Result<Triangulation> star = triangulate(kStar, FillRule::NonZero);
  ASSERT_TRUE(star.has_value());
  EXPECT_GT(star->roundedVertices, 0u);
  const Result<Triangulation> bow = triangulate(inHalves({{0, 0}, {4, 4}, {4, 0}, {0, 4}}), FillRule::EvenOdd);
  ASSERT_TRUE(bow.has_value());
  EXPECT_EQ(bow->roundedVertices, 0u);  // crosses itself on the grid
  EXPECT_EQ(bow->triangles.size(), 2u);
}

TEST(Triangulation, OfAPolygonWithoutAreaIsEmpty) {
  const Result<Triangulation> flat = triangulate(inHalves({{0, 0}, {4, 4}, {8, 8}}), FillRule::NonZero);
  ASSERT_TRUE(flat.has_value());
  EXPECT_TRUE(flat->triangles.empty());
}

TEST(Polygon, BadPolygonsAreRefusedByEveryMethod) {
  const Polygon square = inHalves({{1, 1}, {5, 1}, {5, 5}, {1, 5}});
  const Polygon two = inHalves({{1, 1}, {5, 1}});
  const Polygon far{{{0, 0}, {kMaxPolygonCoordinate + 1, 0}, {0, 9}}};
  for (const PolygonMethod& method : polygonMethods()) {
    EXPECT_FALSE(method.draw({}, FillRule::NonZero, 4, 4).has_value()) << method.name;
    EXPECT_FALSE(method.draw(two, FillRule::NonZero, 4, 4).has_value()) << method.name;
    EXPECT_FALSE(method.draw(far, FillRule::NonZero, 4, 4).has_value()) << method.name;
    EXPECT_FALSE(method.draw(square, FillRule::NonZero, 0, 4).has_value()) << method.name;
    EXPECT_FALSE(method.draw(square, FillRule::NonZero, 4, kMaxMaskExtent + 1).has_value()) << method.name;
  }
}

}  // namespace
}  // namespace rasterdiff::rasterizer
