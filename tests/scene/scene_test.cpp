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
  EXPECT_FALSE(needs.perspective);
  EXPECT_FALSE(needs.clipping);
  EXPECT_EQ(needs.samples, 1u);
}

TEST(NeedsOf, EachNeedFollowsFromTheScene) {
  Scene scene = valid();
  EXPECT_EQ(needsOf(scene).varyings, 1u);
  scene.target.depthFormat = DepthFormat::D32_SFLOAT;
  EXPECT_TRUE(needsOf(scene).depth);
  scene.draws[0].positions[0].w = 2;
  EXPECT_TRUE(needsOf(scene).perspective);
  EXPECT_FALSE(needsOf(scene).clipping);
}

TEST(NeedsOf, ClippingIsAboutTheSixPlanesAndTheirBoundaryIsInside) {
  const auto clips = [](ClipPosition p, bool negativeOneToOne = false) {
    Scene scene = valid();
    scene.state.negativeOneToOne = negativeOneToOne;
    scene.draws[0].positions[1] = p;
    return needsOf(scene).clipping;
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
