#include "harness/report/summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <iterator>

#include "harness/report/numbers.hpp"
#include "harness/report/rule_survey.hpp"
#include "harness/report/time_text.hpp"
#include "rasterizer/rule_counts.hpp"

namespace rasterdiff::harness {
namespace {

constexpr size_t kShownFailures = 10;
constexpr size_t kShownSkips = 12;
constexpr size_t kShownValues = 8;

using Out = std::back_insert_iterator<std::string>;

void writeHead(Out out, const Report& report) {
  const RunSubject& subject = report.subject;
  fmt::format_to(out, "driver    {}\nrules     {}, {} subpixel bits\n\n", subject.line,
                 subject.rulesOpen ? "the Vulkan specification, every choice open"
                                   : fmt::format("profile {}: coverage must agree exactly", subject.rules),
                 subject.limits.subPixelPrecisionBits);
}

void writeRow(Out out, std::string_view family, const Totals& totals) {
  fmt::format_to(out, "{:<14} {:>6} {:>15} {:>15} {:>11} {:>9} {:>15} {:>9} {:>12}\n", family,
                 grouped(totals.scenes + totals.errors), grouped(totals.samples), grouped(totals.same),
                 grouped(totals.allowed), grouped(totals.differing), grouped(totals.values),
                 grouped(totals.valuesDiffering), totals.values > 0 ? ulps(totals.maxUlp) : "-");
}

void writeTable(Out out, const Report& report, const Totals& totals) {
  fmt::format_to(out, "{:<14} {:>6} {:>15} {:>15} {:>11} {:>9} {:>15} {:>9} {:>12}\n", "family", "scenes", "samples",
                 "same", "allowed", "differs", "values", "differ", "worst ULP");
  for (const auto& [family, sums] : totalsByFamily(report.scenes)) writeRow(out, family, sums);
  writeRow(out, "all", totals);
  *out++ = '\n';
}

std::string ruleName(const std::string& id) {
  for (const rasterizer::RuleInfo& rule : rasterizer::countedRules()) {
    if (rule.id == id) return fmt::format("{} {}", id, rule.name);
  }
  return id;
}

/// "R14 sample-coverage 1,234 · …", folded at 110 columns under its label.
void writeCounts(Out out, std::string_view label, const std::map<std::string, uint64_t>& counts, bool rules) {
  if (counts.empty()) return;
  std::vector<std::pair<std::string, uint64_t>> sorted(counts.begin(), counts.end());
  if (rules) std::ranges::stable_sort(sorted, {}, [](const auto& item) { return ruleNumber(item.first); });
  constexpr size_t kWidth = 110, kIndent = 10;
  fmt::format_to(out, "{:<10}", label);
  size_t column = kIndent;
  for (size_t i = 0; i < sorted.size(); ++i) {
    const std::string item = fmt::format("{}{} {}{}", column > kIndent ? " " : "", rules ? ruleName(sorted[i].first) : sorted[i].first,
                                         grouped(sorted[i].second), i + 1 < sorted.size() ? "," : "");
    const bool fold = column > kIndent && column + item.size() > kWidth;
    if (fold) fmt::format_to(out, "\n{:{}}", "", kIndent);
    fmt::format_to(out, "{}", fold ? item.substr(1) : item);
    column = (fold ? kIndent - 1 : column) + item.size();
  }
  *out++ = '\n';
}

/// Names that differ first, then by how much was compared.
std::vector<const ValueStats*> valuesToShow(const Totals& totals) {
  std::vector<const ValueStats*> values;
  for (const auto& [name, value] : totals.byValue) {
    if (value.compared > 0) values.push_back(&value);
  }
  std::ranges::stable_sort(values, std::greater{}, [](const ValueStats* value) {
    return std::pair(value->differing, value->compared);
  });
  return values;
}

void writeValues(Out out, const Totals& totals) {
  const std::vector<const ValueStats*> values = valuesToShow(totals);
  if (values.empty()) return;
  fmt::format_to(out, "\n{:<14} {:>13} {:>13} {:>13} {:>9} {:>10} {:>9} {:>11}  {}\n", "value", "compared", "same bits",
                 "allowed", "differ", "max ULP", "mean ULP", "error/bound", "worst at");
  for (size_t i = 0; i < values.size() && i < kShownValues; ++i) {
    const ValueStats& value = *values[i];
    std::string worst;
    const auto at = totals.worstAt.find(value.name);
    if (value.worst && value.maxUlp > 0 && at != totals.worstAt.end()) {
      worst = fmt::format("  {} {} {} --sample {}", shellQuoted(at->second), value.worst->x, value.worst->y,
                          value.worst->sample);
    }
    fmt::format_to(out, "{:<14} {:>13} {:>13} {:>13} {:>9} {:>10} {:>9.3g} {:>11.3g}{}\n", value.name,
                   grouped(value.compared), grouped(value.same), grouped(value.allowed), grouped(value.differing),
                   ulps(value.maxUlp), value.meanUlp, value.maxRatio, worst);
  }
  if (values.size() > kShownValues) {
    fmt::format_to(out, "and {}, all in --json and --report\n", counted(values.size() - kShownValues, "more value"));
  }
  fmt::format_to(out, "\n");
}

std::string firstDifference(const SceneEntry& entry) {
  const SceneResult& result = entry.result;
  if (!result.differences.empty()) {
    const SampleDifference& d = result.differences.front();
    return fmt::format("({}, {}) sample {}: expected {} (drawn {}), got {} (drawn {})", d.x, d.y, d.sample,
                       primitiveText(d.expectedPrimitive), counted(d.expectedCount, "time"),
                       primitiveText(d.actualPrimitive), counted(d.actualCount, "time"));
  }
  for (const ValueStats& value : result.values) {
    if (!value.firstDiffering) continue;
    const ValueStats::Worst& place = *value.firstDiffering;
    return fmt::format("({}, {}) sample {}: {}[{}] is {}, legal is {} to {}", place.x, place.y, place.sample, value.name,
                       place.component, floatText(place.actual), floatText(place.lo), floatText(place.hi));
  }
  return {};
}

void writeFailure(Out out, const Report& report, const SceneEntry& entry) {
  if (entry.error) {
    fmt::format_to(out, "Error     {}: {}: {}\n          {}\n", entry.result.id, entry.error->where, entry.error->what,
                   entry.error->hint);
    return;
  }
  if (entry.result.baseline == BaselineStatus::Improved) {
    fmt::format_to(out, "Improved  {}: the baseline expects a difference that is gone: {}\n", entry.address,
                   entry.result.baselineReason);
    return;
  }
  fmt::format_to(out, "{:<9} {}{}{}\n", verdictName(entry), entry.address, entry.result.reason.empty() ? "" : ": ",
                 entry.result.reason);
  if (const std::string first = firstDifference(entry); !first.empty()) fmt::format_to(out, "          {}\n", first);
  if (const std::string command = explainCommand(report, entry); !command.empty()) {
    fmt::format_to(out, "          {}\n", command);
  }
}

void writeFailures(Out out, const Report& report) {
  size_t shown = 0, hidden = 0;
  for (const SceneEntry* entry : worstFirst(report)) {
    if (!entry->error && !isUnexpected(entry->result)) continue;
    if (shown == kShownFailures) {
      ++hidden;
      continue;
    }
    ++shown;
    writeFailure(out, report, *entry);
  }
  if (hidden > 0) fmt::format_to(out, "          and {} that failed, all in --json and --report\n", counted(hidden, "more scene"));
}

void writeSkips(Out out, const Report& report) {
  size_t shown = 0, hidden = 0;
  for (const SceneEntry& entry : report.scenes) {
    if (entry.error || entry.result.verdict != Verdict::Skipped) continue;
    if (shown == kShownSkips) {
      ++hidden;
      continue;
    }
    ++shown;
    fmt::format_to(out, "Skipped   {}: {}\n", entry.address, entry.result.reason);
  }
  if (hidden > 0) fmt::format_to(out, "          and {} skipped, all in --json and --report\n", counted(hidden, "more scene"));
}

void writeExpected(Out out, const Report& report) {
  std::map<std::string, std::vector<std::string>> scenesOfReason;
  for (const SceneEntry& entry : report.scenes) {
    if (entry.error || entry.result.baseline != BaselineStatus::ExpectedDiff) continue;
    scenesOfReason[entry.result.baselineReason].push_back(entry.address);
  }
  for (const auto& [reason, scenes] : scenesOfReason) {
    fmt::format_to(out, "Expected  {}\n          {}\n", reason, fmt::join(scenes, ", "));
  }
}

void writeValidation(Out out, const Report& report) {
  size_t shown = 0;
  for (const SceneEntry& entry : report.scenes) {
    for (const std::string& message : entry.validationMessages) {
      if (shown++ == kShownFailures) return;
      fmt::format_to(out, "Validation {}: {}\n", entry.address, oneLine(message));
    }
  }
}

// "placed    3 scenes: one placement of the vertices explains all samples of each (12 vertices moved)"
void writePlacements(Out out, const Report& report, const Totals& totals) {
  for (const auto& [state, scenes] : totals.placements) {
    if (state == PlacementAnswer::State::Explained) {
      uint64_t moved = 0;
      for (const SceneEntry& entry : report.scenes) {
        if (entry.result.placement && entry.result.placement->state == state) moved += entry.result.placement->movedVertices;
      }
      fmt::format_to(out, "placed    {}: one placement of the vertices explains all samples together ({} moved)\n",
                     counted(scenes, "scene"), grouped(moved));
      continue;
    }
    fmt::format_to(out, "placed    {}: {}\n", counted(scenes, "scene"), toString(state));
  }
}

}  // namespace

std::string summaryText(const Report& report) {
  const Totals totals = totalsOf(report.scenes);
  std::string text;
  const auto out = std::back_inserter(text);
  writeHead(out, report);
  writeTable(out, report, totals);
  writeCounts(out, "freedoms", totals.freedoms, false);
  writePlacements(out, report, totals);
  writeCounts(out, "decided", totals.ruleCoverage, true);
  writeValues(out, totals);
  fmt::format_to(out, "time      {}\n", timeText(totals.seconds));
  fmt::format_to(out, "          {}; wall {} on {}; {} drawn\n", shareText(totals.seconds), secondsText(report.wallSeconds),
                 counted(report.workers, "worker"), counted(totals.primitives, "primitive"));
  text += '\n';
  writeSkips(out, report);
  writeExpected(out, report);
  writeFailures(out, report);
  writeValidation(out, report);
  if (!report.stopped.empty()) {
    fmt::format_to(out, "Stopped   {}; {} not run\n", report.stopped, counted(report.notRun, "scene"));
  }
  fmt::format_to(out, "{}\n", verdictLine(report));
  return text;
}

}  // namespace rasterdiff::harness
