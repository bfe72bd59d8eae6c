// `explain` names the right rule: for every deliberate error, at the first sample that differs, the broken rule is among
// those at work there, and trying out the known mistakes leads to it.
#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <set>

#include "catching_scene.hpp"
#include "harness/compare/suspects.hpp"
#include "harness/report/explanation_parts.hpp"
#include "rasterizer/explain.hpp"

namespace rasterdiff {
namespace {

using rasterizer::DeliberateError;
using rasterizer::DeliberateErrorInfo;
using rasterizer::SampleQuery;

SampleQuery firstDifference(const harness::SceneResult& result) {
  const auto differs = std::ranges::find(result.differences, harness::Verdict::Differs, &harness::SampleDifference::verdict);
  if (differs != result.differences.end()) return {differs->x, differs->y, differs->sample};
  for (const harness::ValueStats& value : result.values) {
    if (value.firstDiffering) return {value.firstDiffering->x, value.firstDiffering->y, value.firstDiffering->sample};
  }
  return {};
}

class Explained : public ::testing::TestWithParam<DeliberateErrorInfo> {};

TEST_P(Explained, NamesTheBrokenRule) {
  const DeliberateErrorInfo& mutant = GetParam();
  rasterizer::Rules rules = referenceWith(mutant.error);
  rules.error = DeliberateError::None;
  const std::optional<Catch> caught = firstCatch(mutant, rules);
  ASSERT_TRUE(caught) << mutant.name;
  const SampleQuery at = firstDifference(caught->result);
  const Result<rasterizer::SampleExplanation> explanation = rasterizer::explain(*caught->scene, rules, at);
  ASSERT_TRUE(explanation) << explanation.error().what;
  std::vector<std::string_view> atWork;
  for (const rasterizer::Rule rule : explanation->rules) atWork.push_back(harness::ruleId(rule));
  EXPECT_TRUE(std::ranges::find(atWork, mutant.rule) != atWork.end())
      << mutant.rule << " is not among the rules at work in " << caught->scene->name << " at " << at.x << " " << at.y;

  const Result<harness::Suspicion> suspicion = harness::suspicionOf(*caught->scene, rules, caught->frame, at, atWork);
  ASSERT_TRUE(suspicion) << suspicion.error().what;
  std::set<std::string_view> suspected;
  for (const harness::Suspect& suspect : suspicion->suspects) suspected.insert(suspect.rule);
  EXPECT_TRUE(suspected.contains(mutant.rule)) << caught->scene->name << " at " << at.x << " " << at.y;
  EXPECT_LE(suspected.size(), 3U) << "too many rules are suspected in " << caught->scene->name;
}

std::vector<DeliberateErrorInfo> mutants() {
  return {rasterizer::deliberateErrors().begin(), rasterizer::deliberateErrors().end()};
}

INSTANTIATE_TEST_SUITE_P(All, Explained, ::testing::ValuesIn(mutants()), [](const auto& testInfo) {
  std::string name(testInfo.param.name);
  std::ranges::replace(name, '-', '_');
  return name;
});

}  // namespace
}  // namespace rasterdiff
