// The mask that a fragment shader writes to SampleMask. [vk:fragops-covg]
#include "fragment_support.hpp"
#include "rasterizer/explain.hpp"
#include "rasterizer/fragment/shader_mask.hpp"

namespace rasterdiff::rasterizer {
namespace {

Scene writing(ShaderSampleMask mask, uint32_t bits, uint32_t samples = 4) {
  Scene scene = coveringScene(4, samples);
  scene.state.shaderSampleMask = mask;
  scene.draws[0].shaderSampleMaskBits = bits;
  return scene;
}

/// Bit s: sample s of the pixel was drawn.
uint32_t maskAt(const Frame& frame, uint32_t x, uint32_t y) {
  uint32_t mask = 0;
  for (uint32_t s = 0; s < frame.samples; ++s) mask |= (frame.primitive.at(x, y, s) != 0 ? 1U : 0U) << s;
  return mask;
}

TEST(ShaderMask, KeepsTheSamplesOfItsBitsAndIgnoresThoseBeyond) {
  for (const uint32_t samples : {1U, 2U, 4U, 8U, 16U}) {
    for (const uint32_t bits : {0U, 1U, 0x5A5AU, 0xFFFFFFFEU, 0xFFFFFFFFU}) {
      for (const Rules& rules : {testing::referenceRules(), specificationRules()}) {
        const Frame frame = drawn(writing(ShaderSampleMask::CONSTANT, bits, samples), rules);
        EXPECT_EQ(maskAt(frame, 2, 1), bits & ((1U << samples) - 1)) << samples << " samples, bits " << bits;
      }
    }
  }
}

TEST(ShaderMask, OfTheInputShiftedKeepsWhatComesAfterACoveredSample) {
  for (const uint32_t samples : {1U, 2U, 4U, 8U, 16U}) {
    const uint32_t all = (1U << samples) - 1;
    const Frame frame = drawn(writing(ShaderSampleMask::INPUT_SHIFTED, 0xFFFFFFFF, samples));
    EXPECT_EQ(maskAt(frame, 2, 1), all & ~1U) << samples;
  }
  Scene scene = writing(ShaderSampleMask::INPUT_SHIFTED, 0xFFFFFFFF);
  scene.state.sampleMask = 0xD;  // the shader finds samples 0, 2 and 3: bits 1, 3 and 4
  EXPECT_EQ(maskAt(drawn(scene), 2, 1), 0x8U);
}

// A triangle's own edge through the pixels: each sample against the coverage without a mask.
TEST(ShaderMask, OfTheInputShiftedFollowsThePartialCoverageOfEachFragment) {
  Scene scene = testing::sceneOf({{1.25, 0.5}, {14.5, 6.25}, {4.75, 15.125}}, 16, 4);
  const Frame plain = drawn(scene);
  scene.state.shaderSampleMask = ShaderSampleMask::INPUT_SHIFTED;
  const Frame masked = drawn(scene);
  std::array<int, 16> seen{};
  for (uint32_t y = 0; y < 16; ++y) {
    for (uint32_t x = 0; x < 16; ++x) {
      const uint32_t covered = maskAt(plain, x, y);
      ++seen[covered];
      EXPECT_EQ(maskAt(masked, x, y), covered & (covered << 1)) << x << ", " << y;
    }
  }
  EXPECT_GT(seen[0xE] + seen[0x7] + seen[0x5] + seen[0xA], 0);
}

TEST(ShaderMask, OfEachDrawIsItsOwn) {
  Scene scene = writing(ShaderSampleMask::CONSTANT, 0x3);
  scene.draws.push_back(scene.draws[0]);
  scene.draws[1].shaderSampleMaskBits = 0x6;
  const Frame frame = drawn(scene);
  EXPECT_EQ(frame.primitive.at(1, 1, 0), 1U);
  EXPECT_EQ(frame.primitive.at(1, 1, 1), 2U);
  EXPECT_EQ(frame.primitive.at(1, 1, 2), 2U);
  EXPECT_EQ(frame.primitive.at(1, 1, 3), 0U);
}

TEST(ShaderMask, ComesBeforeTheDepthTestAndLeavesWhatTheShaderReadsAlone) {
  Scene scene = writing(ShaderSampleMask::CONSTANT, 0x6);
  useDepth(scene);
  scene.target.depthClearValue = 0.25F;
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
      EXPECT_EQ(frame.varyings[1].values.at(0, 0, s), kept ? 15.0F : 0.0F);
      if (frame.coverage) {
        EXPECT_EQ(frame.coverage->at(0, 0, s), kept ? Coverage::In : Coverage::Out);
      }
    }
  }
  EXPECT_EQ(counts[Rule::ShaderSampleMask], 2U * 16 * 2);
}

