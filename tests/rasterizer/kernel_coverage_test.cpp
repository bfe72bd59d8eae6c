// The fast kernel behind render draws the frame, and counts the rules, that drawing triangle by triangle does.
#include <gtest/gtest.h>

#include "rasterizer/kernel_coverage.hpp"
#include "rasterizer/render.hpp"
#include "rasterizer/sample_pattern.hpp"
#include "scene/catalogue/catalogue.hpp"

namespace rasterdiff::rasterizer {
namespace {

bool served(const Scene& scene, const Rules& rules) {
  return KernelCoverage::of(scene, rules, samplePattern(scene.target.samples, rules).value()).has_value();
}

Scene withInput(Scene scene) {
  for (Draw& draw : scene.draws) draw.varyings.push_back({.name = "v", .components = 1, .values = std::vector<float>(draw.positions.size())});
  return scene;
}

TEST(KernelCoverage, IsThatOfOneTriangleAfterTheOther) {
  const Rules rules = Rules::profile("reference", Limits{}).value();
  size_t compared = 0, multisampled = 0;
  for (const CatalogueEntry& entry : catalogue()) {
    if (!entry.remake) continue;
    const Scene scene = entry.remake(5, 3000).value();
    if (!served(scene, rules)) continue;
    SCOPED_TRACE(entry.name);
    const Scene slow = withInput(scene);
    ASSERT_FALSE(served(slow, rules));
    RuleCounts fastCounts, slowCounts;
    const Frame fast = render(scene, rules, &fastCounts).value(), expected = render(slow, rules, &slowCounts).value();
    EXPECT_EQ(fast.primitive.data, expected.primitive.data);
    EXPECT_EQ(fast.count.data, expected.count.data);
    for (const Rule rule : {Rule::Order, Rule::TieBreak, Rule::SampleCoverage, Rule::Scissor, Rule::HelperInvocation}) {
      EXPECT_EQ(fastCounts[rule], slowCounts[rule]);
    }
    const Frame uncounted = render(scene, rules).value();
    EXPECT_EQ(uncounted.primitive.data, expected.primitive.data);
    EXPECT_EQ(uncounted.count.data, expected.count.data);
    ++compared;
    multisampled += scene.target.samples > 1 ? 1U : 0U;
  }
  EXPECT_GE(compared, 4U);
  EXPECT_GE(multisampled, 1U);
}

TEST(KernelCoverage, LeavesWhatIsNotItsRuleToTheOthers) {
  const auto entry = matchCatalogue("random/half-1x-w1");
  ASSERT_EQ(entry.size(), 1U);
  const Scene scene = entry[0]->remake(5, 3000).value();
  const Rules rules = Rules::profile("reference", Limits{}).value();
  ASSERT_TRUE(served(scene, rules));
  EXPECT_FALSE(served(scene, Rules::specification(Limits{})));
  EXPECT_FALSE(served(entry[0]->remake(5, 20).value(), rules));
  Rules otherOwner = rules;
  otherOwner.choices.tieOwner = TieOwner::BottomRight;
  EXPECT_FALSE(served(scene, otherOwner));
  Scene scissored = scene;
  scissored.scissor = Rect2D{1, 0, scene.target.width - 1, scene.target.height};
  EXPECT_FALSE(served(scissored, rules));
  Scene masked = scene;
  masked.state.sampleMask = 0;
  EXPECT_FALSE(served(masked, rules));
}

}  // namespace
}  // namespace rasterdiff::rasterizer
