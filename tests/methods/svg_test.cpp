// SVG polygons: the grammar of points, the markup around it, and the scene that comes out.
#include <gtest/gtest.h>

#include "rasterizer/methods/method_inputs.hpp"
#include "rasterizer/methods/polygon_methods.hpp"
#include "rasterizer/methods/svg_polygon.hpp"
#include "rasterizer/render.hpp"
#include "tests/support/scenes.hpp"

namespace rasterdiff::rasterizer {
namespace {

using Points = std::vector<SvgPoint>;

/// The lecture's example, line break included.
constexpr std::string_view kLecture =
    "<polygon fill=\"#ED18ED\"\npoints=\"464.781,631.819 478.417,309.091 471.599,642.045 \"/>";

TEST(SvgPoints, NumbersMayBeSeparatedByAnythingTheGrammarAllows) {
  const Points expected = {{10, -20}, {0.5, 0.25}};
  for (const std::string_view text :
       {"10,-20 .5,.25", " 10 -20 0.5 .25 ", "10-20 .5.25", "1e1 -2E+1\n+.5\t,\r25e-2", "10.,-20 , 5e-1 , 0.25"}) {
    const Result<Points> points = parseSvgPoints(text);
    ASSERT_TRUE(points.has_value()) << text << ": " << points.error().what;
    EXPECT_EQ(*points, expected) << text;
  }
  EXPECT_TRUE(parseSvgPoints(" \n ")->empty());
}

TEST(SvgPoints, ErrorsNameTheColumn) {
  struct Case {
    std::string_view text, where;
  };
  for (const Case& c : {Case{"1,2 3", "points:6"},
                        {"1,2 x", "points:5"},
                        {"1,,2", "points:3"},
                        {"1,2,", "points:5"},
                        {",1,2", "points:1"},
                        {"1,2 nan,3", "points:5"},
                        {"inf,0", "points:1"},
                        {"1,2 1e999,0", "points:5"},
                        {"0x10,2", "points:2"},
                        {"1,2 .", "points:5"},
                        {"1,2 -", "points:5"},
                        {"1;2", "points:2"},
                        {"1,2 3e", "points:6"}}) {
    const Result<Points> points = parseSvgPoints(c.text);
    ASSERT_FALSE(points.has_value()) << c.text;
    EXPECT_EQ(points.error().where, c.where) << c.text;
    EXPECT_EQ(points.error().code, ErrorCode::BadInput);
  }
}

TEST(SvgPolygon, TheLecturesExampleIsReadAndRoundedToTheGrid) {
  const Result<std::vector<SvgPolygon>> polygons = parseSvgPolygons(kLecture);
  ASSERT_TRUE(polygons.has_value());
  ASSERT_EQ(polygons->size(), 1u);
  // 464.781 · 256 = 118983.936 and so on
  const std::vector<SubpixelPosition> expected = {{118984, 161746}, {122475, 79127}, {120729, 164364}};
  EXPECT_EQ(polygons->front().polygon.vertices, expected);
  EXPECT_EQ(polygons->front().fillRule, FillRule::NonZero);
}

TEST(SvgPolygon, TheLecturesExampleDrawnAsASceneCoversWhatTheScanlineCovers) {
  const Result<std::vector<SvgPolygon>> polygons = parseSvgPolygons(kLecture);
  ASSERT_TRUE(polygons.has_value());
  const Result<Scene> scene = polygonScene(*polygons, 1024, 768);
  ASSERT_TRUE(scene.has_value()) << scene.error().what;
  const Result<Frame> frame = render(*scene, testing::referenceRules());
  ASSERT_TRUE(frame.has_value());
  const Result<PixelMask> mask = drawPolygonScanline(polygons->front().polygon, FillRule::NonZero, 1024, 768);
  uint64_t covered = 0;
  for (uint32_t y = 0; y < 768; ++y) {
    for (uint32_t x = 0; x < 1024; ++x) {
      const uint8_t expected = mask->at(static_cast<int32_t>(x), static_cast<int32_t>(y));
      ASSERT_EQ(frame->count.at(x, y, 0), expected) << x << ", " << y;
      covered += expected;
    }
  }
  EXPECT_EQ(covered, 1172u);  // the triangle has an area of 1169.9 pixels
}

TEST(SvgPolygon, ScenesOfConcavePolygonsCoverEverySampleOnce) {
  Prng prng(4);
  for (int i = 0; i < 200; ++i) {
    const SvgPolygon polygon{concavePolygon(prng), FillRule::NonZero};
    const Result<Scene> scene = polygonScene(std::span(&polygon, 1), kInputExtent, kInputExtent);
    ASSERT_TRUE(scene.has_value()) << scene.error().what;
    const Result<Frame> frame = render(*scene, testing::referenceRules());
    const PixelMask exact = drawPolygonByWinding(polygon.polygon, FillRule::NonZero, kInputExtent, kInputExtent);
    for (size_t k = 0; k < exact.covered.size(); ++k) ASSERT_EQ(frame->count.data[k], exact.covered[k]);
  }
}

TEST(SvgPolygon, WholeDocumentsAreReadPastWhatIsNoPolygon) {
  const Result<std::vector<SvgPolygon>> polygons = parseSvgPolygons(
      "<?xml version=\"1.0\"?>\n<!DOCTYPE svg>\n<svg:svg xmlns:svg='http://www.w3.org/2000/svg' width='9' height='9'>\n"
      "<!-- <polygon points=\"broken\"/> --><style><![CDATA[ a > b < c ]]></style>\n"
      "<svg:g id='a>b'><svg:polygon fill-rule = 'evenodd' points='0,0 4,0 4,4'></svg:polygon></svg:g>\n"
      "<rect width='1' height='1'/><polygon points=\"1,1 2,1 2,2\"/></svg:svg>");
  ASSERT_TRUE(polygons.has_value()) << polygons.error().where << polygons.error().what;
  ASSERT_EQ(polygons->size(), 2u);
  EXPECT_EQ((*polygons)[0].fillRule, FillRule::EvenOdd);
  EXPECT_EQ((*polygons)[1].polygon.vertices[2], (SubpixelPosition{512, 512}));
  EXPECT_TRUE(parseSvgPolygons("plain text")->empty());
}

TEST(SvgPolygon, ErrorsNameLineAndColumn) {
  struct Case {
    std::string_view text, where;
  };
  for (const Case& c : {
           Case{"<polygon", "svg:1:1"},
           {"<svg>\n <polygon fill='red'/>", "svg:2:2"},
           {"<polygon points=1,2>", "svg:1:17"},
           {"<polygon points=\"1,2", "svg:1:17"},
           {"<polygon points>", "svg:1:16"},
           {"<polygon points='1,2 3,4'/>", "svg:1:18 (polygon)"},
           {"<polygon points='1,2 3,4 5'/>", "svg:1:18 (points:10)"},
           {"<polygon points='1,2 3,4 1e300,5'/>", "svg:1:18 (point 2)"},
           {"<polygon points='0,0 1,0 1,1' points=''/>", "svg:1:39"},
           {"<polygon fill-rule='odd' points='0,0 1,0 1,1'/>", "svg:1:21"},
           {"<g transform='scale(2)'/>", "svg:1:15"},
           {"<svg viewBox='0 0 1 1'>", "svg:1:15"},
           {"<!-- never closed", "svg:1:1"},
           {"<", "svg:1:1"},
           {"<polygon \"", "svg:1:10"},
       }) {
    const Result<std::vector<SvgPolygon>> polygons = parseSvgPolygons(c.text);
    ASSERT_FALSE(polygons.has_value()) << c.text;
    EXPECT_EQ(polygons.error().where, c.where) << c.text;
  }
}

TEST(SvgPolygon, EveryPrefixAndEveryDamagedByteOfADocumentIsReadOrRefused) {
  // Whatever is accepted has at least three vertices; the sanitizer build watches the reads.
  const std::string whole(kLecture);
  uint64_t accepted = 0, refused = 0;
  const auto check = [&](std::string_view text) {
    const Result<std::vector<SvgPolygon>> polygons = parseSvgPolygons(text);
    if (!polygons) {
      EXPECT_FALSE(polygons.error().what.empty());
      ++refused;
      return;
    }
    for (const SvgPolygon& polygon : *polygons) EXPECT_GE(polygon.polygon.vertices.size(), 3u);
    ++accepted;
  };
  for (size_t length = 0; length <= whole.size(); ++length) check(std::string_view(whole).substr(0, length));
  for (size_t i = 0; i < whole.size(); ++i) {
    for (const char damage : {'\0', '<', '>', '"', '\'', '-', '.', 'e', ',', ' ', '9', '\xff'}) {
      std::string damaged = whole;
      damaged[i] = damage;
      check(damaged);
    }
  }
  EXPECT_GT(accepted, 0u);
  EXPECT_GT(refused, 0u);
}

TEST(SvgPolygon, ScenesThatShowNothingAreRefused) {
  EXPECT_FALSE(polygonScene({}, 8, 8).has_value());
  const SvgPolygon flat{{{{0, 0}, {256, 256}, {512, 512}}}, FillRule::NonZero};
  EXPECT_FALSE(polygonScene(std::span(&flat, 1), 8, 8).has_value());
  const SvgPolygon square{{{{0, 0}, {512, 0}, {512, 512}}}, FillRule::NonZero};
  EXPECT_FALSE(polygonScene(std::span(&square, 1), 0, 8).has_value());
  EXPECT_FALSE(polygonScene(std::span(&square, 1), 8, 8, 3).has_value());
}

}  // namespace
}  // namespace rasterdiff::rasterizer
