// Rows that are judged as soon as they are drawn are judged like all the others.
#include "harness/compare/row_passes.hpp"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "harness/compare/compare.hpp"
#include "harness/report/record.hpp"
#include "tests/support/scenes.hpp"

namespace rasterdiff::harness {
namespace {

constexpr uint32_t kExtent = 256;

Scene deepScene() {
  Scene scene = testing::sceneOf({{3, 5, 0.25}, {250, 9, 0.5}, {240, 250, 0.75}, {3, 5, 0.25}, {240, 250, 0.75}, {7, 240, 0.5}}, kExtent);
  scene.target.depthFormat = DepthFormat::D32_SFLOAT;
  scene.state.depthTestEnable = scene.state.depthWriteEnable = true;
  return scene;
}

/// Other values inside of their intervals and beyond, other primitives and counts.
Frame spoilt(Frame frame) {
  std::mt19937 random(5);
  for (size_t k = 0; k < frame.primitive.data.size() / 3; ++k) {
    const size_t i = random() % frame.primitive.data.size();
    if (frame.primitive.data[i] != 0) frame.depth->data[i] = std::nextafter(frame.depth->data[i], random() % 2 ? 2.0F : -2.0F);
    if (k % 4000 == 0) frame.depth->data[i] += 0.25F;
    if (k % 3000 == 0) frame.primitive.data[i] ^= 1;
    if (k % 5000 == 0) ++frame.count.data[i];
  }
  return frame;
}

std::string recordWith(const Scene& scene, const Frame& reference, const Frame& actual, const RowPasses* early) {
  SceneEntry entry;
  entry.result = *compare(scene, testing::referenceRules(), reference, actual, 1, early);
  return recordOf(entry);
}

TEST(RowPasses, RowsInAnyOrderAreTheWholeFrame) {
  const Scene scene = deepScene();
  const Frame reference = *rasterizer::render(scene, testing::referenceRules());
  const Frame actual = spoilt(reference);
  const std::string whole = recordWith(scene, reference, actual, nullptr);
  const std::vector<std::pair<uint32_t, uint32_t>> orders[] = {
      {{0, 100}, {100, 256}}, {{100, 256}, {0, 100}}, {{64, 65}, {65, 128}, {0, 64}, {128, 256}}, {{200, 256}, {1, 200}, {0, 1}}, {{0, 256}}};
  for (const auto& order : orders) {
    RowPasses early(scene, testing::referenceRules(), actual);
    for (const auto& [first, end] : order) early.judge(reference, first, end);
    EXPECT_EQ(recordWith(scene, reference, actual, &early), whole) << order.size();
  }
}

TEST(RowPasses, WhatTheReferenceTellsOfIsAllOfIt) {
  const Scene scene = deepScene();
  const Frame actual = spoilt(*rasterizer::render(scene, testing::referenceRules()));
  for (const unsigned threads : {1U, 3U}) {
    RowPasses early(scene, testing::referenceRules(), actual);
    const Frame reference = *rasterizer::render(scene, testing::referenceRules(), nullptr, threads,
                                                [&](const Frame& drawn, uint32_t first, uint32_t end) { early.judge(drawn, first, end); });
    SamplePass pass(reference, actual, false);
    ASSERT_TRUE(early.addTo(pass));
    EXPECT_GT(early.seconds(), 0);
    EXPECT_FALSE(pass.questions.empty());
    EXPECT_EQ(recordWith(scene, reference, actual, &early), recordWith(scene, reference, actual, nullptr)) << threads;
  }
}

// What has been judged is not looked at again: only so can it be told from the rest.
TEST(RowPasses, JudgedRowsAreNotJudgedAgain) {
  const Scene scene = deepScene();
  const Frame reference = *rasterizer::render(scene, testing::referenceRules());
  Frame actual = reference;
  RowPasses early(scene, testing::referenceRules(), actual);
  early.judge(reference, 0, kExtent);
  ++actual.count.at(9, 9, 0);
  EXPECT_EQ(compare(scene, testing::referenceRules(), reference, actual, 1, &early)->differing, 0U);
}

TEST(RowPasses, AMissingRowSendsAllOfThemToTheComparison) {
  const Scene scene = deepScene();
  const Frame reference = *rasterizer::render(scene, testing::referenceRules());
  const Frame actual = spoilt(reference);
  RowPasses early(scene, testing::referenceRules(), actual);
  early.judge(reference, 0, 17);
  early.judge(reference, 18, kExtent);
  SamplePass pass(reference, actual, false);
  EXPECT_FALSE(early.addTo(pass));
  EXPECT_EQ(pass.same, 0U);
  EXPECT_EQ(recordWith(scene, reference, actual, &early), recordWith(scene, reference, actual, nullptr));
}

TEST(RowPasses, FramesThatAreNotAlikeAreRefusedAsEver) {
  const Scene scene = deepScene();
  const Frame reference = *rasterizer::render(scene, testing::referenceRules());
  Frame actual = reference;
  actual.depth.reset();
  RowPasses early(scene, testing::referenceRules(), actual);
  early.judge(reference, 0, kExtent);
  EXPECT_FALSE(compare(scene, testing::referenceRules(), reference, actual, 1, &early).has_value());
}

TEST(RowPasses, LargeFramesAreLeftToTheComparison) {
  Scene scene = testing::sceneOf({{3, 5, 0.25}, {2000, 9, 0.5}, {900, 2000, 0.75}}, 2304);
  const Frame reference = *rasterizer::render(scene, testing::referenceRules());
  ASSERT_GT(reference.primitive.data.size(), kSamplesAtOnce);
  RowPasses early(scene, testing::referenceRules(), reference);
  early.judge(reference, 0, reference.height);
  SamplePass pass(reference, reference, false);
  EXPECT_FALSE(early.addTo(pass));
  EXPECT_EQ(recordWith(scene, reference, reference, &early), recordWith(scene, reference, reference, nullptr));
}

}  // namespace
}  // namespace rasterdiff::harness
