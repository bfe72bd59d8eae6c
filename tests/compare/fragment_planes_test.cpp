// compare() on what the fragment side adds: built-ins, resolved planes, cleared fixed-point depth, alpha to coverage.
#include <gtest/gtest.h>

#include <cmath>

#include "harness/compare/compare.hpp"
#include "tests/support/scenes.hpp"

namespace rasterdiff::harness {
namespace {

using rasterizer::Rules;

Rules openRules() { return Rules::specification(Limits{}); }

// Half of the target, four samples, one flat colour of four components.
Scene halfScene(float alpha = 1) {
  Scene scene = testing::sceneOf({{0, 0}, {4.5, 0}, {4.5, 8}, {0, 8}}, 8, 4);
  scene.state.topology = PrimitiveTopology::TRIANGLE_FAN;
  Varying colour;
  colour.name = "colour";
  colour.interpolation = Interpolation::flat;
  for (int i = 0; i < 4; ++i) {
    for (const float component : {0.25F, 3.0F, -1.0F, alpha}) colour.values.push_back(component);
  }
  scene.draws[0].varyings = {colour};
  return scene;
}

const ValueStats& planeOf(const SceneResult& result, const std::string& name) {
  for (const ValueStats& stats : result.values) {
    if (stats.name == name) return stats;
  }
  static const ValueStats kNone;
  ADD_FAILURE() << "no plane " << name;
  return kNone;
}

TEST(ComparedBuiltIns, AreJudgedAsPlanesOfTheirName) {
  Scene scene = halfScene();
  scene.builtIns = {BuiltIn::SampleId, BuiltIn::SampleMask};
  const Frame reference = *rasterizer::render(scene, openRules());
  Frame actual = *rasterizer::render(scene, testing::referenceRules());
  EXPECT_EQ(compare(scene, openRules(), reference, actual)->verdict, Verdict::Same);
  actual.varyings[1].values.at(1, 2, 3) = 2;
  const SceneResult result = *compare(scene, openRules(), reference, actual);
  EXPECT_EQ(result.verdict, Verdict::Differs);
  EXPECT_EQ(differingPlanes(result), std::vector<std::string>{"SampleId"});
}

TEST(ComparedResolve, IsTheMeanOfTheSamplesThatTheSameSideDrew) {
  Scene scene = halfScene();
  scene.target.resolve = true;
  const Frame reference = *rasterizer::render(scene, openRules());
  Frame actual = *rasterizer::render(scene, testing::referenceRules());
  EXPECT_EQ(compare(scene, openRules(), reference, actual)->verdict, Verdict::Same);
  // A rounding more: allowed, and named.
  float& mean = actual.resolved[0].values.at(4, 1, 0, 1);
  ASSERT_EQ(mean, 1.5F);
  mean = std::nextafter(mean, 2.0F);
  SceneResult result = *compare(scene, openRules(), reference, actual);
  EXPECT_EQ(result.verdict, Verdict::Allowed);
  EXPECT_EQ(result.freedoms.count("resolve-rounding"), 1U);
  // One sample for the mean of all.
  mean = 3;
  result = *compare(scene, openRules(), reference, actual);
  EXPECT_EQ(result.verdict, Verdict::Differs);
  EXPECT_EQ(differingPlanes(result), std::vector<std::string>{"colour.resolved"});
  EXPECT_EQ(planeOf(result, "colour.resolved").differing, 1U);
}

TEST(ComparedResolve, NeedsTheSamePlanesOnBothSides) {
  Scene scene = halfScene();
  scene.target.resolve = true;
  const Frame reference = *rasterizer::render(scene, openRules());
  Frame actual = reference;
  actual.resolved.clear();
  EXPECT_FALSE(compare(scene, openRules(), reference, actual));
}

// 0.5 lies between two steps of 16 bits: an attachment may be cleared to either.
TEST(ComparedDepth, OfAClearedFixedPointAttachmentMayBeEitherStep) {
  Scene scene = halfScene();
  scene.target.depthFormat = DepthFormat::D16_UNORM;
  scene.target.depthClearValue = 0.5F;
  const Frame reference = *rasterizer::render(scene, openRules());
  Frame actual = *rasterizer::render(scene, testing::referenceRules());
  float& depth = actual.depth->at(7, 7, 0);
  for (const auto& [k, legal] : {std::pair{32767, true}, {32768, true}, {32766, false}, {32769, false}}) {
    depth = static_cast<float>(k / 65535.0);
    EXPECT_EQ(compare(scene, openRules(), reference, actual)->verdict == Verdict::Differs, !legal) << k;
  }
}

TEST(ComparedAlpha, BetweenZeroAndOneAllowsAnySample) {
  const Scene scene = halfScene(0.5F);
  Scene alphaScene = scene;
  alphaScene.state.alphaToCoverageEnable = true;
  for (const Rules& rules : {testing::referenceRules(), openRules()}) {
    const Frame reference = *rasterizer::render(alphaScene, rules);
    for (const bool all : {false, true}) {
      // An algorithm that keeps everything, and one that keeps nothing.
      Scene nothing = scene;
      nothing.state.sampleMask = 0;
      const Frame actual = *rasterizer::render(all ? scene : nothing, testing::referenceRules());
      const SceneResult result = *compare(alphaScene, rules, reference, actual);
      EXPECT_EQ(result.verdict, Verdict::Allowed);
      EXPECT_EQ(result.freedoms.count("alpha-to-coverage"), 1U);
    }
  }
}

TEST(ComparedAlpha, OfZeroAndOfOneAllowsOneAnswer) {
  for (const float alpha : {0.0F, 1.0F}) {
    Scene alphaScene = halfScene(alpha);
    alphaScene.state.alphaToCoverageEnable = true;
    Scene opposite = halfScene(alpha);
    if (alpha > 0) opposite.state.sampleMask = 0;
    const Frame reference = *rasterizer::render(alphaScene, openRules());
    EXPECT_EQ(compare(alphaScene, openRules(), reference, *rasterizer::render(opposite, testing::referenceRules()))->verdict,
              Verdict::Differs);
  }
}

}  // namespace
}  // namespace rasterdiff::harness
