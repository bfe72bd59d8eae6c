// Scene files that are refused: where, and with which words.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "scene/file/json_document.hpp"
#include "scene/file/scene_file.hpp"

namespace rasterdiff {
namespace {

/// A mistake is marked by ^ in front of where it has to be reported.
struct Bad {
  const char* text;
  const char* what;  ///< part of the message
  const char* hint = "";
};

std::string marked(std::string text, std::string& where) {
  const size_t at = text.find('^');
  EXPECT_NE(at, std::string::npos) << text;
  where = textPosition(text, at, "f.json");
  return text.erase(at, 1);
}

void expectRefused(const Bad& bad) {
  std::string where;
  const std::string text = marked(bad.text, where);
  const Result<Scene> scene = parseScene(text, "f.json");
  ASSERT_FALSE(scene.has_value()) << text;
  EXPECT_EQ(scene.error().where, where) << text << "\n" << scene.error().what;
  EXPECT_NE(scene.error().what.find(bad.what), std::string::npos) << text << "\n" << scene.error().what;
  EXPECT_NE(scene.error().hint.find(bad.hint), std::string::npos) << text << "\n" << scene.error().hint;
  EXPECT_EQ(scene.error().code, ErrorCode::BadInput);
}

TEST(BadSceneFile, SyntaxErrorsAreAtTheTokenThatDoesNotFit) {
  const Bad table[] = {
      {"^", "empty"},
      {"  \n \t^", "empty"},
      {"{\"target\": ^", "unexpected end of input"},
      {"{\n  \"target\": {\"width\": 1 ^\"height\": 2}}", "expected"},
      {"{\"target\": [1, 2^", "unexpected end of input"},
      {"{\"target\": [1, ^]}", "unexpected ']'"},
      {"{\"target\": [1,^, 2]}", "unexpected ','"},
      {"{^'target': 1}", "invalid literal"},
      {"{\"target\": ^tru}", "invalid literal"},
      {"{\"target\": 0^1}", "expected"},
      {"{\"target\": 1.5^.5}", "invalid literal"},
      {"{\"target\": true^false}", "expected"},
      {"{\"target\": ^1e999}", "overflow"},
      {"{\"target\": ^NaN}", "invalid literal"},
      {"{} ^{}", "expected end of input"},
  };
  for (const Bad& bad : table) expectRefused(bad);
  expectRefused({"{\"a\": \"x^\ty\"}", "control character"});
  expectRefused({"{\"a\": \"ab\\^q\"}", "invalid string"});
  expectRefused({"{\"\xc3\xa4\": [\"\xe2\x82\xac\", ^}", "unexpected '}'"});
}

TEST(BadSceneFile, DuplicateKeysAreRefused) {
  expectRefused({R"({"name": "a", "target": {}, ^"name": "b"})", "a second field 'name'"});
  expectRefused({R"({"target": {"width": [1, {"a": 1}], "height": 2, ^"width": 2}})", "a second field 'width'"});
}

TEST(BadSceneFile, MistakesInPolygonsAreAtTheCharacter) {
  const Bad table[] = {
      {R"({"target": {"width": 8, "height": 8}, "draws": [{"points": "1,2 3,4 ^x,5"}]})", "a number is expected", "x,y"},
      {R"({"target": {"width": 8, "height": 8}, "draws": [{"points": "1,2 3,4 5^"}]})", "odd number"},
      {R"({"target": {"width": 8, "height": 8}, "draws": [{"points": "^1,2 3,4"}]})", "a polygon of 2 points"},
      {R"({"target": {"width": 8, "height": 8}, "draws": [{"points": "1,2 3,4 5,^-2e6"}]})", "out of range", "pixels"},
      {R"({"target": {"width": 8, "height": 8}, "draws": [{"points": ^"1,2\t3,x"}]})", "a number is expected"},
      {R"({"target": {"width": 8, "height": 8}, "draws": [{"points": ^"0,0 1,1 2,2"}]})", "no polygon covers any area"},
      {R"({"target": {"width": 8, "height": 8}, "draws": [{"points": ^[1, 2]}]})", "expected a string"},
      {R"({"target": {"width": 8, "height": 8}, "draws": [{"points": "0,0 1,0 1,1", "fillRule": ^"odd"}]})",
       "no fillRule", "evenodd"},
      {R"({"target": {"width": 8, "height": 8}, "draws": [{"svg": "a.svg", ^"fillRule": "evenodd"}]})", "fillRule"},
      {R"({"target": {"width": 8, "height": 8}, "draws": [{"points": "0,0 1,0 1,1", ^"indices": [0]}]})", "indices"},
      {R"({"target": {"width": 8, "height": 8}, "draws": [{"points": "0,0 1,0 1,1", "z": ^"near"}]})", "number"},
      {R"({"target": {"width": 8, "height": 8}, "draws": [{"points": "0,0 1,0 1,1", "viewportIndex": ^1}]})",
       "viewport 1 but only 1"},
      {R"({"target": {"width": 8, "height": 8}, "draws": [{"points": "0,0 1,0 1,1", "varyings": [{"name": ^"normal"}]}]})",
       "a polygon has no 'normal'", "position"},
      {R"({"target": {"width": 8, "height": 8}, "state": {"topology": "LINE_LIST"}, "draws": [^{"points": "0,0 1,0 1,1"}]})",
       "TRIANGLE_LIST"},
  };
  for (const Bad& bad : table) expectRefused(bad);
}

TEST(BadSceneFile, MistakesInSampleLocationsAreAtTheValue) {
  const auto target = [](const std::string& more) { return R"({"target": {"width": 8, "height": 8, )" + more + R"(}, "draws": []})"; };
  const std::pair<std::string, const char*> table[] = {
      {target(R"("sampleLocations": ^{"sampleLocations": [[0, 0]]})"), "stays at the centre"},
      {target(R"("samples": 2, "sampleLocations": ^{})"), "without 'sampleLocations'"},
      {target(R"("samples": 2, "sampleLocations": {"sampleLocations": ^[[0, 0]]})"), "1 locations for 2 samples"},
      {target(R"("samples": 2, "sampleLocations": {"sampleLocations": [[0, 0], ^[1]]})"), "a location of 1 numbers"},
      {target(R"("samples": 2, "sampleLocations": {"sampleLocations": [[0, 0], [^"x", 0]]})"), "number"},
      {target(R"("samples": 2, "sampleLocations": {"sampleLocationsPerPixel": ^4, "sampleLocations": []})"),
       "4 locations a pixel of 2 samples"},
      {target(R"("samples": 2, "sampleLocations": {"sampleLocationGridSize": ^[2], "sampleLocations": []})"),
       "a grid size of 1 numbers"},
      {target(R"("samples": 2, "sampleLocations": {"sampleLocationGridSize": ^[9, 1], "sampleLocations": []})"),
       "9 is outside 1..8"},
  };
  for (const auto& [text, what] : table) expectRefused({text.c_str(), what});
}

TEST(BadSceneFile, WrongTypesAndRangesAreAtTheValue) {
  const Bad table[] = {
      {"^[]", "expected an object (scene), found an array"},
      {"^42", "expected an object"},
      {R"(^{"draws": []})", "without 'target'"},
      {R"(^{"target": {"width": 1, "height": 1}})", "without 'draws'"},
      {R"({"target": ^null, "draws": []})", "found null"},
      {R"({"target": {"width": ^"8", "height": 8}, "draws": []})", "expected an integer, found a string"},
      {R"({"target": {"width": ^8.5, "height": 8}, "draws": []})", "expected an integer, found a number"},
      {R"({"target": {"width": ^-8, "height": 8}, "draws": []})", "outside"},
      {R"({"target": {"width": ^0, "height": 8}, "draws": []})", "target.width: 0 is outside 1..16384"},
      {R"({"target": {"width": 8, "height": ^100000}, "draws": []})", "target.height"},
      {R"({"target": {"width": 8, "height": ^99999999999999999999}, "draws": []})", "expected an integer"},
      {R"({"target": {"width": 8, "height": 8, "samples": ^3}, "draws": []})", "no sample count", "1, 2, 4, 8, 16"},
      {R"({"target": {"width": 8, "height": 8, "depthFormat": ^"S8_UINT"}, "draws": []})", "no depthFormat",
       "D32_SFLOAT"},
      {R"({"target": {"width": 8, "height": 8, "supersample": ^33}, "draws": []})", "outside 1..32"},
      {R"({"target": {"width": 8, "height": 8, "resolve": ^true}, "draws": []})", "needs no resolve", "samples"},
      {R"({"target": {"width": ^8192, "height": 8, "supersample": 3}, "draws": []})", "supersampled 3 times"},
      {R"({"target": {"width": 8, "height": 8}, "state": {"lineStipplePattern": ^65536}, "draws": []})", "16 bits"},
      {R"({"target": {"width": 8, "height": 8}, "state": {"lineStippleFactor": ^0}, "draws": []})", "1..256"},
      {R"({"target": {"width": 8, "height": 8}, "state": {"lineWidth": ^0}, "draws": []})", "above 0"},
      {R"({"target": {"width": 8, "height": 8}, "state": {"topology": "LINE_LIST", "polygonMode": ^"LINE"}, "draws": []})",
       "no polygons"},
      {R"({"target": {"width": 8, "height": 8}, "builtIns": ["FragCoord", ^"PointCoord"], "draws": []})",
       "no points", "POINT_LIST"},
      {R"({"target": {"width": 8, "height": 8}, "builtIns": ["FragCoord", ^"FragDepth"], "draws": []})",
       "no built-in"},
      {R"({"target": {"width": 8, "height": 8}, "furtherViewports": [^{"scissor": {"width": 8, "height": 8}}], "draws": []})",
       "without 'viewport'"},
      {R"({"target": {"width": 8, "height": 8}, "furtherViewports": [{"viewport": {"width": ^0, "height": 8}}], "draws": []})",
       "furtherViewports[0].viewport.width"},
      {R"({"target": {"width": 8, "height": 8, "depthClearValue": ^0.5}, "draws": []})", "without a depth attachment"},
      {R"({"target": ^{"width": 8}, "draws": []})", "without 'height'"},
      {R"({"target": {"width": 8, "height": 8}, "draws": ^[]})", "without draws"},
      {R"({"target": {"width": 8, "height": 8}, "draws": ^{}})", "expected an array"},
      {R"({"target": {"width": 8, "height": 8}, "name": ^7, "draws": []})", "expected a string"},
      {R"({"target": {"width": 8, "height": 8}, "name": ^"../../x", "draws": []})", "not a relative name"},
      {R"({"target": {"width": 8, "height": 8}, "viewport": {"width": 8, "height": ^0}, "draws": []})",
       "viewport.height"},
      {R"({"target": {"width": 8, "height": 8}, "viewport": {"width": ^"inf", "height": 8}, "draws": []})",
       "not finite"},
      {R"({"target": {"width": 8, "height": 8}, "scissor": {"x": ^-1, "width": 8, "height": 8}, "draws": []})",
       "negative"},
      {R"({"target": {"width": 8, "height": 8}, "scissor": {"width": 8, "height": ^0}, "draws": []})", "size zero"},
      {R"({"target": {"width": 8, "height": 8}, "state": {"depthTestEnable": ^1}, "draws": []})", "true or false"},
      {R"({"target": {"width": 8, "height": 8}, "state": {"depthTestEnable": ^true}, "draws": []})", "without a depth"},
      {R"({"target": {"width": 8, "height": 8}, "state": {"cullMode": ^"BOTH"}, "draws": []})", "no cullMode",
       "FRONT_AND_BACK"},
      {R"({"target": {"width": 8, "height": 8}, "state": {"topology": ^"TRIANGLES_LIST"}, "draws": []})", "no topology",
       "did you mean 'TRIANGLE_LIST'?"},
  };
  for (const Bad& bad : table) expectRefused(bad);
}

TEST(BadSceneFile, UnknownFieldsAreNamedWithAHint) {
  const Bad table[] = {
      {R"({^"traget": {}})", "unknown field 'traget' of scene", "did you mean 'target'?"},
      {R"({"target": {^"widht": 8, "height": 8}, "draws": []})", "unknown field 'widht' of target", "'width'"},
      {R"({"target": {"width": 8, "height": 8, ^"layers": 2}, "draws": []})", "unknown field 'layers'"},
      {R"({"target": {"width": 8, "height": 8}, "state": {^"rasterizerDiscardEnable": true}, "draws": []})",
       "'rasterizerDiscardEnable' of state", "one of topology"},
      {R"({"target": {"width": 8, "height": 8}, "state": {^"linewith": 2}, "draws": []})", "'linewith' of state", "'lineWidth'"},
      {R"({"target": {"width": 8, "height": 8}, "draws": [{"positions": [[0,0,0,1]], ^"clipDistance": []}]})",
       "'clipDistance' of draw", "'clipDistances'"},
      {R"({"target": {"width": 8, "height": 8}, "draws": [{"mesh": "a.obj", ^"positions": []}]})",
       "'positions' of mesh draw"},
  };
  for (const Bad& bad : table) expectRefused(bad);
}

/// The draw goes into a scene of 8 × 8 with an orthographic camera.
Bad inDraw(std::string& storage, const char* draw, const char* what, const char* hint = "") {
  storage =
      R"({"target": {"width": 8, "height": 8}, "camera": {"orthographic": {"left": -1, "right": 1, "bottom": -1, "top": 1, "near": 0, "far": 1}}, "draws": [)" +
      std::string("{\"positions\": [[0,0,0,1]]},\n  ") + draw + "]}";
  return {storage.c_str(), what, hint};
}

TEST(BadSceneFile, DrawsAreCheckedToTheLastIndex) {
  const Bad table[] = {
      {"^7", "expected an object"},
      {"^{}", "draw without 'positions'"},
      {R"({"positions": ^[]})", "without positions"},
      {R"({"positions": [^[0,0,0]]})", "a position of 3 numbers", "[x, y, z, w]"},
      {R"({"positions": [[0,0,^"zero",1]]})", "'zero' is no number", "0x1.8p+3"},
      {R"({"positions": [[0,0,^true,1]]})", "expected a number, found a boolean"},
      {R"({"positions": [[0,0,^"nan",1]]})", "not finite", "allowNonFinite"},
      {R"({"positions": [[0,0,^1e300,1]]})", "beyond float32"},
      {R"({"space": ^"screen", "positions": [[0,0,0,1]]})", "no space", "clip, world, pixels"},
      {R"({"space": "pixels", "positions": [[0,0], ^[0]]})", "of 1 numbers", "2 to 4"},
      {R"({"space": "pixels", "positions": [[0,0], [0,^"inf"]]})", "no finite number"},
      {R"({"space": "world", "positions": [^[0,0]]})", "of 2 numbers", "3 numbers"},
      {R"({"space": "world", "positions": [[0,0,0],^[1e300,0,0]]})", "draws[1].positions[1]"},
      {R"({"positions": [[0,0,0,1]], "indices": [0,0,^1]})", "draws[1].indices[2]: index 1 but only 1 positions"},
      {R"({"positions": [[0,0,0,1]], "indices": [0,^-1]})", "outside"},
      {R"({"positions": [[0,0,0,1]], "indices": [0,^0.5]})", "expected an integer"},
      {R"({"positions": [[0,0,0,1]], "transform": ^[]})", "'transform' without 'mesh'"},
      {R"({"positions": [[0,0,0,1]], "varyings": [^{"name": "a"}]})", "without 'values'"},
      {R"({"positions": [[0,0,0,1]], "varyings": [{"name": ^"a b", "values": [1]}]})", "no varying name"},
      {R"({"positions": [[0,0,0,1]], "varyings": [{"name": "a", "values": ^[1, 2]}]})", "2 values for 1 vertices"},
      {R"({"positions": [[0,0,0,1]], "varyings": [{"name": "a", "values": [^[]]}]})", "0 components"},
      {R"({"positions": [[0,0,0,1]], "varyings": [{"name": "a", "values": [[1,2,3,4], ^[1,2]]}]})",
       "first vertex has 4"},
      {R"({"positions": [[0,0,0,1]], "varyings": [{"name": "a", "values": [[1, ^"-inf"]]}]})", "not finite"},
      {R"({"positions": [[0,0,0,1]], "varyings": [{"name": "a", "interpolation": ^"center", "values": [1]}]})",
       "no interpolation"},
      {R"({"positions": [[0,0,0,1]], "varyings": [^{"name": "a", "interpolation": "offset", "values": [1]}]})",
       "without 'offset'"},
      {R"({"positions": [[0,0,0,1]], "varyings": [{"name": "a", "offset": ^[0, 0], "values": [1]}]})",
       "an offset without", "\"offset\""},
      {R"({"positions": [[0,0,0,1]], "varyings": [{"name": "a", "interpolation": "offset", "offset": ^[0, 0.5], "values": [1]}]})",
       "outside [-0.5, 0.5)"},
      {R"({"positions": [[0,0,0,1]], "indices": [0, ^4294967295]})", "without primitive restart",
       "primitiveRestartEnable"},
      {R"({"positions": [[0,0,0,1]], "viewportIndex": ^1})", "viewport 1 but only 1"},
      {R"({"positions": [[0,0,0,1]], "pointSizes": ^[1, 2]})", "2 sizes for 1 vertices"},
      {R"({"positions": [[0,0,0,1]], "pointSizes": [^0]})", "above 0"},
      {R"({"positions": [[0,0,0,1]], "clipDistances": [^[1,2,3,4,5,6,7,8,9]]})", "9 components"},
      {R"({"positions": [[0,0,0,1], [0,0,0,1]], "clipDistances": [[1, 2], ^1]})", "first vertex has 2"},
      {R"({"positions": [[0,0,0,1]], "clipDistances": ^[1]})", "where draws[0] has 0"},
      {R"({"positions": [[0,0,0,1]], "cullDistances": ^[1, 2]})", "2 distances for 1 vertices"},
      {R"({"positions": [[0,0,0,1]], "varyings": ^[{"name": "a", "values": [1]}]})", "where draws[0] has 0"},
      {R"({"mesh": ^3})", "expected a string"},
      {R"({"mesh": "a.obj", "transform": ^[1, 2]})", "of 2 numbers", "16 numbers"},
      {R"({"mesh": "a.obj", "varyings": [{"name": ^"colour"}]})", "a mesh has no 'colour'", "normal, position"},
      {R"({"mesh": "a.obj", "varyings": [{"name": "normal", "values": ^[]}]})", "brings its own values"},
  };
  for (const Bad& bad : table) {
    std::string storage;
    expectRefused(inDraw(storage, bad.text, bad.what, bad.hint));
  }
}

TEST(BadSceneFile, CamerasAreCheckedAtTheirFields) {
  const Bad table[] = {
      {"^{}", "without a projection"},
      {R"(^{"perspective": {}, "orthographic": {}})", "two projections"},
      {R"({"perspective": ^{"fovY": 60, "near": 1}})", "without 'far'"},
      {R"({"perspective": ^{"near": 1, "far": 2}})", "without 'fovY'"},
      {R"({"perspective": {"fovY": 60, "left": ^-1, "near": 1, "far": 2}})", "both fovY"},
      {R"({"perspective": {"fovY": ^180, "near": 1, "far": 2}})", "between 0 and 180"},
      {R"({"perspective": {"fovY": 60, "near": ^0, "far": 2}})", "near is not a positive distance"},
      {R"({"perspective": {"fovY": 60, "near": 1, "far": ^1}})", "equal"},
      {R"({"perspective": {"left": 0, "right": 1, "bottom": 0, "top": 1, "aspect": ^2, "near": 1, "far": 2}})",
       "'aspect' without"},
      {R"({"perspective": {"fovY": 60, "near": 1, "far": 2, "convention": ^"d3d"}})", "no convention",
       "vulkan, opengl"},
      {R"({"perspective": {"fovY": 60, "near": 1, "far": 2, "convention": ^"opengl"}})", "view volume",
       "negativeOneToOne"},
      {R"({"orthographic": {"left": 1, "right": ^1, "bottom": 0, "top": 1, "near": 1, "far": 2}})",
       "left and right are equal"},
      {R"({"lookAt": ^{"eye": [0,0,0]}, "perspective": {"fovY": 60, "near": 1, "far": 2}})", "without 'target'"},
      {R"({"lookAt": {"eye": [0,0,0], "target": ^[0,0,0]}, "perspective": {"fovY": 60, "near": 1, "far": 2}})",
       "same point"},
      {R"({"lookAt": {"eye": [0,0,0], "target": [0,2,0], "up": ^[0,3,0]}, "perspective": {"fovY": 60, "near": 1, "far": 2}})",
       "parallel"},
      {R"({"lookAt": {"eye": [0,^"x",0], "target": [0,2,0]}, "perspective": {"fovY": 60, "near": 1, "far": 2}})",
       "no number"},
  };
  for (const Bad& bad : table) {
    const std::string text = R"({"target": {"width": 8, "height": 8}, "draws": [{"positions": [[0,0,0,1]]}],)"
                             "\n\"camera\": " +
                             std::string(bad.text) + "}";
    expectRefused({text.c_str(), bad.what, bad.hint});
  }
  expectRefused({R"({"target": {"width": 8, "height": 8}, "draws": [{"space": ^"world", "positions": [[0,0,0]]}]})",
                 "without a camera"});
  expectRefused({R"({"target": {"width": 8, "height": 8}, "draws": [{"mesh": ^"a.obj"}]})", "without a camera"});
}

TEST(BadSceneFile, AMissingMeshIsAnInputOutputErrorAtItsName) {
  const std::string text = R"({"target": {"width": 8, "height": 8},
 "camera": {"perspective": {"fovY": 60, "near": 1, "far": 2}},
 "draws": [{"mesh": "no-such.obj"}]})";
  const Result<Scene> scene = parseScene(text, "some/folder/f.json");
  ASSERT_FALSE(scene.has_value());
  EXPECT_EQ(scene.error().code, ErrorCode::Io);
  EXPECT_EQ(scene.error().where, "some/folder/f.json:3:21");
  EXPECT_NE(scene.error().what.find("some/folder/no-such.obj"), std::string::npos);
}

