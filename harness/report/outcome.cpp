// What a run amounts to: its exit status, its verdict in one line, the command that goes on from a failure.
#include <fmt/format.h>

#include <algorithm>

#include "harness/report/numbers.hpp"
#include "harness/report/report.hpp"

namespace rasterdiff::harness {

namespace {

/// How much an entry wants attention.
int urgency(const SceneEntry& entry) {
  if (entry.error) return 6;
  if (entry.result.baseline == BaselineStatus::Improved) return 4;
  if (entry.result.baseline == BaselineStatus::ExpectedDiff) return 3;
  switch (entry.result.verdict) {
    case Verdict::Crashed: return 8;
    case Verdict::TimedOut: return 7;
    case Verdict::Differs: return 5;
    case Verdict::Skipped: return 2;
    case Verdict::Allowed: return 1;
    case Verdict::Same: return 0;
  }
  return 0;
}

std::string rulesOption(const Report& report) {
  return " --rules " + shellQuoted(report.rulesOption.empty() ? report.subject.rules : report.rulesOption);
}

}  // namespace

bool hasFailed(const SceneEntry& entry) {
  return entry.error || !entry.validationMessages.empty() || isUnexpected(entry.result);
}

int exitStatus(const Report& report) {
  const Totals totals = totalsOf(report.scenes);
  if (totals.crashed + totals.timedOut > 0 || report.notRun > 0) return 4;
  if (totals.errors > 0) return 2;
  if (totals.unexpected > 0 || totals.validationMessages > 0) return 1;
  if (totals.scenesSame + totals.scenesAllowed + totals.scenesDiffer == 0) return 3;
  return 0;
}

std::string verdictLine(const Report& report) {
  const Totals totals = totalsOf(report.scenes);
  const uint64_t compared = totals.scenesSame + totals.scenesAllowed + totals.scenesDiffer;
  std::string line = exitStatus(report) == 0 ? "PASS: " : "FAIL: ";
  line += fmt::format("{} compared, {} samples: {} same, {} allowed, {} differ", counted(compared, "scene"),
                      grouped(totals.samples), grouped(totals.same), grouped(totals.allowed),
                      grouped(totals.differing));
  if (totals.values > 0) {
    line += fmt::format("; {} values: {} same, {} allowed, {} differ", grouped(totals.values),
                        grouped(totals.valuesSame), grouped(totals.valuesAllowed), grouped(totals.valuesDiffering));
  }
  if (totals.expected > 0) line += fmt::format("; {} as the baseline expects", counted(totals.expected, "scene"));
  if (totals.improved > 0) line += fmt::format("; {} better than the baseline", counted(totals.improved, "scene"));
  if (totals.skipped > 0) line += fmt::format("; {} skipped", counted(totals.skipped, "scene"));
  if (totals.crashed > 0) line += fmt::format("; {} crashed the driver", counted(totals.crashed, "scene"));
  if (totals.timedOut > 0) line += fmt::format("; {} hung", counted(totals.timedOut, "scene"));
  if (totals.errors > 0) line += fmt::format("; {} could not be made", counted(totals.errors, "scene"));
  if (totals.validationMessages > 0) {
    line += fmt::format("; {}", counted(totals.validationMessages, "validation message"));
  }
  if (report.notRun > 0) line += fmt::format("; {} not run", counted(report.notRun, "scene"));
  return line;
}

std::string explainCommand(const Report& report, const SceneEntry& entry) {
  if (entry.error) return {};
  const SceneResult& result = entry.result;
  const std::string scene = shellQuoted(entry.address);
  const std::string driver = " --driver " + shellQuoted(report.subject.driver);
  if (result.verdict == Verdict::Crashed || result.verdict == Verdict::TimedOut) {
    return fmt::format("rasterdiff check {}{} --jobs 1", scene, driver);
  }
  if (entry.address.starts_with(kInvariantPrefix)) {
    if (result.verdict != Verdict::Differs) return {};
    return fmt::format("rasterdiff invariants {}{} --count {}", shellQuoted(entry.address.substr(kInvariantPrefix.size())), driver, kInvariantCases);
  }
  const std::string rules = rulesOption(report);
  const auto command = [&](uint32_t x, uint32_t y, uint32_t sample) {
    return fmt::format("rasterdiff explain {} {} {} --sample {}{}{}", scene, x, y, sample, driver, rules);
  };
  if (!result.differences.empty()) {
    const SampleDifference& first = result.differences.front();
    return command(first.x, first.y, first.sample);
  }
  for (const ValueStats& value : result.values) {
    if (value.firstDiffering) return command(value.firstDiffering->x, value.firstDiffering->y, value.firstDiffering->sample);
  }
  return {};
}

std::vector<const SceneEntry*> worstFirst(const Report& report) {
  std::vector<const SceneEntry*> entries;
  for (const SceneEntry& entry : report.scenes) entries.push_back(&entry);
  std::stable_sort(entries.begin(), entries.end(),
                   [](const SceneEntry* a, const SceneEntry* b) { return urgency(*a) > urgency(*b); });
  return entries;
}

std::string_view verdictName(const SceneEntry& entry) {
  return entry.error ? std::string_view("Error") : toString(entry.result.verdict);
}

std::string nextCommand(const Report& report) {
  const int status = exitStatus(report);
  if (status == 0) return {};
  if (status == 3) return "rasterdiff devices";
  for (const SceneEntry* entry : worstFirst(report)) {
    if (entry->error && entry->error->hint.starts_with("rasterdiff ")) return entry->error->hint;
    if (entry->error) return fmt::format("rasterdiff check {} --jobs 1", shellQuoted(entry->address));
    if (entry->result.baseline == BaselineStatus::Improved) {
      return fmt::format("rasterdiff check {} --driver {}{} --baseline none", shellQuoted(entry->address),
                         shellQuoted(report.subject.driver), rulesOption(report));
    }
    if (!isUnexpected(entry->result)) break;
    if (std::string command = explainCommand(report, *entry); !command.empty()) return command;
  }
  for (const SceneEntry& entry : report.scenes) {
    if (entry.validationMessages.empty()) continue;
    return fmt::format("rasterdiff check {} --driver {} --validate", shellQuoted(entry.address),
                       shellQuoted(report.subject.driver));
  }
  return "rasterdiff check --help";
}

}  // namespace rasterdiff::harness
