// The fast kernels behind render draw the frame, and count the rules, that drawing triangle by triangle does: for any number of
// threads and any instruction set.
#include "rasterizer/kernel_frame.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <string>
#include <vector>

#include "kernels/every_target.hpp"
#include "rasterizer/render.hpp"
#include "rasterizer/sample_pattern.hpp"
#include "scene/catalogue/catalogue.hpp"
#include "scene/generators/prng.hpp"
#include "scene/needs.hpp"

namespace rasterdiff::rasterizer {
namespace {

bool served(const Scene& scene, const Rules& rules) {
  return KernelFrame::of(scene, rules, samplePattern(scene.target.samples, rules).value()).has_value();
}

/// Every kind of interpolation that may wait, and a few components of each.
Scene withInputs(Scene scene) {
  Prng prng(7);
  for (Draw& draw : scene.draws) {
    draw.varyings = {{.name = "smooth", .components = 3},
                     {.name = "linear", .interpolation = Interpolation::noperspective, .components = 2},
                     {.name = "flat", .interpolation = Interpolation::flat, .components = 1}};
    for (Varying& varying : draw.varyings) {
      for (size_t k = 0; k < draw.positions.size() * varying.components; ++k) varying.values.push_back(static_cast<float>(prng.below(4001)) / 1000 - 2);
    }
  }
  return scene;
}

Scene withoutInputs(Scene scene) {
  for (Draw& draw : scene.draws) draw.varyings.clear();
  scene.builtIns.clear();
  return scene;
}

Scene withDepth(Scene scene) {
  scene.target.depthFormat = DepthFormat::D32_SFLOAT;
  scene.state.depthTestEnable = scene.state.depthWriteEnable = true;
  scene.state.depthCompareOp = CompareOp::LESS;
  return scene;
}

template <class T>
void expectSameBits(const Plane<T>& a, const Plane<T>& b) {
  ASSERT_EQ(a.data.size(), b.data.size());
  EXPECT_EQ(std::memcmp(a.data.data(), b.data.data(), a.data.size() * sizeof(T)), 0);
}

void expectSame(const Frame& fast, const Frame& expected) {
  expectSameBits(fast.primitive, expected.primitive);
  expectSameBits(fast.count, expected.count);
  ASSERT_EQ(fast.varyings.size(), expected.varyings.size());
  for (size_t v = 0; v < fast.varyings.size(); ++v) {
    EXPECT_EQ(fast.varyings[v].name, expected.varyings[v].name);
    expectSameBits(fast.varyings[v].values, expected.varyings[v].values);
    expectSameBits(*fast.varyings[v].bounds, *expected.varyings[v].bounds);
  }
  ASSERT_EQ(fast.depth.has_value(), expected.depth.has_value());
  if (!fast.depth) return;
  expectSameBits(*fast.depth, *expected.depth);
  expectSameBits(*fast.depthBounds, *expected.depthBounds);
}

/// Draws `scene` both ways, by several threads and with every instruction set.
void expectThatOfRows(const Scene& scene, const Rules& rules) {
  RuleCounts slowCounts;
  const Frame expected = renderRowByRow(scene, rules, &slowCounts).value();
  const auto expectAlike = [&](unsigned threads) {
    RuleCounts counts;
    expectSame(render(scene, rules, &counts, threads).value(), expected);
    for (const RuleInfo& rule : countedRules()) EXPECT_EQ(counts[rule.rule], slowCounts[rule.rule]) << rule.name << ", " << threads << " threads";
    expectSame(render(scene, rules, nullptr, threads).value(), expected);
  };
  for (const unsigned threads : {1U, 2U, 3U, 8U}) expectAlike(threads);
  testing::onEveryTarget([&] { expectAlike(1); });
}

TEST(KernelFrame, IsThatOfOneTriangleAfterTheOther) {
  size_t covered = 0, deep = 0, multisampled = 0, cut = 0, inputs = 0;
  for (const std::string_view profile : {"reference", "lavapipe"}) {
    const Rules rules = Rules::profile(profile, Limits{}).value();
    for (const CatalogueEntry& entry : catalogue()) {
      if (!entry.remake || !entry.name.starts_with("random")) continue;
      const Scene made = withoutInputs(entry.remake(5, 1500).value());
      for (const Scene& scene : {made, withDepth(made), withInputs(made), withInputs(withDepth(made))}) {
        if (!served(scene, rules)) continue;
        SCOPED_TRACE(entry.name + " " + std::string(profile));
        expectThatOfRows(scene, rules);
        inputs += needsOf(scene).varyings > 0 ? 1U : 0U;
        ++(scene.target.depthFormat ? deep : covered);
        multisampled += scene.target.samples > 1 ? 1U : 0U;
        cut += needsClipping(scene) ? 1U : 0U;
      }
    }
  }
  EXPECT_GE(covered, 8U);
  EXPECT_GE(deep, 8U);
  EXPECT_GE(multisampled, 4U);
  EXPECT_GE(cut, 2U);
  EXPECT_GE(inputs, 8U);
}

TEST(KernelFrame, OfAMeshIsThatOfOneTriangleAfterTheOther) {
  const Rules rules = Rules::profile("lavapipe", Limits{}).value();
  for (const std::string_view name : {"mesh/bunny-1x", "mesh/bunny-near-4x"}) {
    SCOPED_TRACE(name);
    const auto entries = matchCatalogue(std::string(name));
    ASSERT_EQ(entries.size(), 1U);
    const Scene scene = entries[0]->make().value();  // with normals
    ASSERT_TRUE(served(scene, rules));
    const Frame expected = renderRowByRow(scene, rules).value();
    for (const unsigned threads : {1U, 3U}) expectSame(render(scene, rules, nullptr, threads).value(), expected);
  }
}

TEST(KernelFrame, OfNarrowAndLowTargetsIsThatOfRows) {
  const Rules rules = Rules::profile("lavapipe", Limits{}).value();
  for (const std::string_view name : {"random/half-1x-w1", "random/half-4x-w1"}) {
    const Scene made = withInputs(withDepth(withoutInputs(matchCatalogue(std::string(name))[0]->remake(3, 60).value())));
    for (const uint32_t width : {1U, 2U, 3U, 7U, 8U, 9U, 15U, 16U, 17U, 33U, 65U}) {
      for (const uint32_t height : {1U, 2U, 5U, 17U}) {
        SCOPED_TRACE(std::string(name) + " " + std::to_string(width) + " x " + std::to_string(height));
        Scene scene = made;
        scene.target.width = width, scene.target.height = height;
        scene.viewport = {0, 0, static_cast<float>(width), static_cast<float>(height), 0, 1};
        ASSERT_TRUE(served(scene, rules));
        expectSame(render(scene, rules).value(), renderRowByRow(scene, rules).value());
      }
    }
  }
}

// Planes of the rows that somebody is told of, put together, are the frame: all rows are told of, once, when they are done.
TEST(KernelFrame, TellsOfEachRowWhenItIsDone) {
  const Rules rules = Rules::profile("reference", Limits{}).value();
  const auto entry = matchCatalogue("random/half-4x-w1");
  ASSERT_EQ(entry.size(), 1U);
  for (const uint32_t height : {1U, 200U, 333U}) {
    Scene scene = withInputs(withDepth(withoutInputs(entry[0]->remake(5, 900).value())));
    scene.target.width = 300, scene.target.height = height;
    scene.viewport = {0, 0, 300, static_cast<float>(height), 0, 1};
    ASSERT_TRUE(served(scene, rules));
    for (const unsigned threads : {1U, 3U}) {
      Frame expected = renderRowByRow(scene, rules).value(), told = expected;
      std::vector<uint32_t> times(height);
      const auto take = [&](const Frame& frame, uint32_t first, uint32_t end) {
        const auto copy = [&](auto& to, const auto& from) {
          const size_t row = to.data.size() / height;
          std::copy_n(from.data.begin() + static_cast<std::ptrdiff_t>(first * row), (end - first) * row, to.data.begin() + static_cast<std::ptrdiff_t>(first * row));
        };
        for (uint32_t y = first; y < end; ++y) ++times[y];
        copy(told.primitive, frame.primitive), copy(told.count, frame.count), copy(*told.depth, *frame.depth), copy(*told.depthBounds, *frame.depthBounds);
        for (size_t v = 0; v < told.varyings.size(); ++v) {
          copy(told.varyings[v].values, frame.varyings[v].values), copy(*told.varyings[v].bounds, *frame.varyings[v].bounds);
        }
      };
      std::ranges::fill(told.primitive.data, 77);
      std::ranges::fill(told.count.data, 77);
      std::ranges::fill(told.depth->data, 77.0F);
      expectSame(render(scene, rules, nullptr, threads, take).value(), expected);
      expectSame(told, expected);
      EXPECT_EQ(times, std::vector<uint32_t>(height, 1));
    }
  }
}

TEST(KernelFrame, LeavesWhatIsNotItsRuleToTheOthers) {
  const auto entry = matchCatalogue("random/half-1x-w1");
  ASSERT_EQ(entry.size(), 1U);
  const Scene scene = entry[0]->remake(5, 3000).value();
  const Rules rules = Rules::profile("reference", Limits{}).value();
  ASSERT_TRUE(served(scene, rules));
  EXPECT_FALSE(served(scene, Rules::specification(Limits{})));
  EXPECT_TRUE(served(entry[0]->remake(5, 20).value(), rules));
  Rules otherOwner = rules;
  otherOwner.choices.tieOwner = TieOwner::BottomRight;
  EXPECT_FALSE(served(scene, otherOwner));
  Scene scissored = scene;
  scissored.scissor = Rect2D{1, 0, scene.target.width - 1, scene.target.height};
  EXPECT_FALSE(served(scissored, rules));
  Scene masked = scene;
  masked.state.sampleMask = 0;
  EXPECT_FALSE(served(masked, rules));
  const Scene deep = withDepth(scene);
  ASSERT_TRUE(served(deep, rules));
  Scene fixedPoint = deep;
  fixedPoint.target.depthFormat = DepthFormat::D16_UNORM;
  EXPECT_FALSE(served(fixedPoint, rules));
  Scene greater = deep;
  greater.state.depthCompareOp = CompareOp::GREATER;
  EXPECT_FALSE(served(greater, rules));
  Scene unwritten = deep;
  unwritten.state.depthWriteEnable = false;
  EXPECT_FALSE(served(unwritten, rules));
}

}  // namespace
}  // namespace rasterdiff::rasterizer
