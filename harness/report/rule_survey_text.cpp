// The rules as text: a few lines each, then what every driver's standing comes to.
#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "harness/report/numbers.hpp"
#include "harness/report/rule_survey.hpp"

namespace rasterdiff::harness {
namespace {

using Out = std::back_insert_iterator<std::string>;
using State = RuleStanding::State;

constexpr size_t kShownNames = 4, kLabel = 12, kWidth = 118;

/// "a, b, c and 5 more".
std::string some(const std::vector<std::string>& names) {
  std::string text;
  for (size_t i = 0; i < names.size() && i < kShownNames; ++i) text += (i > 0 ? ", " : "") + names[i];
  if (names.size() > kShownNames) text += fmt::format(" and {} more", names.size() - kShownNames);
  return text.empty() ? "none" : text;
}

std::string all(const std::vector<std::string>& names) { return fmt::format("{}", fmt::join(names, ", ")); }

/// A label and a text that is folded under itself.
void writeLine(Out out, std::string_view label, std::string_view text) {
  constexpr size_t kIndent = 5 + kLabel;
  fmt::format_to(out, "     {:<{}}", label, kLabel);
  size_t column = kIndent;
  while (!text.empty()) {
    const std::string_view word = text.substr(0, text.find(' '));
    if (column > kIndent && column + 1 + word.size() > kWidth) {
      fmt::format_to(out, "\n{:<{}}", "", kIndent);
      column = kIndent;
    }
    fmt::format_to(out, "{}{}", column > kIndent ? " " : "", word);
    column += word.size() + (column > kIndent ? 1 : 0);
    text.remove_prefix(std::min(word.size() + 1, text.size()));
  }
  *out++ = '\n';
}

std::string scenesOf(const RuleSurvey& rule) {
  std::vector<std::string> names;
  for (const CatalogueEntry* scene : rule.scenes) names.push_back(scene->name);
  return names.empty() ? "none of this selection" : fmt::format("{}: {}", names.size(), some(names));
}

std::string freedomsOf(const RuleStanding& standing) {
  std::vector<std::pair<std::string, uint64_t>> freedoms(standing.freedoms.begin(), standing.freedoms.end());
  std::ranges::stable_sort(freedoms, std::greater{}, [](const auto& freedom) { return freedom.second; });
  std::vector<std::string> words;
  for (const auto& [name, count] : freedoms) words.push_back(count > 0 ? fmt::format("{} {}", name, grouped(count)) : name);
  return some(words);
}

/// ", 2 not offered, 1 differs for another rule".
std::string restOf(const RuleStanding& standing) {
  std::string text;
  if (standing.skipped > 0) text += fmt::format(", {} not offered", standing.skipped);
  if (standing.otherwise > 0) text += fmt::format(", {} with another rule's difference", standing.otherwise);
  return text;
}

std::string standingText(const RuleStanding& standing) {
  switch (standing.state) {
    case State::Same: return fmt::format("Same in {}{}", counted(standing.same, "scene"), restOf(standing));
    case State::Allowed:
      return fmt::format("Allowed in {} of {}{}: {}", standing.allowed, counted(standing.same + standing.allowed, "scene"),
                         restOf(standing), freedomsOf(standing));
    case State::NotOffered: return "not offered: " + standing.reason;
    case State::Unknown: return "unknown: " + standing.reason;
    case State::Differs: break;
  }
  std::string text = fmt::format("DIFFERS in {} of {}{}", standing.differing,
                                 counted(standing.differing + standing.same + standing.allowed, "scene"), restOf(standing));
  for (const RuleStanding::Difference& difference : standing.differences) {
    text += fmt::format("; {}{} ({})", difference.known ? "" : "NEW: ", difference.reason, some(difference.scenes));
  }
  return text;
}

void writeRule(Out out, const RuleSurvey& rule, std::span<const DriverPass> passes) {
  fmt::format_to(out, "{:<4} {} [{}]\n", rule.id, all(rule.names), all(rule.anchors));
  writeLine(out, "scenes", scenesOf(rule));
  writeLine(out, "mutants", rule.mutants.empty() ? "none" : all(rule.mutants));
  const bool ran = std::ranges::any_of(passes, [](const DriverPass& pass) { return pass.refusal.empty(); });
  if (ran) {
    writeLine(out, "decided", fmt::format("{} in {}", counted(rule.decided, "time"), counted(rule.decidingScenes, "scene")));
  }
  for (size_t i = 0; i < passes.size(); ++i) {
    if (passes[i].refusal.empty()) writeLine(out, passes[i].driver, standingText(rule.drivers[i]));
  }
}

void writeDriver(Out out, const DriverPass& pass, size_t index, std::span<const RuleSurvey> rules) {
  if (!pass.refusal.empty()) {
    fmt::format_to(out, "{:<12} cannot be used: {}\n", pass.driver, pass.refusal);
    return;
  }
  const auto ids = [&](State state) {
    std::vector<std::string> found;
    for (const RuleSurvey& rule : rules) {
      if (rule.drivers[index].state == state) found.push_back(rule.id);
    }
    return found;
  };
  fmt::format_to(out, "{:<12} {}: {} in {}\n", pass.driver, pass.subject.line,
                 counted(pass.scenes.size(), "scene"), secondsText(pass.seconds));
  if (!pass.stopped.empty()) fmt::format_to(out, "     stopped: {}\n", pass.stopped);
  for (const State state : {State::Same, State::Allowed, State::Differs, State::NotOffered, State::Unknown}) {
    const std::vector<std::string> found = ids(state);
    if (!found.empty()) writeLine(out, toString(state), fmt::format("{}: {}", counted(found.size(), "rule"), all(found)));
  }
}

}  // namespace

std::string rulesText(std::span<const RuleSurvey> rules, std::span<const DriverPass> passes) {
  std::string text;
  auto out = std::back_inserter(text);
  for (const RuleSurvey& rule : rules) writeRule(out, rule, passes);
  for (size_t i = 0; i < passes.size(); ++i) {
    *out++ = '\n';
    writeDriver(out, passes[i], i, rules);
  }
  return text;
}

}  // namespace rasterdiff::harness
