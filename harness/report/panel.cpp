#include "harness/report/panel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <iterator>

#include "harness/report/json_parts.hpp"
#include "harness/report/numbers.hpp"

namespace rasterdiff::harness {
namespace {

constexpr size_t kShownFamilies = 4, kShownScenes = 3;

/// "fill 12, clip 4 and 3 more families": those that caught it most often.
std::string familiesText(const PanelRow& row) {
  std::vector<std::pair<std::string, uint64_t>> families(row.families.begin(), row.families.end());
  std::ranges::stable_sort(families, std::greater{}, &std::pair<std::string, uint64_t>::second);
  std::string text;
  for (size_t i = 0; i < families.size() && i < kShownFamilies; ++i) {
    text += fmt::format("{}{} {}", i == 0 ? "" : ", ", families[i].first, families[i].second);
  }
  if (families.size() > kShownFamilies) text += fmt::format(" and {} more", families.size() - kShownFamilies);
  return text;
}

std::string failureText(const PanelRow& row) {
  if (!row.refusal.empty()) return row.refusal;
  if (row.crashed > 0) return fmt::format("{} crashed, hung or could not be made", counted(row.crashed, "scene"));
  if (row.shouldDiffer) return "not caught";
  std::string text = fmt::format("{} differ: ", counted(row.failing.size(), "scene"));
  for (size_t i = 0; i < row.failing.size() && i < kShownScenes; ++i) text += (i == 0 ? "" : ", ") + row.failing[i];
  if (row.failing.size() > kShownScenes) text += ", …";
  return text;
}

size_t failures(const Panel& panel) { return static_cast<size_t>(std::ranges::count_if(panel.rows, &PanelRow::failed)); }

/// All scenes' samples and values together.
std::string totalText(const Panel& panel) {
  uint64_t scenes = 0, samples = 0, differing = 0, values = 0, valuesDiffering = 0;
  for (const PanelRow& row : panel.rows) {
    scenes += row.scenes;
    samples += row.samples;
    differing += row.differing;
    values += row.values;
    valuesDiffering += row.valuesDiffering;
  }
  return fmt::format("{} compared, {} samples, {} differ; {} values, {} differ; {}", counted(scenes, "scene"), grouped(samples),
                     grouped(differing), grouped(values), grouped(valuesDiffering), secondsText(panel.wallSeconds));
}

/// "fewest 1, median 14, most 512 scenes".
std::string catchersText(const Panel& panel) {
  std::vector<size_t> counts;
  for (const PanelRow& row : panel.rows) counts.push_back(row.failing.size());
  std::ranges::sort(counts);
  return fmt::format("fewest {}, median {}, most {} scenes", grouped(counts.front()), grouped(counts[counts.size() / 2]), grouped(counts.back()));
}

}  // namespace

PanelRow panelRow(const Report& pass, bool shouldDiffer) {
  PanelRow row;
  row.driver = pass.subject.driver;
  row.info = pass.subject.info;
  row.shouldDiffer = shouldDiffer;
  row.seconds = pass.wallSeconds;
  const Totals totals = totalsOf(pass.scenes);
  row.scenes = totals.scenesSame + totals.scenesAllowed + totals.scenesDiffer;
  row.samples = totals.samples;
  row.differing = totals.differing;
  row.values = totals.values;
  row.valuesDiffering = totals.valuesDiffering;
  row.crashed = totals.crashed + totals.timedOut + totals.errors + pass.notRun;
  for (const SceneEntry& entry : pass.scenes) {
    if (!hasFailed(entry)) continue;
    row.failing.push_back(entry.address);
    ++row.families[familyOf(entry)];
  }
  return row;
}

int exitStatus(const Panel& panel) {
  const auto some = [&](auto&& test) { return std::ranges::any_of(panel.rows, test); };
  if (some([](const PanelRow& row) { return row.crashed > 0; })) return 4;
  if (some([](const PanelRow& row) { return !row.refusal.empty(); })) return 3;
  return failures(panel) > 0 ? 1 : 0;
}

std::string panelText(const Panel& panel) {
  std::string text;
  const auto out = std::back_inserter(text);
  const bool mutants = !panel.rows.empty() && panel.rows.front().shouldDiffer;
  const auto width = [](const PanelRow& row) { return row.driver.size(); };
  const size_t column = std::max<size_t>(6, panel.rows.empty() ? 0 : std::ranges::max(panel.rows, {}, width).driver.size());
  if (mutants) fmt::format_to(out, "{:<{}}  {:>6}  caught by\n", "driver", column, "scenes");
  for (const PanelRow& row : panel.rows) {
    if (row.failed()) {
      fmt::format_to(out, "{:<{}}  {}{}\n", row.driver, column, mutants ? "     0  " : "", failureText(row));
    } else if (mutants) {
      fmt::format_to(out, "{:<{}}  {:>6}  {}\n", row.driver, column, grouped(row.failing.size()), familiesText(row));
    }
  }
  const size_t failed = failures(panel);
  if (!text.empty()) text += '\n';
  fmt::format_to(out, "{}: ", failed == 0 ? "PASS" : "FAIL");
  if (mutants) {
    fmt::format_to(out, "{} of {} caught, {}; ", grouped(panel.rows.size() - failed), counted(panel.rows.size(), "deliberate error"), catchersText(panel));
  } else {
    fmt::format_to(out, "{} of {} let through; ", grouped(panel.rows.size() - failed), counted(panel.rows.size(), "renderer"));
  }
  return text + totalText(panel) + "\n";
}

std::string panelJson(const Panel& panel) {
  Json json{{"drivers", panel.drivers}, {"rules", panel.rules}, {"failed", failures(panel)}, {"seconds", panel.wallSeconds}};
  json["passes"] = Json::array();
  for (const PanelRow& row : panel.rows) {
    Json entry{{"driver", row.driver}, {"info", row.info}, {"failed", row.failed()}, {"scenes", row.scenes}, {"samples", row.samples},
               {"differing", row.differing}, {"values", row.values}, {"valuesDiffering", row.valuesDiffering}, {"crashed", row.crashed},
               {"failing", row.failing}, {"seconds", row.seconds}};
    if (!row.refusal.empty()) entry["refusal"] = row.refusal;
    json["passes"].push_back(std::move(entry));
  }
  return textOf(json) + "\n";
}

}  // namespace rasterdiff::harness
