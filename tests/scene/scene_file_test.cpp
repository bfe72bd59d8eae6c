// Scene files that are accepted, and what they become.
#include "scene/file/scene_file.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdio>
#include <fstream>

#include "scene/file/number.hpp"

namespace rasterdiff {
namespace {

Scene parsed(const std::string& text) {
  Result<Scene> scene = parseScene(text, "folder/file.scene.json");
  EXPECT_TRUE(scene.has_value()) << (scene ? "" : scene.error().where + ": " + scene.error().what);
  return scene.value_or(Scene{});
}

/// A scene of one draw with these fields.
std::string withDraw(const std::string& draw, const std::string& more = {}) {
  return R"({"target": {"width": 64, "height": 32}, )" + more + R"("draws": [)" + draw + "]}";
}

TEST(SceneFile, OnlyTargetAndOneDrawAreRequiredAndTheRestHasVulkansDefaults) {
  const Scene scene = parsed(withDraw(R"({"positions": [[0, 0, 0, 1], [1, 0, 0, 1], [0, 1, 0, 1]]})"));
  Scene expected;
  expected.name = "file";
  expected.target = {.width = 64, .height = 32};
  expected.viewport = {0, 0, 64, 32, 0, 1};
  expected.draws.push_back({.positions = {{0, 0, 0, 1}, {1, 0, 0, 1}, {0, 1, 0, 1}}});
  EXPECT_EQ(scene, expected);
}

TEST(SceneFile, EveryFieldIsRead) {
  const Scene scene = parsed(R"({
    "$schema": "scene.schema.json", "name": "a/b", "allowNonFinite": true,
    "target": {"width": 16, "height": 8, "samples": 4, "depthFormat": "D32_SFLOAT", "depthClearValue": 0.25},
    "viewport": {"x": 1, "y": 8, "width": 15, "height": -8, "minDepth": 1, "maxDepth": 0.5},
    "scissor": {"x": 2, "y": 3, "width": 4, "height": 5},
    "state": {"topology": "TRIANGLE_FAN", "cullMode": "FRONT_AND_BACK", "frontFace": "CLOCKWISE",
              "provokingVertexMode": "LAST_VERTEX", "depthTestEnable": true, "depthWriteEnable": true,
              "depthCompareOp": "GREATER_OR_EQUAL", "negativeOneToOne": true},
    "draws": [{"positions": [[0, 0, 0, 1]], "indices": [0, 0, 0],
               "varyings": [{"name": "c", "interpolation": "flat", "values": [[1, 2, 3]]},
                            {"name": "d", "values": ["inf"]}]}]})");
  Scene expected;
  expected.name = "a/b";
  expected.allowNonFinite = true;
  expected.target = {
      .width = 16, .height = 8, .samples = 4, .depthFormat = DepthFormat::D32_SFLOAT, .depthClearValue = 0.25f};
  expected.viewport = {1, 8, 15, -8, 1, 0.5f};
  expected.scissor = {2, 3, 4, 5};
  expected.state = {.topology = PrimitiveTopology::TRIANGLE_FAN,
                    .cullMode = CullMode::FRONT_AND_BACK,
                    .frontFace = FrontFace::CLOCKWISE,
                    .provokingVertexMode = ProvokingVertexMode::LAST_VERTEX,
                    .depthTestEnable = true,
                    .depthWriteEnable = true,
                    .depthCompareOp = CompareOp::GREATER_OR_EQUAL,
                    .negativeOneToOne = true};
  expected.draws.push_back(
      {.positions = {{0, 0, 0, 1}},
       .indices = std::vector<uint32_t>{0, 0, 0},
       .varyings = {{.name = "c", .interpolation = Interpolation::flat, .components = 3, .values = {1, 2, 3}},
                    {.name = "d", .components = 1, .values = {HUGE_VALF}}}});
  EXPECT_EQ(scene, expected);
}

TEST(SceneFile, HexFloatsAndSignedZeroKeepEveryBit) {
  const Scene scene = parsed(withDraw(
      R"({"positions": [["0x1.8p+3", "-0X.8P-149", -0, 1], [0.1, -0.0, 1e-45, 1], ["0x1.fffffep127", 3.4e38, 0, 1]]})"));
  const std::vector<ClipPosition>& p = scene.draws.at(0).positions;
  EXPECT_EQ(p[0].x, 12.0f);
  EXPECT_EQ(std::bit_cast<uint32_t>(p[0].y), 0x80000000u) << "half the smallest denormal rounds to even, zero";
  EXPECT_TRUE(std::signbit(p[0].z));
  EXPECT_EQ(p[1].x, 0.1f);
  EXPECT_TRUE(std::signbit(p[1].y));
  EXPECT_EQ(std::bit_cast<uint32_t>(p[1].z), 1u);
  EXPECT_EQ(std::bit_cast<uint32_t>(p[2].x), 0x7f7fffffu);
}

TEST(SceneFile, PixelsMayHaveTwoThreeOrFourNumbers) {
  const Scene scene =
      parsed(withDraw(R"({"space": "pixels", "positions": [[0, 0], [64, 32, 0.5], [32, 16, 0.5, 2]]})"));
  const std::vector<ClipPosition> expected{{-1, -1, 0, 1}, {1, 1, 0.5f, 1}, {0, 0, 1, 2}};
  EXPECT_EQ(scene.draws.at(0).positions, expected);
}

TEST(SceneFile, PixelsAreThoseOfTheFilesViewportWhereverItStands) {
  const Scene scene = parsed(R"({"draws": [{"positions": [[8, 4]], "space": "pixels"}],
    "target": {"width": 64, "height": 64}, "viewport": {"x": 8, "y": 36, "width": 16, "height": -32}})");
  EXPECT_EQ(scene.draws.at(0).positions.at(0), (ClipPosition{-1, 1, 0, 1}));
}

