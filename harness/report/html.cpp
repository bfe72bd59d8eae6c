#include "harness/report/html.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "harness/report/markup.hpp"
#include "harness/report/numbers.hpp"
#include "harness/report/rule_survey.hpp"
#include "harness/report/time_text.hpp"
#include "rasterizer/freedoms.hpp"
#include "rasterizer/rule_counts.hpp"
#include "report_css.hpp"

namespace rasterdiff::harness {
namespace {

using Out = std::back_insert_iterator<std::string>;

void writeHeader(Out out, const Report& report) {
  const RunSubject& subject = report.subject;
  const bool passed = exitStatus(report) == 0;
  fmt::format_to(out, "<header><h1>rasterdiff</h1><div class=\"driver\"><b>{}</b><br>", escaped(subject.line));
  fmt::format_to(out, "<span class=\"soft\">{}; {} subpixel bits",
                 subject.rulesOpen ? "Rules: the Vulkan specification, every choice open"
                                   : "Rules: profile " + escaped(subject.rules) + ", coverage must agree exactly",
                 subject.limits.subPixelPrecisionBits);
  fmt::format_to(out, "</span></div><div class=\"badge{}\">{}</div></header>\n", passed ? "" : " fail", passed ? "PASS" : "FAIL");
}

void writeTiles(Out out, const Report& report, const Totals& totals) {
  const auto tile = [&](const std::string& number, std::string_view what) {
    fmt::format_to(out, "<div class=\"tile\"><b>{}</b><span>{}</span></div>\n", number, what);
  };
  fmt::format_to(out, "<div class=\"tiles\">\n");
  tile(grouped(totals.scenes + totals.errors), totals.skipped > 0
                                                   ? fmt::format("scenes, {} of them skipped", grouped(totals.skipped))
                                                   : "scenes");
  tile(grouped(totals.primitives), "primitives");
  tile(grouped(totals.samples), "samples compared");
  tile(grouped(totals.same), "samples the same");
  tile(grouped(totals.allowed), "samples allowed");
  tile(grouped(totals.differing), totals.expected > 0 ? fmt::format("samples differ; {} as the baseline expects",
                                                                    counted(totals.expected, "scene"))
                                                      : "samples differ");
  if (totals.values > 0) tile(grouped(totals.valuesDiffering), fmt::format("of {} values differ", grouped(totals.values)));
  tile(secondsText(report.wallSeconds), fmt::format("wall, {}", counted(report.workers, "worker")));
  fmt::format_to(out, "</div>\n<p class=\"soft\">Time: {}. {}.</p>\n", timeText(totals.seconds), shareText(totals.seconds));
}

/// The picture at the top: the largest mesh.
const SceneEntry* heroOf(const Report& report) {
  const SceneEntry* hero = nullptr;
  for (const SceneEntry& entry : report.scenes) {
    if (entry.pictures.reference.empty() || !entry.result.id.starts_with("mesh/")) continue;
    if (!hero || entry.samplesPerPixel > hero->samplesPerPixel) hero = &entry;
  }
  return hero;
}

void writeHero(Out out, const SceneEntry& hero) {
  const SceneResult& result = hero.result;
  const Pictures& pictures = hero.pictures;
  fmt::format_to(out, "<section class=\"hero\"><div class=\"pair\"><figure>{}<span class=\"tag\">driver</span></figure>",
                 htmlPicture(pictures.driver, pictures.width, pictures.height, "driver"));
  fmt::format_to(out, "<figure>{}<span class=\"tag\">difference: ochre = other bits, inside the legal interval</span></figure></div>",
                 htmlPicture(pictures.difference, pictures.width, pictures.height, "difference"));
  fmt::format_to(out,
                 "<div class=\"about\"><span class=\"chip {0}\">{0}</span><b>{1}</b><span class=\"soft\">{2}, {3} a pixel: "
                 "{4} same, {5} allowed, {6} differ.</span></div></section>\n",
                 verdictName(hero), escaped(result.id), escaped(hero.what), counted(hero.samplesPerPixel, "sample"),
                 counted(result.same, "sample"), grouped(result.allowed), grouped(result.differing));
}

std::string bar(const Totals& totals) {
  if (totals.samples == 0) return {};
  const auto part = [&](uint64_t count) {
    const double share = 100 * static_cast<double>(count) / static_cast<double>(totals.samples);
    return count == 0 ? 0 : std::max(3.0, share);  // what is there can be seen
  };
  const double differs = part(totals.differing), allowed = part(totals.allowed);
  return fmt::format("<div class=\"bar\"><i class=\"same\" style=\"width:{:.1f}%\"></i><i class=\"allowed\" style=\"width:{:.1f}%\">"
                     "</i><i class=\"differs\" style=\"width:{:.1f}%\"></i></div>",
                     100 - differs - allowed, allowed, differs);
}

void writeFamilyRow(Out out, std::string_view name, const Totals& totals, bool all) {
  const auto wrong = [](uint64_t count) { return count > 0 ? "bad" : "zero"; };
  fmt::format_to(out,
                 "<tr{}><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td class=\"{}\">{}</td><td>{}</td>"
                 "<td class=\"{}\">{}</td><td>{}</td><td>{}</td></tr>\n",
                 all ? " class=\"all\"" : "", escaped(name), grouped(totals.scenes + totals.errors),
                 grouped(totals.samples), grouped(totals.same), grouped(totals.allowed), wrong(totals.differing),
                 grouped(totals.differing), grouped(totals.values), wrong(totals.valuesDiffering),
                 grouped(totals.valuesDiffering), totals.values > 0 ? ulps(totals.maxUlp) : "–", bar(totals));
}

void writeFamilies(Out out, const Report& report, const Totals& totals) {
  fmt::format_to(out, "<h2>Families</h2><div class=\"scroll\"><table><thead><tr><th>family</th><th>scenes</th><th>samples</th>"
                      "<th>same</th><th>allowed</th><th>differ</th><th>values</th><th>differ</th><th>worst ULP</th><th></th>"
                      "</tr></thead><tbody>\n");
  for (const auto& [family, sums] : totalsByFamily(report.scenes)) writeFamilyRow(out, family, sums, false);
  writeFamilyRow(out, "all", totals, true);
  fmt::format_to(out, "</tbody></table></div>\n");
}

void writeFreedoms(Out out, const Totals& totals) {
  fmt::format_to(out, "<div><h2>Freedoms used</h2>\n");
  if (totals.freedoms.empty()) {
    fmt::format_to(out, "<p class=\"soft\">None: every sample has the reference's own answer.</p></div>\n");
    return;
  }
  fmt::format_to(out, "<div class=\"scroll\"><table><thead><tr><th>freedom</th><th>samples</th><th></th></tr></thead><tbody>\n");
  for (const auto& [id, count] : totals.freedoms) {
    std::string_view what, anchor;
    for (const rasterizer::FreedomInfo& freedom : rasterizer::freedoms()) {
      if (freedom.id == id) what = freedom.what, anchor = freedom.anchor;
    }
    fmt::format_to(out, "<tr><td>{}</td><td>{}</td><td class=\"text\">{} <code class=\"soft\">{}</code></td></tr>\n", escaped(id),
                   grouped(count), escaped(what), escaped(anchor));
  }
  fmt::format_to(out, "</tbody></table></div></div>\n");
}

void writeRules(Out out, const Totals& totals) {
  fmt::format_to(out, "<div><h2>Rule coverage<small>how often each rule decided an outcome</small></h2><div class=\"scroll\"><table>"
                      "<thead><tr><th>rule</th><th>decided</th></tr></thead><tbody>\n");
  const auto counted = rasterizer::countedRules();
  std::vector<rasterizer::RuleInfo> rules(counted.begin(), counted.end());
  std::ranges::stable_sort(rules, {}, [](const rasterizer::RuleInfo& rule) { return ruleNumber(rule.id); });
  for (const rasterizer::RuleInfo& rule : rules) {
    const auto found = totals.ruleCoverage.find(std::string(rule.id));
    const uint64_t decided = found == totals.ruleCoverage.end() ? 0 : found->second;
    fmt::format_to(out, "<tr><td class=\"text\">{} {} <code class=\"soft\">{}</code></td><td class=\"{}\">{}</td></tr>\n", escaped(rule.id),
                   escaped(rule.name), escaped(rule.anchor), decided == 0 ? "zero" : "", grouped(decided));
  }
  fmt::format_to(out, "</tbody></table></div></div>\n");
}

/// The failed scenes, or all others.
void writeScenes(Out out, const Report& report, bool failed) {
  for (const SceneEntry* entry : worstFirst(report)) {
    if (hasFailed(*entry) == failed) fmt::format_to(out, "{}", htmlScene(report, *entry));
  }
}

void writeFailures(Out out, const Report& report) {
  const auto failures = std::ranges::count_if(report.scenes, hasFailed);
  if (failures == 0 && report.stopped.empty()) return;
  fmt::format_to(out, "<h2>What failed<small>{}, the worst first</small></h2>\n", counted(static_cast<uint64_t>(failures), "scene"));
  if (!report.stopped.empty()) {
    fmt::format_to(out, "<p><b>Stopped: {}; {} not run.</b></p>\n", escaped(report.stopped), counted(report.notRun, "scene"));
  }
  writeScenes(out, report, true);
}

}  // namespace

std::string htmlReport(const Report& report) {
  const Totals totals = totalsOf(report.scenes);
  std::string text;
  const auto out = std::back_inserter(text);
  fmt::format_to(out,
                 "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
                 "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">"
                 "<title>rasterdiff: {} on {}</title><link rel=\"icon\" href=\"data:,\"><style>\n{}</style></head><body><main>\n",
                 exitStatus(report) == 0 ? "PASS" : "FAIL", escaped(report.subject.name), kReportCss);
  writeHeader(out, report);
  if (const SceneEntry* hero = heroOf(report)) writeHero(out, *hero);
  writeTiles(out, report, totals);
  writeFailures(out, report);
  writeFamilies(out, report, totals);
  fmt::format_to(out, "<div class=\"columns\">\n");
  writeRules(out, totals);
  writeFreedoms(out, totals);
  fmt::format_to(out, "</div>\n");
  fmt::format_to(out, "<h2>{}</h2>\n", std::ranges::any_of(report.scenes, hasFailed) ? "The other scenes" : "Scenes");
  writeScenes(out, report, false);
  fmt::format_to(out, "<footer>{}</footer>\n</main></body></html>\n", escaped(verdictLine(report)));
  return text;
}

}  // namespace rasterdiff::harness
