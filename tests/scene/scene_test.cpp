// validate(), assembly counts and needs: what a renderer may rely on.
#include "scene/scene.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "scene/needs.hpp"
#include "scene/sample_locations.hpp"

namespace rasterdiff {
namespace {

Scene valid() {
  Scene scene;
  scene.name = "family/scene";
  scene.target = {.width = 8, .height = 4};
  scene.viewport = {0, 0, 8, 4, 0, 1};
  Draw& draw = scene.draws.emplace_back();
  draw.positions = {{0, 0, 0, 1}, {1, 0, 0, 1}, {0, 1, 0, 1}};
  draw.varyings = {{.name = "a", .components = 2, .values = {0, 1, 2, 3, 4, 5}}};
  return scene;
}

TEST(Validate, ASoundSceneIsAccepted) {
  const auto result = validate(valid());
  EXPECT_TRUE(result.has_value());
}

struct Mistake {
  const char* where;
  std::function<void(Scene&)> make;
};

TEST(Validate, EachMistakeIsRefusedAtItsField) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN(), kInf = std::numeric_limits<float>::infinity();
  const Mistake mistakes[] = {
      {"name", [](Scene& s) { s.name = "../up"; }},
      {"name", [](Scene& s) { s.name = "/absolute"; }},
      {"name", [](Scene& s) { s.name = "a//b"; }},
      {"name", [](Scene& s) { s.name = "a\nb"; }},
      {"name", [](Scene& s) { s.name = std::string(201, 'x'); }},
      {"target.width", [](Scene& s) { s.target.width = 0; }},
      {"target.height", [](Scene& s) { s.target.height = 16385; }},
      {"target.samples", [](Scene& s) { s.target.samples = 3; }},
      {"target.samples", [](Scene& s) { s.target.samples = 0; }},
      {"target.depthClearValue", [](Scene& s) { s.target.depthClearValue = 0.5f; }},
      {"target.depthClearValue", [=](Scene& s) { s.target.depthClearValue = kNan; }},
      {"viewport.width", [](Scene& s) { s.viewport.width = 0; }},
      {"viewport.width", [=](Scene& s) { s.viewport.width = kInf; }},
      {"viewport.height", [](Scene& s) { s.viewport.height = 0; }},
      {"viewport.height", [=](Scene& s) { s.viewport.height = kNan; }},
      {"viewport.x", [](Scene& s) { s.viewport.x = 40000; }},
      {"viewport.x", [=](Scene& s) { s.viewport.x = kNan; }},
      {"viewport.y", [](Scene& s) { s.viewport.y = -40000; }},
      {"viewport.minDepth", [](Scene& s) { s.viewport.minDepth = -0.5f; }},
      {"viewport.maxDepth", [=](Scene& s) { s.viewport.maxDepth = kNan; }},
      {"scissor.x",
       [](Scene& s) {
         s.scissor = {-1, 0, 4, 4};
       }},
      {"scissor.width",
       [](Scene& s) {
         s.scissor = {0, 0, 0, 4};
       }},
      {"scissor.height",
       [](Scene& s) {
         s.scissor = {0, 1, 4, 0x7fffffff};
       }},
      {"state.topology", [](Scene& s) { s.state.topology = static_cast<PrimitiveTopology>(9); }},
      {"state.depthTestEnable", [](Scene& s) { s.state.depthTestEnable = true; }},
      {"state.depthWriteEnable", [](Scene& s) { s.state.depthWriteEnable = true; }},
      {"draws", [](Scene& s) { s.draws.clear(); }},
      {"draws[0].positions", [](Scene& s) { s.draws[0].positions.clear(); }},
      {"draws[0].positions[1]", [=](Scene& s) { s.draws[0].positions[1].w = kNan; }},
      {"draws[0].positions[2]", [=](Scene& s) { s.draws[0].positions[2].x = -kInf; }},
      {"draws[0].indices[2]",
       [](Scene& s) {
         s.draws[0].indices = {0, 1, 3};
       }},
      {"draws[0].varyings[0].name", [](Scene& s) { s.draws[0].varyings[0].name = "a/b"; }},
      {"draws[0].varyings[0].name", [](Scene& s) { s.draws[0].varyings[0].name = "depth"; }},
      {"draws[0].varyings[0].values", [](Scene& s) { s.draws[0].varyings[0].values.pop_back(); }},
      {"draws[0].varyings[0].values", [](Scene& s) { s.draws[0].varyings[0].components = 5; }},
      {"draws[0].varyings[0].values[1][1]", [=](Scene& s) { s.draws[0].varyings[0].values[3] = kInf; }},
      {"draws[0].varyings[1].name", [](Scene& s) { s.draws[0].varyings.push_back(s.draws[0].varyings[0]); }},
      {"draws[0].varyings", [](Scene& s) { s.draws[0].varyings.resize(9); }},
      {"draws[1].varyings",
       [](Scene& s) {
         s.draws.push_back(s.draws[0]);
         s.draws[1].varyings.clear();
       }},
      {"draws[1].varyings[0]",
       [](Scene& s) {
         s.draws.push_back(s.draws[0]);
         s.draws[1].varyings[0].interpolation = Interpolation::flat;
       }},
      {"target.supersample", [](Scene& s) { s.target.supersample = 0; }},
      {"target.supersample", [](Scene& s) { s.target.supersample = 33; }},
      {"target.width",
       [](Scene& s) {
         s.target.width = 1024;
         s.target.supersample = 17;
       }},
      {"viewport.width",
       [](Scene& s) {
         s.viewport.width = 10000;
         s.target.supersample = 2;
       }},
      {"target.resolve", [](Scene& s) { s.target.resolve = true; }},
      {"target.resolve",
       [](Scene& s) {
         s.target.resolve = true;
         s.target.samples = 4;
         s.draws[0].varyings.clear();
       }},
      {"target.depthFormat", [](Scene& s) { s.target.depthFormat = static_cast<DepthFormat>(127); }},
      {"furtherViewports", [](Scene& s) { s.furtherViewports.resize(16); }},
      {"furtherViewports[0].viewport.width", [](Scene& s) { s.furtherViewports.resize(1); }},
      {"furtherViewports[0].scissor.height",
       [](Scene& s) {
         s.furtherViewports = {{{0, 0, 8, 8, 0, 1}, Rect2D{0, 0, 1, 0}}};
       }},
      {"state.polygonMode", [](Scene& s) { s.state.polygonMode = static_cast<PolygonMode>(3); }},
      {"state.polygonMode",
       [](Scene& s) {
         s.state.topology = PrimitiveTopology::LINE_LIST;
         s.state.polygonMode = PolygonMode::POINT;
       }},
      {"state.lineRasterizationMode",
       [](Scene& s) { s.state.lineRasterizationMode = static_cast<LineRasterizationMode>(4); }},
      {"state.lineWidth", [](Scene& s) { s.state.lineWidth = 0; }},
      {"state.lineWidth", [=](Scene& s) { s.state.lineWidth = kInf; }},
      {"state.pointSize", [](Scene& s) { s.state.pointSize = -1; }},
      {"state.pointSize", [=](Scene& s) { s.state.pointSize = kNan; }},
      {"state.lineStippleFactor", [](Scene& s) { s.state.lineStippleFactor = 0; }},
      {"state.lineStippleFactor", [](Scene& s) { s.state.lineStippleFactor = 257; }},
      {"state.lineStippleFactor",
       [](Scene& s) {
         s.state.topology = PrimitiveTopology::LINE_LIST;
         s.state.stippledLineEnable = true;
         s.state.lineStippleFactor = 129;
         s.target.supersample = 2;
       }},
      {"state.stippledLineEnable", [](Scene& s) { s.state.stippledLineEnable = true; }},
      {"state.depthBiasConstantFactor", [=](Scene& s) { s.state.depthBiasConstantFactor = kInf; }},
      {"state.depthBiasClamp", [=](Scene& s) { s.state.depthBiasClamp = kNan; }},
      {"state.depthBiasSlopeFactor", [=](Scene& s) { s.state.depthBiasSlopeFactor = -kInf; }},
      {"state.minSampleShading", [](Scene& s) { s.state.minSampleShading = 1.25f; }},
      {"state.minSampleShading", [=](Scene& s) { s.state.minSampleShading = kNan; }},
      {"state.alphaToCoverageEnable", [](Scene& s) { s.state.alphaToCoverageEnable = true; }},
      {"state.alphaToCoverageEnable",
       [](Scene& s) {
         s.state.alphaToCoverageEnable = true;
         s.target.samples = 4;
       }},
      {"state.shaderSampleMask", [](Scene& s) { s.state.shaderSampleMask = static_cast<ShaderSampleMask>(3); }},
      {"state.shaderSampleMask",
       [](Scene& s) {
         s.target.samples = 4;
         s.state.shaderSampleMask = ShaderSampleMask::INPUT_SHIFTED;
         s.draws[0].varyings[0].interpolation = Interpolation::sample;
       }},
      {"draws[0].shaderSampleMaskBits", [](Scene& s) { s.draws[0].shaderSampleMaskBits = 1; }},
      {"builtIns[1]", [](Scene& s) { s.builtIns = {BuiltIn::FragCoord, BuiltIn::FragCoord}; }},
      {"builtIns[0]", [](Scene& s) { s.builtIns = {BuiltIn::PointCoord}; }},
      {"builtIns[0]", [](Scene& s) { s.builtIns = {static_cast<BuiltIn>(6)}; }},
      {"draws[0].varyings[0].name",
       [](Scene& s) {
         s.builtIns = {BuiltIn::FragCoord};
         s.draws[0].varyings[0].name = "FragCoord";
       }},
      {"draws[0].varyings[0].interpolation",
       [](Scene& s) { s.draws[0].varyings[0].interpolation = static_cast<Interpolation>(6); }},
      {"draws[0].varyings[0].offset", [](Scene& s) { s.draws[0].varyings[0].offsetX = 0.25f; }},
      {"draws[0].varyings[0].offset",
       [=](Scene& s) {
         s.draws[0].varyings[0].interpolation = Interpolation::offset;
         s.draws[0].varyings[0].offsetY = kNan;
       }},
      {"draws[0].varyings[0].offset",
       [](Scene& s) {
         s.draws[0].varyings[0].interpolation = Interpolation::offset;
         s.draws[0].varyings[0].offsetY = 0.5f;
       }},
      {"draws[1].varyings[0].offset",
       [](Scene& s) {
         s.draws[0].varyings[0].interpolation = Interpolation::offset;
         s.draws.push_back(s.draws[0]);
         s.draws[1].varyings[0].offsetX = 0.25f;
       }},
      {"draws[0].indices[1]",
       [](Scene& s) {
         s.draws[0].indices = {0, kRestartIndex};
       }},
      {"draws[0].indices[1]",
       [](Scene& s) {
         s.state.primitiveRestartEnable = true;
         s.draws[0].indices = {0, kRestartIndex - 1};
       }},
      {"draws[0].viewportIndex", [](Scene& s) { s.draws[0].viewportIndex = 1; }},
      {"draws[0].pointSizes", [](Scene& s) { s.draws[0].pointSizes = {1}; }},
      {"draws[0].pointSizes[2]", [](Scene& s) { s.draws[0].pointSizes = {1, 2, 0}; }},
      {"draws[0].clipDistances", [](Scene& s) { s.draws[0].clipDistanceCount = 1; }},
      {"draws[0].clipDistances", [](Scene& s) { s.draws[0].clipDistances = {1, 2, 3}; }},
      {"draws[0].clipDistances[1][0]",
       [=](Scene& s) {
         s.draws[0].clipDistanceCount = 1;
         s.draws[0].clipDistances = {1, kNan, 3};
       }},
      {"draws[0].cullDistances",
       [](Scene& s) {
         s.draws[0].cullDistanceCount = 9;
         s.draws[0].cullDistances.resize(27);
       }},
      {"draws[0].cullDistances",
       [](Scene& s) {
         s.draws[0].clipDistanceCount = 5;
         s.draws[0].clipDistances.resize(15);
         s.draws[0].cullDistanceCount = 4;
         s.draws[0].cullDistances.resize(12);
       }},
      {"draws[1].cullDistances",
       [](Scene& s) {
         s.draws.push_back(s.draws[0]);
         s.draws[1].cullDistanceCount = 1;
         s.draws[1].cullDistances.resize(3);
       }},
      {"target",
       [](Scene& s) {
         s.target = {.width = 16384, .height = 16384, .samples = 1};
         s.builtIns = {BuiltIn::FragCoord};
       }},
      {"target",
       [](Scene& s) {
         s.target = {.width = 16384, .height = 16384, .samples = 4, .depthFormat = DepthFormat::D32_SFLOAT};
       }},
  };
  for (const Mistake& mistake : mistakes) {
    Scene scene = valid();
    mistake.make(scene);
    const auto result = validate(scene);
    ASSERT_FALSE(result.has_value()) << mistake.where;
    EXPECT_EQ(result.error().where, mistake.where) << result.error().what;
    EXPECT_EQ(result.error().code, ErrorCode::BadInput);
    EXPECT_FALSE(result.error().what.empty());
  }
}

TEST(Validate, NonFiniteNumbersPassWhereTheSceneSaysSo) {
  Scene scene = valid();
  scene.allowNonFinite = true;
  scene.draws[0].positions[0].x = std::numeric_limits<float>::quiet_NaN();
  scene.draws[0].varyings[0].values[0] = std::numeric_limits<float>::infinity();
  EXPECT_TRUE(validate(scene).has_value());
}

TEST(Validate, LegalOddThingsPass) {
  Scene scene = valid();
  scene.viewport = {-3.5f, 4, 8, -4, 1, 0};
  scene.scissor = {100, 100, 1, 1};
  scene.draws[0].indices.emplace();
  EXPECT_TRUE(validate(scene).has_value());
  scene.state.primitiveRestartEnable = true;
  scene.draws[0].indices = {kRestartIndex, 0, kRestartIndex};
  scene.state.topology = PrimitiveTopology::LINE_STRIP;
  scene.state.cullMode = CullMode::FRONT_AND_BACK;
  EXPECT_TRUE(validate(scene).has_value());
}

TEST(PrimitiveCount, OnlyWholePrimitivesCount) {
  using enum PrimitiveTopology;
  EXPECT_EQ(primitiveCount(TRIANGLE_LIST, 0), 0u);
  EXPECT_EQ(primitiveCount(TRIANGLE_LIST, 5), 1u);
  EXPECT_EQ(primitiveCount(TRIANGLE_LIST, 6), 2u);
  EXPECT_EQ(primitiveCount(TRIANGLE_STRIP, 2), 0u);
  EXPECT_EQ(primitiveCount(TRIANGLE_STRIP, 5), 3u);
  EXPECT_EQ(primitiveCount(TRIANGLE_FAN, 1), 0u);
  EXPECT_EQ(primitiveCount(TRIANGLE_FAN, 3), 1u);
}

TEST(PrimitiveCount, PointsAndLinesCountToo) {
  using enum PrimitiveTopology;
  EXPECT_EQ(primitiveCount(POINT_LIST, 5), 5u);
  EXPECT_EQ(primitiveCount(LINE_LIST, 5), 2u);
  EXPECT_EQ(primitiveCount(LINE_STRIP, 0), 0u);
  EXPECT_EQ(primitiveCount(LINE_STRIP, 1), 0u);
  EXPECT_EQ(primitiveCount(LINE_STRIP, 5), 4u);
}

TEST(PrimitiveCount, ARestartEndsAPrimitive) {
  State state;
  state.topology = PrimitiveTopology::TRIANGLE_STRIP;
  state.primitiveRestartEnable = true;
  Draw draw;
  draw.positions.resize(8);
  EXPECT_EQ(primitiveCount(state, draw), 6u) << "not indexed: nothing restarts";
  draw.indices = {0, 1, 2, 3, kRestartIndex, 4, 5, kRestartIndex, kRestartIndex, 5, 6, 7};
  EXPECT_EQ(primitiveCount(state, draw), 3u);
  state.topology = PrimitiveTopology::TRIANGLE_LIST;
  EXPECT_EQ(primitiveCount(state, draw), 2u);
}

TEST(VertexCount, IndicesCountWhereThereAreAny) {
  Draw draw;
  draw.positions.resize(4);
  EXPECT_EQ(vertexCount(draw), 4u);
  draw.indices = {0, 1};
  EXPECT_EQ(vertexCount(draw), 2u);
}

TEST(NeedsOf, ACoverageOnlySceneNeedsNothingElse) {
  Scene scene = valid();
  scene.draws[0].varyings.clear();
  const SceneNeeds needs = needsOf(scene);
  EXPECT_FALSE(needs.depth);
  EXPECT_EQ(needs.varyings, 0u);
  EXPECT_FALSE(needsPerspective(scene));
  EXPECT_FALSE(needsClipping(scene));
  EXPECT_EQ(needs.samples, 1u);
}

TEST(NeedsOf, EachNeedFollowsFromTheScene) {
  Scene scene = valid();
  EXPECT_EQ(needsOf(scene).varyings, 1u);
  scene.target.depthFormat = DepthFormat::D32_SFLOAT;
  EXPECT_TRUE(needsOf(scene).depth);
  scene.draws[0].positions[0].w = 2;
  EXPECT_TRUE(needsPerspective(scene));
  EXPECT_FALSE(needsClipping(scene));
}

TEST(NeedsOf, BuiltInsAndResolveArePlanesOfTheirOwn) {
  Scene scene = valid();
  scene.builtIns = {BuiltIn::FragCoord, BuiltIn::SampleMask};
  scene.target.resolve = true;
  EXPECT_EQ(needsOf(scene).varyings, 1u);
  EXPECT_EQ(needsOf(scene).builtIns, 2u);
  EXPECT_TRUE(needsOf(scene).resolve);
  EXPECT_FALSE(needsOf(valid()).resolve);
}

TEST(NeedsOf, NegativeClipDistancesClipAndDepthsDoNotWithoutDepthClip) {
  Scene scene = valid();
  scene.draws[0].clipDistanceCount = 1;
  scene.draws[0].clipDistances = {0, -0.0f, 1};
  EXPECT_FALSE(needsClipping(scene));
  scene.draws[0].clipDistances = {0, -1e-30f, 1};
  EXPECT_TRUE(needsClipping(scene));
  scene = valid();
  scene.draws[0].positions[0].z = 2;
  EXPECT_TRUE(needsClipping(scene));
  scene.state.depthClampEnable = true;
  EXPECT_FALSE(needsClipping(scene));
  scene.state.depthClipEnable = true;
  EXPECT_TRUE(needsClipping(scene));
}

TEST(NeedsOf, ClippingIsAboutTheSixPlanesAndTheirBoundaryIsInside) {
  const auto clips = [](ClipPosition p, bool negativeOneToOne = false) {
    Scene scene = valid();
    scene.state.negativeOneToOne = negativeOneToOne;
    scene.draws[0].positions[1] = p;
    return needsClipping(scene);
  };
  EXPECT_FALSE(clips({-1, 1, 0, 1}));
  EXPECT_FALSE(clips({2, -2, 2, 2}));
  EXPECT_TRUE(clips({-1.0000001f, 0, 0, 1}));
  EXPECT_TRUE(clips({0, 1.0000001f, 0, 1}));
  EXPECT_TRUE(clips({0, 0, -1e-40f, 1}));
  EXPECT_TRUE(clips({0, 0, 1.0000001f, 1}));
  EXPECT_TRUE(clips({0, 0, 0, -1}));
  EXPECT_FALSE(clips({0, 0, -1, 1}, true));
  EXPECT_TRUE(clips({0, 0, -1.0000001f, 1}, true));
  EXPECT_TRUE(clips({std::nanf(""), 0, 0, 1}));
}

TEST(StandardSampleLocations, EveryTableHasItsCountAndNoSampleTwice) {
  for (uint32_t samples : {1u, 2u, 4u, 8u, 16u}) {
    const auto table = standardSampleLocations(samples);
    ASSERT_EQ(table.size(), samples);
    for (size_t i = 0; i < table.size(); ++i) {
      EXPECT_LT(table[i].x, 16);
      EXPECT_LT(table[i].y, 16);
      for (size_t j = 0; j < i; ++j) EXPECT_NE(table[i], table[j]);
    }
  }
  EXPECT_TRUE(standardSampleLocations(3).empty());
}

}  // namespace
}  // namespace rasterdiff