TEST(SceneFile, WorldPositionsGoThroughTheCamera) {
  const Scene scene = parsed(withDraw(
      R"({"space": "world", "positions": [[7, 2, 0], [7, 5, 0], [7, 2, 6]]})",
      R"("camera": {"lookAt": {"eye": [4, 2, 0], "target": [5, 2, 0]}, "perspective": {"fovY": 90, "near": 1, "far": 4}},)"));
  const std::vector<ClipPosition>& p = scene.draws.at(0).positions;
  // The point 3 ahead is at the centre; 3 up of it is the upper border; 6 in z is the right border (aspect 2).
  EXPECT_FLOAT_EQ(p[0].w, 3);
  EXPECT_NEAR(p[0].x, 0, 1e-6);  // rounding of tan and cross products at size 3
  EXPECT_FLOAT_EQ(p[1].y, -3);
  EXPECT_FLOAT_EQ(p[2].x, 3);
}

TEST(SceneFile, ACameraMayBeOrthographicOrAFrustumInEitherConvention) {
  const Scene ortho = parsed(withDraw(
      R"({"space": "world", "positions": [[1, 3, -4]]})",
      R"("camera": {"orthographic": {"left": -1, "right": 1, "bottom": -3, "top": 3, "near": 0, "far": 4}},)"));
  EXPECT_EQ(ortho.draws.at(0).positions.at(0), (ClipPosition{1, -1, 1, 1}));
  const Scene frustum = parsed(withDraw(
      R"({"space": "world", "positions": [[1, 1, -1]]})",
      R"("state": {"negativeOneToOne": true}, "camera": {"perspective": {"left": -1, "right": 1, "bottom": -1, "top": 1,
         "near": 1, "far": 3, "convention": "opengl"}},)"));
  EXPECT_EQ(frustum.draws.at(0).positions.at(0), (ClipPosition{1, 1, -1, 1}));
}

TEST(SceneFile, AMeshIsFoundBesideTheFileAndTransformed) {
  const std::string folder = testing::TempDir();
  std::ofstream(folder + "one.obj") << "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  std::ofstream(folder + "mesh.scene.json") << withDraw(
      R"({"mesh": "one.obj", "transform": [0.5,0,0,0.25, 0,1,0,0, 0,0,1,-1, 0,0,0,1], "varyings": [{"name": "normal"}, {"name": "position", "interpolation": "noperspective"}]})",
      R"("camera": {"orthographic": {"left": -1, "right": 1, "bottom": -1, "top": 1, "near": 0, "far": 2}},)");
  const Result<Scene> scene = loadScene(folder + "mesh.scene.json");
  ASSERT_TRUE(scene.has_value()) << scene.error().where << scene.error().what;
  const Draw& draw = scene->draws.at(0);
  const std::vector<ClipPosition> positions{{0.25f, 0, 0.5f, 1}, {0.75f, 0, 0.5f, 1}, {0.25f, -1, 0.5f, 1}};
  EXPECT_EQ(draw.positions, positions);
  EXPECT_EQ(draw.indices, (std::vector<uint32_t>{0, 1, 2}));
  EXPECT_EQ(draw.varyings.at(0), (Varying{.name = "normal", .components = 3, .values = {0, 0, 1, 0, 0, 1, 0, 0, 1}}));
  EXPECT_EQ(draw.varyings.at(1), (Varying{.name = "position",
                                          .interpolation = Interpolation::noperspective,
                                          .components = 3,
                                          .values = {0, 0, 0, 1, 0, 0, 0, 1, 0}}));
}

TEST(SceneFile, AByteOrderMarkIsSkipped) {
  std::string text = withDraw(R"({"positions": [[0, 0, 0, 1]]})");
  text.insert(0, "\xef\xbb\xbf");
  EXPECT_EQ(parsed(text).draws.size(), 1u);
}

TEST(HexFloat, OnlyC99FormsAreRead) {
  EXPECT_EQ(parseHexFloat("0x10"), 16.0);
  EXPECT_EQ(parseHexFloat("+0x1.8p1"), 3.0);
  EXPECT_EQ(parseHexFloat("-0x.4P-2"), -0.0625);
  for (const char* bad :
       {"", "0x", "1.5", "0x1p", "0x1.8p+3 ", "0x-1", "0xg", "x1", "0x1p99999", "--0x1", "0x1p+3p1", "0x1.2.3"}) {
    EXPECT_FALSE(parseHexFloat(bad).has_value()) << bad;
  }
}

TEST(NonFinite, NansKeepTheirBits) {
  EXPECT_EQ(std::bit_cast<uint32_t>(*parseNonFinite("nan(0xffc12345)")), 0xffc12345u);
  EXPECT_EQ(jsonNumber(std::bit_cast<float>(0xffc12345u)), "\"nan(0xffc12345)\"");
  EXPECT_EQ(jsonNumber(std::nanf("")), "\"nan\"");
  for (const char* bad : {"NaN", "infinity", "nan(0x7f800000)", "nan(0x3f800000)", "nan(0x7fc)", "nan("}) {
    EXPECT_FALSE(parseNonFinite(bad).has_value()) << bad;
  }
}

}  // namespace
}  // namespace rasterdiff