TEST(BadSceneFile, DepthOfNestingAndNumberOfFieldsAreLimited) {
  const Result<Scene> deep = parseScene(std::string(1000000, '['), "f.json");
  ASSERT_FALSE(deep.has_value());
  EXPECT_EQ(deep.error().where, "f.json:1:65");
  EXPECT_NE(deep.error().what.find("deep"), std::string::npos);
  std::string wide = "{";
  for (int i = 0; i < 100000; ++i) wide += fmt::format("\"{}\": 0,", i);
  const Result<Scene> many = parseScene(wide, "f.json");
  ASSERT_FALSE(many.has_value());
  EXPECT_NE(many.error().what.find("more than 64 fields"), std::string::npos);
}

TEST(BadSceneFile, EveryTruncationOfASoundFileIsRefused) {
  const std::string text = R"({"target": {"width": 8, "height": 8}, "name": "tr\u00e4",
    "draws": [{"positions": [[0, -1.5e-3, "0x1p3", 1]], "indices": [0], "varyings": [{"name": "a", "values": [1]}]}]})";
  ASSERT_TRUE(parseScene(text, "f.json").has_value());
  for (size_t length = 0; length < text.size(); ++length) {
    const Result<Scene> scene = parseScene(text.substr(0, length), "f.json");
    ASSERT_FALSE(scene.has_value()) << length;
    EXPECT_TRUE(scene.error().where.starts_with("f.json:")) << scene.error().where;
  }
}

