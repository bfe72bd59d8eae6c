#include "harness/report/rule_survey.hpp"

#include <algorithm>
#include <charconv>

#include "rasterizer/deliberate_error.hpp"
#include "rasterizer/rule_counts.hpp"

namespace rasterdiff::harness {
namespace {

RuleSurvey& ruleOf(std::vector<RuleSurvey>& rules, std::string_view id) {
  const auto found = std::ranges::find(rules, id, &RuleSurvey::id);
  if (found != rules.end()) return *found;
  rules.emplace_back().id = id;
  return rules.back();
}

void addOnce(std::vector<std::string>& list, std::string_view word) {
  if (std::ranges::find(list, word) == list.end()) list.emplace_back(word);
}

bool names(const SceneEntry& entry, const std::string& rule) {
  return std::ranges::find(entry.rules, rule) != entry.rules.end();
}

bool isFailure(const SceneResult& result) {
  return result.verdict == Verdict::Differs || result.verdict == Verdict::Crashed || result.verdict == Verdict::TimedOut;
}

/// A known difference is its own rule's; an unknown one is held against every rule that the scene is about.
bool breaks(const SceneEntry& entry, const std::string& rule) {
  if (!isFailure(entry.result)) return false;
  return entry.result.baselineRule.empty() ? names(entry, rule) : entry.result.baselineRule == rule;
}

void addDifference(RuleStanding& standing, const SceneResult& result) {
  const bool known = result.baseline == BaselineStatus::ExpectedDiff;
  const std::string& reason = known ? result.baselineReason : result.reason;
  auto same = std::ranges::find(standing.differences, reason, &RuleStanding::Difference::reason);
  if (same == standing.differences.end()) same = standing.differences.insert(same, {reason, known, {}});
  same->scenes.push_back(result.id);
}

void addScene(RuleStanding& standing, const SceneEntry& entry, const std::string& rule) {
  if (entry.error) return;
  const SceneResult& result = entry.result;
  if (const auto counted = result.ruleCoverage.find(rule); counted != result.ruleCoverage.end()) {
    standing.decided += counted->second;
  }
  if (breaks(entry, rule)) {
    ++standing.differing;
    return addDifference(standing, result);
  }
  if (!names(entry, rule)) return;
  if (isFailure(result)) {
    ++standing.otherwise;
  } else if (result.verdict == Verdict::Skipped) {
    ++standing.skipped;
    if (standing.reason.empty()) standing.reason = result.reason;
  } else {
    ++(result.verdict == Verdict::Same ? standing.same : standing.allowed);
    for (const auto& [freedom, count] : result.freedoms) standing.freedoms[freedom] += count;
  }
}

RuleStanding standingOf(const std::string& rule, const DriverPass& pass) {
  using enum RuleStanding::State;
  RuleStanding standing;
  for (const SceneEntry& entry : pass.scenes) addScene(standing, entry, rule);
  if (standing.differing > 0) {
    standing.state = Differs;
  } else if (standing.allowed > 0) {
    standing.state = Allowed;
  } else if (standing.same > 0) {
    standing.state = Same;
  } else if (standing.skipped > 0) {
    standing.state = NotOffered;
  } else {
    standing.reason = pass.refusal.empty() ? "no scene of this selection is about it alone" : pass.refusal;
  }
  if (standing.state != NotOffered && standing.state != Unknown) standing.reason.clear();
  return standing;
}

}  // namespace

std::string_view toString(RuleStanding::State state) {
  switch (state) {
    case RuleStanding::State::Same: return "Same";
    case RuleStanding::State::Allowed: return "Allowed";
    case RuleStanding::State::Differs: return "Differs";
    case RuleStanding::State::NotOffered: return "not offered";
    case RuleStanding::State::Unknown: return "unknown";
  }
  return "unknown";
}

int ruleNumber(std::string_view id) {
  int number = 0;
  if (id.size() > 1) std::from_chars(id.data() + 1, id.data() + id.size(), number);
  return number;
}

std::vector<RuleSurvey> surveyRules(std::span<const CatalogueEntry* const> entries, std::span<const DriverPass> passes) {
  std::vector<RuleSurvey> rules;
  for (const rasterizer::RuleInfo& info : rasterizer::countedRules()) {
    RuleSurvey& rule = ruleOf(rules, info.id);
    rule.names.emplace_back(info.name);
    addOnce(rule.anchors, info.anchor);
  }
  for (const CatalogueEntry* entry : entries) {
    for (const std::string& id : entry->rules) ruleOf(rules, id).scenes.push_back(entry);
  }
  for (const rasterizer::DeliberateErrorInfo& mutant : rasterizer::deliberateErrors()) {
    ruleOf(rules, mutant.rule).mutants.emplace_back(mutant.name);
  }
  const auto ran = std::ranges::find_if(passes, [](const DriverPass& pass) { return pass.refusal.empty(); });
  for (RuleSurvey& rule : rules) {
    for (const DriverPass& pass : passes) rule.drivers.push_back(standingOf(rule.id, pass));
    if (ran == passes.end()) continue;
    rule.decided = rule.drivers[static_cast<size_t>(ran - passes.begin())].decided;
    rule.decidingScenes = static_cast<uint64_t>(std::ranges::count_if(
        ran->scenes, [&](const SceneEntry& entry) { return entry.result.ruleCoverage.contains(rule.id); }));
  }
  std::ranges::stable_sort(rules, {}, [](const RuleSurvey& rule) { return ruleNumber(rule.id); });
  return rules;
}

}  // namespace rasterdiff::harness
