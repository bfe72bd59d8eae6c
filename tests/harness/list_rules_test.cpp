// `list --rules`: a driver's standing to each rule, from what it drew.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "harness/report/rule_survey.hpp"
#include "tests/harness/program.hpp"

namespace rasterdiff::test {
namespace {

using harness::DriverPass;
using harness::RuleStanding;
using harness::RuleSurvey;
using harness::SceneEntry;
using harness::Verdict;
using State = harness::RuleStanding::State;

SceneEntry drawn(const std::string& id, Verdict verdict, std::vector<std::string> rules, std::string reason = {}) {
  SceneEntry entry;
  entry.result.id = id;
  entry.result.verdict = verdict;
  entry.result.reason = std::move(reason);
  for (const std::string& rule : rules) entry.result.ruleCoverage[rule] = 10;
  entry.rules = std::move(rules);
  return entry;
}

RuleStanding standing(const DriverPass& pass, const std::string& id) {
  const std::vector<RuleSurvey> rules = harness::surveyRules({}, std::span(&pass, 1));
  return std::ranges::find(rules, id, &RuleSurvey::id)->drivers.at(0);
}

TEST(RuleStandings, FollowTheWorstSceneOfTheRule) {
  DriverPass pass;
  pass.scenes = {drawn("a", Verdict::Same, {"R14", "R15", "R17"}), drawn("b", Verdict::Allowed, {"R15"}),
                 drawn("c", Verdict::Skipped, {"R18"}, "8 samples"), drawn("d", Verdict::Differs, {"R17"}, "two samples")};
  pass.scenes[1].result.freedoms["tie-owner"] = 7;
  EXPECT_EQ(standing(pass, "R14").state, State::Same);
  EXPECT_EQ(standing(pass, "R14").decided, 10U);
  const RuleStanding ties = standing(pass, "R15");
  EXPECT_EQ(ties.state, State::Allowed);
  EXPECT_EQ(ties.decided, 20U);
  EXPECT_EQ(ties.freedoms.at("tie-owner"), 7U);
  const RuleStanding pattern = standing(pass, "R17");
  EXPECT_EQ(pattern.state, State::Differs);
  EXPECT_EQ(pattern.differences.at(0).reason, "two samples");
  EXPECT_FALSE(pattern.differences.at(0).known);
  EXPECT_EQ(standing(pass, "R39").state, State::Unknown) << "no scene is about it";
}

TEST(RuleStandings, AKnownBugIsHeldAgainstItsOwnRuleAlone) {
  DriverPass pass;
  pass.scenes = {drawn("a", Verdict::Differs, {"R14", "R39"}), drawn("b", Verdict::Same, {"R14"})};
  pass.scenes[0].result.baseline = harness::BaselineStatus::ExpectedDiff;
  pass.scenes[0].result.baselineRule = "R39";
  pass.scenes[0].result.baselineReason = "one pixel too wide";
  EXPECT_EQ(standing(pass, "R14").state, State::Same);
  EXPECT_EQ(standing(pass, "R14").otherwise, 1U);
  const RuleStanding scissor = standing(pass, "R39");
  EXPECT_EQ(scissor.state, State::Differs);
  EXPECT_TRUE(scissor.differences.at(0).known);
  EXPECT_EQ(scissor.differences.at(0).reason, "one pixel too wide");
}

nlohmann::json rulesOf(std::vector<std::string> words) {
  words.insert(words.end(), {"--rules", "--json"});
  words.insert(words.begin(), "list");
  const Outcome outcome = runProgram(words);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  return nlohmann::json::parse(outcome.out);
}

nlohmann::json ruleOf(const nlohmann::json& document, const std::string& id) {
  for (const nlohmann::json& rule : document.at("rules")) {
    if (rule.at("id") == id) return rule;
  }
  return {};
}

TEST(ListRules, ShowsTheMutantsDifference) {
  const nlohmann::json rule = ruleOf(rulesOf({"scissor/*", "--driver", "mutant:scissor-off-by-one"}), "R39");
  EXPECT_EQ(rule.at("standings").at(0).at("state"), "Differs");
  EXPECT_GT(rule.at("decided"), 0);
  EXPECT_EQ(rule.at("anchors").at(0), "vk:fragops-scissor");
  EXPECT_GT(rule.at("scenes").size(), 2U);
  EXPECT_EQ(rule.at("mutants").at(0), "scissor-off-by-one");
}

TEST(ListRules, OutlivesADriverThatCrashes) {
  const nlohmann::json rule = ruleOf(rulesOf({"scissor/*", "--driver", "fault:crash=scissor/one-pixel"}), "R39");
  EXPECT_EQ(rule.at("standings").at(0).at("differing"), 1);
  EXPECT_NE(rule.at("standings").at(0).at("differences").at(0).at("reason").get<std::string>().find("signal 11"), std::string::npos);
}

TEST(ListRules, MeasuresNothingWithoutADriver) {
  const nlohmann::json document = rulesOf({"--driver", "none"});
  EXPECT_TRUE(document.at("drivers").empty());
  EXPECT_GT(document.at("rules").size(), 40U);
  EXPECT_EQ(runProgram({"list", "scissor/*", "--rules", "--driver", "none-such"}).status, 3);
}

}  // namespace
}  // namespace rasterdiff::test