TEST(BadSceneFile, EverySingleByteChangeIsAcceptedOrRefusedButNeverCrashes) {
  const std::string text =
      R"({"target": {"width": 8, "height": 8}, "draws": [{"positions": [[0, -1.5e-3, "0x1p3", 1]], "indices": [0]}]})";
  size_t refused = 0;
  for (size_t at = 0; at < text.size(); ++at) {
    for (int byte = 0; byte < 256; ++byte) {
      std::string changed = text;
      changed[at] = static_cast<char>(byte);
      const Result<Scene> scene = parseScene(changed, "f.json");
      if (!scene) {
        ++refused;
        ASSERT_FALSE(scene.error().what.empty());
      } else {
        ASSERT_TRUE(validate(*scene).has_value());
      }
    }
  }
  EXPECT_GT(refused, text.size() * 128);
}

TEST(BadSceneFile, MissingFilesFoldersAndHugeFilesAreNamed) {
  const Result<Scene> missing = loadScene("no/such/file.json");
  ASSERT_FALSE(missing.has_value());
  EXPECT_EQ(missing.error().code, ErrorCode::Io);
  EXPECT_EQ(missing.error().where, "no/such/file.json");
  const Result<Scene> folder = loadScene(testing::TempDir());
  ASSERT_FALSE(folder.has_value());
  EXPECT_EQ(folder.error().code, ErrorCode::Io);
  EXPECT_NE(folder.error().what.find("folder"), std::string::npos);
  const std::string huge = testing::TempDir() + "huge.scene.json";
  std::ofstream(huge) << "{";
  std::filesystem::resize_file(huge, (uint64_t{256} << 20) + 1);  // sparse
  const Result<Scene> large = loadScene(huge);
  std::filesystem::remove(huge);
  ASSERT_FALSE(large.has_value());
  EXPECT_EQ(large.error().code, ErrorCode::BadInput);
  EXPECT_NE(large.error().what.find("256 MiB"), std::string::npos);
}

}  // namespace
}  // namespace rasterdiff
