// SVG polygons: the grammar of points, the markup around it, and draws of scene files that are made of them.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "scene/file/scene_file.hpp"
#include "scene/polygon/svg_points.hpp"
#include "scene/polygon/svg_polygon.hpp"

namespace rasterdiff {
namespace {

using Points = std::vector<SvgPoint>;

/// The lecture's example, line break included.
constexpr std::string_view kLecture =
    "<polygon fill=\"#ED18ED\"\npoints=\"464.781,631.819 478.417,309.091 471.599,642.045 \"/>";

TEST(SvgPoints, NumbersMayBeSeparatedByAnythingTheGrammarAllows) {
  const Points expected = {{10, -20}, {0.5, 0.25}};
  for (const std::string_view text :
       {"10,-20 .5,.25", " 10 -20 0.5 .25 ", "10-20 .5.25", "1e1 -2E+1\n+.5\t,\r25e-2", "10.,-20 , 5e-1 , 0.25"}) {
    const auto points = parseSvgPoints(text);
    ASSERT_TRUE(points.has_value()) << text << ": " << points.error().what;
    EXPECT_EQ(*points, expected) << text;
  }
  EXPECT_TRUE(parseSvgPoints(" \n ")->empty());
}

TEST(SvgPoints, MistakesAreWhereTheyStand) {
  struct Case {
    std::string_view text;
    size_t at;
  };
  for (const Case& c : {Case{"1,2 3", 5},
                        {"1,2 x", 4},
                        {"1,,2", 2},
                        {"1,2,", 4},
                        {",1,2", 0},
                        {"1,2 nan,3", 4},
                        {"inf,0", 0},
                        {"1,2 1e999,0", 4},
                        {"1,2 1048577,0", 4},
                        {"0x10,2", 1},
                        {"1,2 .", 4},
                        {"1,2 -", 4},
                        {"1;2", 1},
                        {"1,2 3e", 5}}) {
    const auto points = parseSvgPoints(c.text);
    ASSERT_FALSE(points.has_value()) << c.text;
    EXPECT_EQ(points.error().at, c.at) << c.text;
  }
}

TEST(SvgPolygon, TheLecturesExampleIsReadAndRoundedToTheGrid) {
  const Result<std::vector<SvgPolygon>> polygons = parseSvgPolygons(kLecture, "f.svg");
  ASSERT_TRUE(polygons.has_value());
  ASSERT_EQ(polygons->size(), 1u);
  // 464.781 · 256 = 118983.936 and so on
  const std::vector<SubpixelPosition> expected = {{118984, 161746}, {122475, 79127}, {120729, 164364}};
  EXPECT_EQ(polygons->front().polygon.vertices, expected);
  EXPECT_EQ(polygons->front().fillRule, FillRule::NonZero);
}

TEST(SvgPolygon, WholeDocumentsAreReadPastWhatIsNoPolygon) {
  const Result<std::vector<SvgPolygon>> polygons = parseSvgPolygons(
      "<?xml version=\"1.0\"?>\n<!DOCTYPE svg>\n<svg:svg xmlns:svg='http://www.w3.org/2000/svg' width='9' height='9'>\n"
      "<!-- <polygon points=\"broken\"/> --><style><![CDATA[ a > b < c ]]></style>\n"
      "<svg:g id='a>b'><svg:polygon fill-rule = 'evenodd' points='0,0 4,0 4,4'></svg:polygon></svg:g>\n"
      "<rect width='1' height='1'/><polygon points=\"1,1 2,1 2,2\"/></svg:svg>",
      "f.svg");
  ASSERT_TRUE(polygons.has_value()) << polygons.error().where << polygons.error().what;
  ASSERT_EQ(polygons->size(), 2u);
  EXPECT_EQ((*polygons)[0].fillRule, FillRule::EvenOdd);
  EXPECT_EQ((*polygons)[1].polygon.vertices[2], (SubpixelPosition{512, 512}));
  EXPECT_TRUE(parseSvgPolygons("plain text", "f.svg")->empty());
}

TEST(SvgPolygon, ErrorsNameLineAndColumn) {
  struct Case {
    std::string_view text, where;
  };
  for (const Case& c : {
           Case{"<polygon", "f.svg:1:1"},
           {"<svg>\n <polygon fill='red'/>", "f.svg:2:2"},
           {"<polygon points=1,2>", "f.svg:1:17"},
           {"<polygon points=\"1,2", "f.svg:1:17"},
           {"<polygon points>", "f.svg:1:16"},
           {"<polygon points='1,2 3,4'/>", "f.svg:1:18"},
           {"<polygon points='1,2 3,4 5'/>", "f.svg:1:27"},
           {"<polygon points='1,2 3,4 1e300,5'/>", "f.svg:1:26"},
           {"<polygon points='0,0 1,0 1,1' points=''/>", "f.svg:1:39"},
           {"<polygon fill-rule='odd' points='0,0 1,0 1,1'/>", "f.svg:1:21"},
           {"<g transform='scale(2)'/>", "f.svg:1:15"},
           {"<svg viewBox='0 0 1 1'>", "f.svg:1:15"},
           {"<svg width='8' height='8' viewBox='0 0 8 9'>", "f.svg:1:36"},
           {"<svg width='8' height='8' viewBox='1 0 8 8'>", "f.svg:1:36"},
           {"<svg width='8mm' height='8mm' viewBox='0 0 8 8'>", "f.svg:1:40"},
           {"<!-- never closed", "f.svg:1:1"},
           {"<", "f.svg:1:1"},
           {"<polygon \"", "f.svg:1:10"},
       }) {
    const Result<std::vector<SvgPolygon>> polygons = parseSvgPolygons(c.text, "f.svg");
    ASSERT_FALSE(polygons.has_value()) << c.text;
    EXPECT_EQ(polygons.error().where, c.where) << c.text;
  }
}

TEST(SvgPolygon, EveryPrefixAndEveryDamagedByteOfADocumentIsReadOrRefused) {
  // Whatever is accepted has at least three vertices; the sanitizer build watches the reads.
  const std::string whole(kLecture);
  uint64_t accepted = 0, refused = 0;
  const auto check = [&](std::string_view text) {
    const Result<std::vector<SvgPolygon>> polygons = parseSvgPolygons(text, "f.svg");
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

TEST(SvgPolygon, AViewBoxThatLeavesThePictureIsRead) {
  const auto polygons = parseSvgPolygons(
      "<svg width='64' height='48px' viewBox='0,0 64 48'><polygon points='0,0 4,0 4,4'/></svg>", "f.svg");
  ASSERT_TRUE(polygons.has_value()) << polygons.error().where << polygons.error().what;
  EXPECT_EQ(polygons->size(), 1u);
}

std::string sceneText(const std::string& draw, const std::string& more = "") {
  return R"({"target": {"width": 64, "height": 64},)" + more + " \"draws\": [" + draw + "]}";
}

TEST(PolygonDraw, PointsOfASceneFileBecomeTrianglesInPixels) {
  const Result<Scene> scene = parseScene(
      sceneText(R"({"points": "8,8 40,8 8,40", "z": 0.25, "varyings": [{"name": "position"}]})"), "f.json");
  ASSERT_TRUE(scene.has_value()) << scene.error().where << scene.error().what;
  const Draw& draw = scene->draws.front();
  ASSERT_EQ(draw.positions.size(), 3u);
  for (size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(draw.positions[i].z, 0.25F);
    EXPECT_EQ(draw.positions[i].x * 32 + 32, draw.varyings[0].values[2 * i]);
    EXPECT_EQ(draw.positions[i].y * 32 + 32, draw.varyings[0].values[2 * i + 1]);
  }
}

TEST(PolygonDraw, TheFillRuleSaysWhetherTheMiddleOfAStarIsFilled) {
  const auto triangles = [](const std::string& rule) {
    const Result<Scene> scene =
        parseScene(sceneText(R"({"points": "32,2 50,60 3,24 61,24 14,60")" + rule + "}"), "f.json");
    EXPECT_TRUE(scene.has_value());
    return scene->draws.front().positions.size() / 3;
  };
  EXPECT_EQ(triangles(""), triangles(R"(, "fillRule": "nonzero")"));
  EXPECT_EQ(triangles(R"(, "fillRule": "evenodd")"), 5u);
  EXPECT_EQ(triangles(""), 8u);
}

TEST(PolygonDraw, TheExampleIsDrawnAsWritten) {
  const Result<Scene> scene = loadScene(RASTERDIFF_SOURCE_DIR "/examples/polygons.scene.json");
  ASSERT_TRUE(scene.has_value()) << scene.error().where << scene.error().what;
  EXPECT_EQ(scene->draws.size(), 2u);
  const Result<Scene> again = parseScene(writeScene(*scene), "again.scene.json");
  ASSERT_TRUE(again.has_value());
  EXPECT_EQ(*again, *scene);
}

TEST(PolygonDraw, PixelsAreThoseOfTheDrawsViewport) {
  const Result<Scene> scene =
      parseScene(sceneText(R"({"points": "8,8 40,8 8,40", "viewportIndex": 1})",
                           R"("furtherViewports": [{"viewport": {"x": 8, "y": 8, "width": 32, "height": 32}}],)"),
                 "f.json");
  ASSERT_TRUE(scene.has_value()) << scene.error().where << scene.error().what;
  EXPECT_EQ(scene->draws.front().viewportIndex, 1u);
  for (const ClipPosition& p : scene->draws.front().positions) EXPECT_TRUE(p.x == -1 || p.x == 1) << p.x;
}

TEST(PolygonDraw, MistakesOfAnSvgFileAreNamedWithItsLineAndColumn) {
  std::string name = (std::filesystem::temp_directory_path() / "rasterdiff-svg-XXXXXX").string();
  ASSERT_NE(mkdtemp(name.data()), nullptr);
  const std::filesystem::path folder = name;
  const auto refusal = [&](const std::string& svg) {
    std::ofstream(folder / "p.svg") << svg;
    const Result<Scene> scene = parseScene(sceneText(R"({"svg": "p.svg"})"), (folder / "s.scene.json").string());
    EXPECT_FALSE(scene.has_value()) << svg;
    return scene ? Error{} : scene.error();
  };
  const Error bad = refusal("<svg>\n <polygon points='1,2 3,4 5'/>\n</svg>");
  EXPECT_TRUE(bad.where.ends_with("s.scene.json:1:59")) << bad.where;
  EXPECT_NE(bad.what.find("p.svg:2:28: an odd number"), std::string::npos) << bad.what;
  EXPECT_NE(refusal("<svg/>").what.find("no polygon covers any area"), std::string::npos);
  EXPECT_NE(refusal("<svg><polygon points='0,0 4,4 8,8'/></svg>").what.find("no polygon covers any area"),
            std::string::npos);
  std::filesystem::remove(folder / "p.svg");
  const Result<Scene> gone = parseScene(sceneText(R"({"svg": "p.svg"})"), (folder / "s.scene.json").string());
  ASSERT_FALSE(gone.has_value());
  EXPECT_EQ(gone.error().code, ErrorCode::Io);
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace rasterdiff
