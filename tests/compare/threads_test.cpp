// A comparison by several threads is the comparison by one.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "harness/compare/compare.hpp"
#include "harness/report/record.hpp"
#include "tests/support/scenes.hpp"

namespace rasterdiff::harness {
namespace {

Scene largeScene() {
  Scene scene = testing::sceneOf({{3, 5, 0.25}, {250, 9, 0.5}, {240, 250, 0.75}, {3, 5, 0.25}, {240, 250, 0.75}, {7, 240, 0.5}}, 256);
  scene.target.samples = 4;
  scene.target.depthFormat = DepthFormat::D32_SFLOAT;
  scene.state.depthTestEnable = scene.state.depthWriteEnable = true;
  scene.draws[0].varyings = {{"colour", Interpolation::smooth, 3, {0, 1, 2, 2, 3, 1, 4, 5, 3, 0, 1, 2, 4, 5, 3, 6, 7, 9}}};
  return scene;
}

std::string recordWith(const Scene& scene, const rasterizer::Rules& rules, const Frame& reference, const Frame& actual, unsigned threads) {
  SceneEntry entry;
  entry.result = *compare(scene, rules, reference, actual, threads);
  return recordOf(entry);
}

/// Values inside of their intervals and beyond, samples of other primitives, and values where nothing is drawn.
void spoil(Frame& frame, std::mt19937& random, int kind) {
  const size_t samples = frame.primitive.data.size();
  const auto spoilValue = [&](float& value, bool far) {
    value = far ? value * 1.5F + 1 : std::nextafter(value, random() % 2 ? 9.0F : -9.0F);
  };
  for (size_t k = 0; k < samples / 3; ++k) {
    const size_t i = random() % samples;
    if (kind == 0 && frame.primitive.data[i] == 0) continue;
    spoilValue(frame.depth->data[i], kind == 2 && k % 5000 == 0);
    spoilValue(frame.varyings[0].values.data[3 * i + k % 3], kind == 2 && k % 7000 == 0);
    if (kind > 0 && k % 4000 == 0) frame.primitive.data[i] ^= 1;
    if (kind > 0 && k % 9000 == 0) ++frame.count.data[i];
  }
}

TEST(CompareThreads, EveryFieldIsThatOfOneThread) {
  const Scene scene = largeScene();
  for (const rasterizer::Rules& rules : {testing::referenceRules(), rasterizer::Rules::specification(Limits{})}) {
    const Frame reference = *rasterizer::render(scene, rules);
    for (int kind = 0; kind < 3; ++kind) {
      std::mt19937 random(3);
      Frame actual = *rasterizer::render(scene, testing::referenceRules());
      spoil(actual, random, kind);
      const std::string one = recordWith(scene, rules, reference, actual, 1);
      for (const unsigned threads : {2U, 3U, 16U}) EXPECT_EQ(recordWith(scene, rules, reference, actual, threads), one) << threads;
    }
  }
}

TEST(CompareThreads, TheFirstOfEquallyWrongValuesIsNamed) {
  const Scene scene = largeScene();
  const rasterizer::Rules rules = testing::referenceRules();
  const Frame reference = *rasterizer::render(scene, rules);
  Frame actual = reference;
  for (float& depth : actual.depth->data) depth += 1;
  for (const uint32_t y : {30U, 100U, 200U}) actual.depth->at(100, y, 2) = 400;
  for (const unsigned threads : {1U, 4U}) {
    const SceneResult result = *compare(scene, rules, reference, actual, threads);
    const ValueStats& depth = result.values.at(0);
    ASSERT_TRUE(depth.worst && depth.firstDiffering);
    EXPECT_EQ(depth.worst->y, 30U);
    EXPECT_EQ(depth.worst->sample, 2U);
    EXPECT_EQ(depth.firstDiffering->x, 0U);
    EXPECT_EQ(depth.firstDiffering->y, 0U);
  }
}

}  // namespace
}  // namespace rasterdiff::harness
