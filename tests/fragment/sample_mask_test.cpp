// The sample mask of the state, and alpha to coverage.
#include "fragment_support.hpp"
#include "rasterizer/fragment/alpha_to_coverage.hpp"

namespace rasterdiff::rasterizer {
namespace {

TEST(SampleMask, RemovesTheSamplesOfItsZeroBits) {
  for (const uint32_t samples : {1U, 2U, 4U, 8U, 16U}) {
    for (const uint32_t mask : {0U, 1U, 0x5A5AU, 0xFFFFFFFEU, 0xFFFFFFFFU}) {
      Scene scene = coveringScene(4, samples);
      scene.state.sampleMask = mask;
      const Frame frame = drawn(scene);
      for (uint32_t s = 0; s < samples; ++s) {
        EXPECT_EQ(frame.primitive.at(2, 1, s), (mask >> s) & 1U) << samples << " samples, mask " << mask;
      }
    }
  }
}

TEST(SampleMask, NeitherCoversNorTestsNorCountsWhatItRemoves) {
  Scene scene = coveringScene(4, 4);
  useDepth(scene);
  scene.target.depthClearValue = 0.25F;
  scene.state.sampleMask = 0x6;
  addVarying(scene, "one", Interpolation::flat, 1, {1, 1, 1});
  scene.builtIns = {BuiltIn::SampleMask};
  RuleCounts counts;
  for (const Rules& rules : {testing::referenceRules(), specificationRules()}) {
    const Frame frame = drawn(scene, rules, &counts);
    for (uint32_t s = 0; s < 4; ++s) {
      const bool kept = s == 1 || s == 2;
      EXPECT_EQ(frame.count.at(0, 0, s), kept ? 1U : 0U);
      EXPECT_EQ(frame.depth->at(0, 0, s), kept ? 0.5F : 0.25F);
      EXPECT_EQ(frame.varyings[0].values.at(0, 0, s), kept ? 1.0F : 0.0F);
      EXPECT_EQ(frame.varyings[1].values.at(0, 0, s), kept ? 6.0F : 0.0F);
      if (frame.coverage) {
        EXPECT_EQ(frame.coverage->at(0, 0, s), kept ? Coverage::In : Coverage::Out);
      }
    }
  }
  EXPECT_EQ(counts[Rule::SampleMask], 2U * 16 * 2);
}

TEST(SampleMask, LeavesNoCandidatesForWhatItRemoves) {
  Scene scene = coveringScene(4, 4);
  scene.state.sampleMask = 0x6;
  const std::vector<SampleQuery> queries{{1, 1, 0}, {1, 1, 1}, {1, 1, 2}, {1, 1, 3}};
  for (const Rules& rules : {testing::referenceRules(), specificationRules()}) {
    const auto found = candidates(scene, rules, queries);
    ASSERT_TRUE(found);
    for (size_t q = 0; q < queries.size(); ++q) EXPECT_EQ((*found)[q].size(), q == 1 || q == 2 ? 1U : 0U);
  }
}

Scene alphaScene(float alpha, uint32_t samples = 4) {
  Scene scene = coveringScene(4, samples);
  addVarying(scene, "colour", Interpolation::flat, 4, {1, 1, 1, alpha, 1, 1, 1, alpha, 1, 1, 1, alpha});
  scene.state.alphaToCoverageEnable = true;
  return scene;
}

TEST(AlphaToCoverage, OfZeroKeepsNothingAndOfOneEverything) {
  for (const uint32_t samples : {2U, 4U, 8U, 16U}) {
    for (const auto& [alpha, kept] : {std::pair{-1.0F, false}, {0.0F, false}, {1.0F, true}, {2.0F, true}}) {
      for (const Rules& rules : {testing::referenceRules(), specificationRules()}) {
        const Frame frame = drawn(alphaScene(alpha, samples), rules);
        for (const uint32_t primitive : frame.primitive.data) EXPECT_EQ(primitive, kept ? 1U : 0U);
      }
    }
  }
}

TEST(AlphaToCoverage, KeepsMoreSamplesOfALargerAlpha) {
  for (const uint32_t samples : {2U, 4U, 8U, 16U}) {
    uint32_t last = 0;
    for (int step = 0; step <= 32; ++step) {
      uint32_t kept = 0;
      for (uint32_t s = 0; s < samples; ++s) kept += alphaCovers(static_cast<float>(step) / 32, s, samples) ? 1U : 0U;
      EXPECT_GE(kept, last);
      last = kept;
    }
    EXPECT_EQ(last, samples);
  }
}

// [vk:fragops-covg] between 0 and 1 the algorithm is free, under a profile too.
TEST(AlphaToCoverage, BetweenLeavesEverySampleFree) {
  for (const Rules& rules : {testing::referenceRules(), specificationRules()}) {
    const Scene scene = alphaScene(0.4F);
    const Frame frame = drawn(scene, rules);
    ASSERT_TRUE(frame.coverage);
    for (const Coverage coverage : frame.coverage->data) EXPECT_EQ(coverage, Coverage::Either);
    const auto found = candidates(scene, rules, std::vector<SampleQuery>{{0, 0, 0}, {3, 3, 3}});
    ASSERT_TRUE(found);
    for (const std::vector<Candidate>& each : *found) {
      ASSERT_EQ(each.size(), 1U);
      EXPECT_EQ(each[0].coverage, Coverage::Either);
      EXPECT_EQ(each[0].freedom, Freedom::AlphaToCoverage);
    }
  }
}

TEST(AlphaToCoverage, ComesBeforeTheDepthTest) {
  Scene scene = alphaScene(0);
  useDepth(scene);
  const Frame frame = drawn(scene);
  for (const float depth : frame.depth->data) EXPECT_EQ(depth, 1.0F);
}

}  // namespace
}  // namespace rasterdiff::rasterizer
