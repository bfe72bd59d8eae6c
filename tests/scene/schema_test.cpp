// scene.schema.json says what the loader does, as far as a schema can.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

// g++ 12 sees an overlapping copy in its own std::string::replace (GCC bug 105651).
#pragma GCC diagnostic ignored "-Wrestrict"
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

#include "scene/catalogue/catalogue.hpp"
#include "scene/file/enum_names.hpp"
#include "scene/file/scene_file.hpp"

namespace rasterdiff {
namespace {

nlohmann::json schemaJson() {
  std::ifstream file(RASTERDIFF_SOURCE_DIR "/scene/file/scene.schema.json");
  return nlohmann::json::parse(file);
}

class SchemaTest : public testing::Test {
 protected:
  SchemaTest() {
    valijson::SchemaParser parser(valijson::SchemaParser::kDraft7);
    parser.populateSchema(valijson::adapters::NlohmannJsonAdapter(json_), schema_);
  }

  bool accepts(const std::string& text) {
    const nlohmann::json document = nlohmann::json::parse(text);
    valijson::Validator validator;
    return validator.validate(schema_, valijson::adapters::NlohmannJsonAdapter(document), nullptr);
  }

  nlohmann::json json_ = schemaJson();
  valijson::Schema schema_;
};

TEST_F(SchemaTest, WrittenScenesConform) {
  for (const CatalogueEntry& entry : catalogue()) {
    if (entry.name.starts_with("mesh/") || entry.name.starts_with("tiny/")) continue;  // large
    const Result<Scene> scene = entry.make();
    ASSERT_TRUE(scene.has_value()) << entry.name;
    EXPECT_TRUE(accepts(writeScene(*scene))) << entry.name;
  }
}

constexpr const char* kTarget = R"("target": {"width": 8, "height": 8})";
constexpr const char* kDraws = R"("draws": [{"positions": [[0, 0, 0, 1]]}])";

std::string scene(const std::string& more, const std::string& target = kTarget, const std::string& draws = kDraws) {
  return "{" + target + "," + draws + (more.empty() ? "" : "," + more) + "}";
}

std::string withDraw(const std::string& draw) {
  return scene(R"("camera": {"orthographic": {"left": -1, "right": 1, "bottom": -1, "top": 1, "near": 0, "far": 1}})",
               kTarget, "\"draws\": [" + draw + "]");
}

TEST_F(SchemaTest, WhatTheLoaderAcceptsConforms) {
  const std::string texts[] = {
      scene(""),
      scene(R"("$schema": "x", "name": "n", "allowNonFinite": false)"),
      scene(R"("viewport": {"x": -0.5, "width": "0x1p5", "height": -8, "minDepth": 1, "maxDepth": 0})"),
      scene(R"("scissor": {"x": 0, "width": 8, "height": 8})"),
      scene(R"("state": {"topology": "TRIANGLE_FAN", "negativeOneToOne": true})"),
      scene(
          R"("camera": {"lookAt": {"eye": [0,0,"0x1p2"], "target": [0,0,0], "up": [0,1,0]}, "perspective": {"fovY": 60, "near": 0.1, "far": 10, "convention": "vulkan"}})"),
      scene(R"("camera": {"perspective": {"left": -1, "right": 1, "bottom": -1, "top": 1, "near": 0.1, "far": 10}})"),
      scene("",
            R"("target": {"width": 8, "height": 8, "samples": 16, "depthFormat": "D32_SFLOAT", "depthClearValue": 0})"),
      withDraw(R"({"space": "pixels", "positions": [[1, 2], [1, 2, 0.5], [1, 2, 0.5, 1]], "indices": [0, 1, 2]})"),
      withDraw(R"({"space": "world", "positions": [[1, 2, "0x.8p0"]]})"),
      withDraw(R"({"points": "0,0 4,0 4,4"})"),
      scene("", R"("target": {"width": 8, "height": 8, "samples": 2, "sampleLocations": {"sampleLocationsPerPixel": 2, "sampleLocationGridSize": [1, 2], "sampleLocations": [[0, "0x1p-1"], [0, 0], [-1, 2], [0.5, 0.5]]}})"),
      withDraw(R"({"points": "0,0 4,0 4,4", "fillRule": "evenodd", "z": "0x.8p0", "varyings": [{"name": "position"}]})"),
      withDraw(
          R"({"positions": [[0, 0, 0, 1], [0, 0, 0, 1]], "pointSizes": [1, "0x1p-1"], "clipDistances": [[1, 0], [-1, 2]], "cullDistances": [1, 0], "varyings": [{"name": "a", "interpolation": "offset", "offset": [-0.5, "0x1p-4"], "values": [1, 2]}]})"),
      scene(
          R"("furtherViewports": [{"viewport": {"width": 8, "height": -8}, "scissor": {"width": 1, "height": 1}}], "builtIns": ["FragCoord", "SampleMask"])"),
      scene(
          R"("state": {"topology": "LINE_STRIP", "primitiveRestartEnable": true, "lineWidth": 2.5, "lineRasterizationMode": "BRESENHAM", "stippledLineEnable": true, "lineStippleFactor": 256, "lineStipplePattern": 3855, "depthClipEnable": false, "sampleMask": 4294967295})"),
      R"({"target": {"width": 8, "height": 8, "samples": 4}, "state": {"shaderSampleMask": "CONSTANT"}, "draws": [{"positions": [[1, 2, 3, 4]], "shaderSampleMaskBits": 6}, {"points": "0,0 4,0 4,4", "shaderSampleMaskBits": 1}]})",
      withDraw(
          R"({"positions": [[1, 2, 3, 4]], "varyings": [{"name": "a-b_C", "values": [[1, 2]]}, {"name": "b", "interpolation": "flat", "values": [3]}]})"),
  };
  for (const std::string& text : texts) {
    const Result<Scene> read = parseScene(text, "x");
    EXPECT_TRUE(read.has_value()) << text << "\n" << (read ? "" : read.error().where + read.error().what);
    EXPECT_TRUE(accepts(text)) << text;
  }
}

TEST_F(SchemaTest, PositionsMayBeTheNameOfAFile) {
  EXPECT_TRUE(accepts(withDraw(R"({"space": "pixels", "positions": "points.npy"})")));
}

TEST_F(SchemaTest, WhatItRefusesTheLoaderRefusesToo) {
  const std::string texts[] = {
      "[]",
      "{}",
      "3",
      scene("", kTarget, R"("draws": [])"),
      withDraw(R"({"points": "0,0 4,0 4,4", "svg": "a.svg"})"),
      withDraw(R"({"svg": "a.svg", "fillRule": "evenodd"})"),
      withDraw(R"({"points": "0,0 4,0 4,4", "fillRule": "parity"})"),
      withDraw(R"({"points": [0, 0]})"),
      scene(R"("nmae": "x")"),
      scene(R"("name": 3)"),
      scene("", R"("target": {"width": 0, "height": 8})"),
      scene("", R"("target": {"width": 8})"),
      scene("", R"("target": {"width": 8.5, "height": 8})"),
      scene("", R"("target": {"width": 20000, "height": 8})"),
      scene("", R"("target": {"width": 8, "height": 8, "samples": 3})"),
      scene("", R"("target": {"width": 8, "height": 8, "depthFormat": "S8_UINT"})"),
      scene("", R"("target": {"width": 8, "height": 8, "depthFormat": "D32_SFLOAT", "depthClearValue": 2})"),
      scene("", R"("target": {"width": 8, "height": 8, "supersample": 33})"),
      scene(R"("viewport": {"width": 8})"),
      scene(R"("viewport": {"width": 8, "height": 8, "minDepth": -1})"),
      scene(R"("viewport": {"width": "8", "height": 8})"),
      scene(R"("scissor": {"x": -1, "width": 8, "height": 8})"),
      scene(R"("scissor": {"width": 0, "height": 8})"),
      scene(R"("state": {"cullMode": "none"})"),
      scene(R"("state": {"depthTestEnable": 1})"),
      scene(R"("state": {"lineWidth": 0})"),
      scene(R"("state": {"pointSize": -1})"),
      scene(R"("state": {"lineStippleFactor": 257})"),
      scene(R"("state": {"lineStipplePattern": 65536})"),
      scene(R"("state": {"minSampleShading": 1.5})"),
      scene(R"("state": {"sampleMask": -1})"),
      scene(R"("state": {"shaderSampleMask": "SHIFTED"})"),
      scene(R"("state": {"blendEnable": true})"),
      scene(R"("furtherViewports": [{}])"),
      scene(R"("furtherViewports": [{"viewport": {"width": 8}}])"),
      scene(R"("builtIns": ["FragDepth"])"),
      scene(R"("builtIns": ["FragCoord", "FragCoord"])"),
      scene(R"("allowNonFinite": "yes")"),
      scene(R"("camera": {})"),
      scene(R"("camera": {"perspective": {"fovY": 60, "near": 1}})"),
      scene(R"("camera": {"perspective": {"near": 1, "far": 2}})"),
      scene(R"("camera": {"perspective": {"fovY": 60, "left": 1, "near": 1, "far": 2}})"),
      scene(
          R"("camera": {"perspective": {"left": 0, "right": 1, "bottom": 0, "top": 1, "aspect": 1, "near": 1, "far": 2}})"),
      scene(R"("camera": {"orthographic": {"left": 0, "right": 1, "bottom": 0, "top": 1, "near": 1}})"),
      scene(
          R"("camera": {"lookAt": {"eye": [0, 0], "target": [0, 0, 1]}, "perspective": {"fovY": 60, "near": 1, "far": 2}})"),
      withDraw("{}"),
      withDraw(R"({"positions": []})"),
      withDraw(R"({"positions": ""})"),
      withDraw(R"({"positions": [[0, 0, 0]]})"),
      withDraw(R"({"positions": [[0, 0, 0, 1, 2]]})"),
      withDraw(R"({"space": "world", "positions": [[0, 0]]})"),
      withDraw(R"({"space": "world", "positions": [[0, 0, 0, 1]]})"),
      withDraw(R"({"space": "pixels", "positions": [[0]]})"),
      withDraw(R"({"space": "ndc", "positions": [[0, 0, 0, 1]]})"),
      withDraw(R"({"positions": [[0, 0, 0, "1.5"]]})"),
      withDraw(R"({"positions": [[0, 0, 0, "0x"]]})"),
      withDraw(R"({"positions": [[0, 0, 0, null]]})"),
      withDraw(R"({"positions": [[0, 0, 0, 1]], "indices": [-1]})"),
      withDraw(R"({"positions": [[0, 0, 0, 1]], "indices": [0.5]})"),
      withDraw(R"({"positions": [[0, 0, 0, 1]], "transform": []})"),
      withDraw(R"({"positions": [[0, 0, 0, 1]], "pointSizes": [0]})"),
      withDraw(R"({"positions": [[0, 0, 0, 1]], "pointSizes": []})"),
      withDraw(R"({"positions": [[0, 0, 0, 1]], "clipDistances": [[1, 2, 3, 4, 5, 6, 7, 8, 9]]})"),
      withDraw(R"({"positions": [[0, 0, 0, 1]], "cullDistances": [[]]})"),
      withDraw(R"({"positions": [[0, 0, 0, 1]], "viewportIndex": 16})"),
      withDraw(
          R"({"positions": [[0, 0, 0, 1]], "varyings": [{"name": "a", "interpolation": "offset", "offset": [0.5, 0], "values": [1]}]})"),
      withDraw(R"({"positions": [[0, 0, 0, 1]], "varyings": [{"values": [1]}]})"),
      withDraw(R"({"positions": [[0, 0, 0, 1]], "varyings": [{"name": "a"}]})"),
      withDraw(R"({"positions": [[0, 0, 0, 1]], "varyings": [{"name": "a/b", "values": [1]}]})"),
      withDraw(R"({"positions": [[0, 0, 0, 1]], "varyings": [{"name": "a", "values": [[1, 2, 3, 4, 5]]}]})"),
      withDraw(
          R"({"positions": [[0, 0, 0, 1]], "varyings": [{"name": "a", "interpolation": "center", "values": [1]}]})"),
      withDraw(R"({"mesh": 3})"),
      withDraw(R"({"mesh": "a.obj", "transform": [1]})"),
      withDraw(R"({"mesh": "a.obj", "indices": [1]})"),
      withDraw(R"({"mesh": "a.obj", "varyings": [{"name": "uv"}]})"),
  };
  for (const std::string& text : texts) {
    EXPECT_FALSE(accepts(text)) << text;
    EXPECT_FALSE(parseScene(text, "x").has_value()) << text;
  }
}

template <class E>
void expectSameNames(const nlohmann::json& names) {
  ASSERT_EQ(names.size(), enumNames<E>().size());
  for (size_t i = 0; i < names.size(); ++i) EXPECT_EQ(names[i].get<std::string>(), enumNames<E>()[i].name);
}

TEST_F(SchemaTest, ItsEnumerantsAreTheLoaders) {
  const nlohmann::json& state = json_["properties"]["state"]["properties"];
  expectSameNames<PrimitiveTopology>(state["topology"]["enum"]);
  expectSameNames<PolygonMode>(state["polygonMode"]["enum"]);
  expectSameNames<LineRasterizationMode>(state["lineRasterizationMode"]["enum"]);
  expectSameNames<BuiltIn>(json_["properties"]["builtIns"]["items"]["enum"]);
  expectSameNames<CullMode>(state["cullMode"]["enum"]);
  expectSameNames<FrontFace>(state["frontFace"]["enum"]);
  expectSameNames<ProvokingVertexMode>(state["provokingVertexMode"]["enum"]);
  expectSameNames<CompareOp>(state["depthCompareOp"]["enum"]);
  expectSameNames<DepthFormat>(json_["properties"]["target"]["properties"]["depthFormat"]["enum"]);
  expectSameNames<Interpolation>(json_["definitions"]["interpolation"]["enum"]);
}

}  // namespace
}  // namespace rasterdiff