TEST(ShaderMask, UnderSampleShadingHasOnlyTheInvocationsOwnBit) {
  for (const auto& [kind, kept] : {std::pair{ShaderSampleMask::CONSTANT, 0x6U}, {ShaderSampleMask::INPUT_SHIFTED, 0U}}) {
    Scene scene = writing(kind, 0x6);
    scene.state.sampleShadingEnable = true;
    scene.state.minSampleShading = 1;
    for (const Rules& rules : {testing::referenceRules(), specificationRules()}) EXPECT_EQ(maskAt(drawn(scene, rules), 1, 1), kept);
  }
}

// [vk:primsrast-sampleshading] which samples two invocations of four samples have is not stated.
TEST(ShaderMask, MadeOfTheSamplesOfAnInvocationIsAsFreeAsTheirGrouping) {
  Scene scene = writing(ShaderSampleMask::INPUT_SHIFTED, 0x6);
  scene.state.sampleShadingEnable = true;
  scene.state.minSampleShading = 0.5F;
  for (const Rules& rules : {testing::referenceRules(), specificationRules()}) {
    const Frame frame = drawn(scene, rules);
    ASSERT_TRUE(frame.coverage);
    EXPECT_EQ(frame.coverage->at(1, 1, 1), Coverage::Either);
    const auto found = candidates(scene, rules, std::vector<SampleQuery>{{1, 1, 0}, {1, 1, 1}, {1, 1, 3}});
    ASSERT_TRUE(found);
    EXPECT_TRUE((*found)[0].empty());
    ASSERT_EQ((*found)[1].size(), 1U);
    EXPECT_EQ((*found)[1][0].coverage, Coverage::Either);
    EXPECT_EQ((*found)[1][0].freedom, Freedom::ShaderSampleMask);
    EXPECT_TRUE((*found)[2].empty());
  }
}

// The sample whose neighbour lies on an edge that a legal snapping moves is free, though it is inside itself.
TEST(ShaderMask, MadeOfAFreeSampleIsFreeWhereThatOneIs) {
  Scene scene = testing::sceneOf({{1.25, 0.5}, {14.5, 6.25}, {4.75, 15.125}}, 16, 4);
  scene.state.shaderSampleMask = ShaderSampleMask::INPUT_SHIFTED;
  Scene plain = scene;
  plain.state.shaderSampleMask = ShaderSampleMask::NONE;
  const Frame known = drawn(plain, specificationRules());
  std::vector<SampleQuery> queries;
  for (uint32_t y = 0; y < 16; ++y) {
    for (uint32_t x = 0; x < 16; ++x) {
      for (uint32_t s = 0; s < 4; ++s) queries.push_back({x, y, s});
    }
  }
  const auto found = candidates(scene, specificationRules(), queries);
  ASSERT_TRUE(found);
  size_t free = 0;
  for (size_t q = 0; q < queries.size(); ++q) {
    const SampleQuery& at = queries[q];
    const Coverage own = known.coverage->at(at.x, at.y, at.sample);
    const Coverage before = at.sample == 0 ? Coverage::Out : known.coverage->at(at.x, at.y, at.sample - 1);
    Coverage expected = std::max(own, before);
    if (own == Coverage::Out || before == Coverage::Out) expected = Coverage::Out;
    const Coverage actual = (*found)[q].empty() ? Coverage::Out : (*found)[q][0].coverage;
    EXPECT_EQ(actual, expected) << at.x << ", " << at.y << ", " << at.sample;
    free += own == Coverage::In && before == Coverage::Either ? 1 : 0;
  }
  EXPECT_GT(free, 0U);
}

TEST(ShaderMask, IsNamedByExplain) {
  const Result<SampleExplanation> e = explain(writing(ShaderSampleMask::CONSTANT, 0x6), testing::referenceRules(), {1, 1, 0});
  ASSERT_TRUE(e);
  ASSERT_EQ(e->primitives.size(), 1U);
  EXPECT_EQ(e->primitives[0].decidedBy, Rule::ShaderSampleMask);
  EXPECT_EQ(e->primitives[0].fate.end, FragmentFate::End::ShaderMasked);
  EXPECT_EQ(e->primitives[0].fate.shaderMask, 0x6U);
  const Result<SampleExplanation> shifted = explain(writing(ShaderSampleMask::INPUT_SHIFTED, 0xB), testing::referenceRules(), {1, 1, 1});
  ASSERT_TRUE(shifted);
  EXPECT_EQ(shifted->primitives[0].fate.end, FragmentFate::End::Written);
  EXPECT_EQ(shifted->primitives[0].fate.shaderMask, 0xAU);
}

}  // namespace
}  // namespace rasterdiff::rasterizer
