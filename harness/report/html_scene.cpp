// One scene of the HTML report: verdict and picture in its head; pictures, numbers, places and commands inside.
#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "harness/report/base64.hpp"
#include "harness/report/html.hpp"
#include "harness/report/markup.hpp"
#include "harness/report/numbers.hpp"
#include "harness/report/rule_survey.hpp"
#include "harness/report/time_text.hpp"

namespace rasterdiff::harness {
namespace {

constexpr size_t kShownPlaces = 16;
constexpr uint32_t kPixelsShowBelow = 300;  // smaller pictures are enlarged: their pixels stay square

using Out = std::back_insert_iterator<std::string>;

std::string baselineChip(const SceneResult& result) {
  if (result.baseline == BaselineStatus::None) return {};
  return fmt::format(" <span class=\"chip Skipped\">{}</span>",
                     result.baseline == BaselineStatus::ExpectedDiff ? "as the baseline expects" : "stale baseline entry");
}

std::string numbersOf(const SceneEntry& entry) {
  const SceneResult& result = entry.result;
  if (result.samples == 0) return {};
  std::string text = fmt::format("{} samples", grouped(result.samples));
  if (result.differing > 0) text += fmt::format("<br>{} differ", grouped(result.differing));
  if (result.allowed > 0) text += fmt::format("<br>{} allowed", grouped(result.allowed));
  uint64_t values = 0, differing = 0;
  for (const ValueStats& value : result.values) {
    values += value.compared;
    differing += value.differing;
  }
  if (values > 0) text += fmt::format("<br>{} values", grouped(values));
  if (differing > 0) text += fmt::format(", {} differ", grouped(differing));
  return text;
}

void writeHead(Out out, const SceneEntry& entry) {
  const SceneResult& result = entry.result;
  fmt::format_to(out, "<summary>");
  const Pictures& pictures = entry.pictures;
  fmt::format_to(out, "{}",
                 pictures.thumbnail.empty()
                     ? "<span class=\"thumb\"></span>"
                     : fmt::format("<img class=\"thumb{}\" alt=\"\" src=\"data:image/png;base64,{}\">",
                                   pictures.width < kPixelsShowBelow ? " pixels" : "", toBase64(pictures.thumbnail)));
  fmt::format_to(out, "<span class=\"name\"><span class=\"chip {0}\">{0}</span>{3} {1}<span class=\"what\">{2}</span></span>",
                 verdictName(entry), escaped(result.id), escaped(entry.what), baselineChip(result));
  fmt::format_to(out, "<span class=\"numbers\">{}</span></summary>\n", numbersOf(entry));
}

void writePictures(Out out, const SceneEntry& entry) {
  const Pictures& pictures = entry.pictures;
  if (pictures.reference.empty()) return;
  const auto figure = [&](const std::string& png, const std::string& caption, std::string_view what) {
    fmt::format_to(out, "<figure>{}<figcaption>{}</figcaption></figure>\n",
                   htmlPicture(png, pictures.width, pictures.height, what), caption);
  };
  fmt::format_to(out, "<div class=\"pictures\">\n");
  if (pictures.reference == pictures.driver) {
    figure(pictures.reference, "Reference and driver: the same picture", "reference and driver");
  } else {
    figure(pictures.reference, "Reference", "reference");
    figure(pictures.driver, "Driver", "driver");
  }
  figure(pictures.difference,
         "Difference<span class=\"key\" style=\"background:#e22030\"></span>differs"
         "<span class=\"key\" style=\"background:#f5c518\"></span>allowed"
         "<span class=\"key\" style=\"background:#ba8014\"></span>value allowed"
         "<span class=\"key\" style=\"background:#80848c\"></span>same",
         "difference");
  if (!pictures.closeUp.empty()) {
    fmt::format_to(out,
                   "<figure>{}<figcaption>From near: snapped vertices and edges; filled samples are the driver's"
                   "<span class=\"key\" style=\"background:#e22030\"></span>differs"
                   "<span class=\"key\" style=\"background:#f0b010\"></span>allowed</figcaption></figure>\n",
                   pictures.closeUp);
  }
  fmt::format_to(out, "</div>\n");
}

void writeFacts(Out out, const SceneEntry& entry) {
  const SceneResult& result = entry.result;
  if (result.samples == 0) return;
  fmt::format_to(out, "<p>{} × {} pixels, {}, {}, {} covered.", entry.width, entry.height,
                 counted(entry.samplesPerPixel, "sample"), counted(entry.primitives, "primitive"),
                 counted(result.coveredSamples, "sample"));
  if (entry.batches > 1) fmt::format_to(out, " {} added up.", counted(entry.batches, "batch of random triangles"));
  fmt::format_to(out, " <b>{}</b> same, <b>{}</b> allowed, <b>{}</b> differ.", grouped(result.same),
                 grouped(result.allowed), grouped(result.differing));
  fmt::format_to(out, " <span class=\"soft\">Time: {}.</span></p>\n", timeText(result.seconds));
  if (!result.freedoms.empty()) {
    fmt::format_to(out, "<p>Freedoms used:");
    for (const auto& [freedom, count] : result.freedoms) {
      fmt::format_to(out, " <span class=\"chip Allowed\">{}", escaped(freedom));
      if (count > 0) fmt::format_to(out, " {}", grouped(count));  // 0: only values made use of it
      fmt::format_to(out, "</span>");
    }
    fmt::format_to(out, "</p>\n");
  }
  if (result.placement) fmt::format_to(out, "<p>Vertices: {}.</p>\n", escaped(describe(*result.placement)));
  if (!result.ruleCoverage.empty()) {
    std::vector<std::pair<std::string, uint64_t>> rules(result.ruleCoverage.begin(), result.ruleCoverage.end());
    std::ranges::stable_sort(rules, {}, [](const auto& rule) { return ruleNumber(rule.first); });
    fmt::format_to(out, "<p class=\"soft\">Rules that decided: ");
    for (size_t i = 0; i < rules.size(); ++i) {
      fmt::format_to(out, "{}{} {}", i > 0 ? " · " : "", escaped(rules[i].first), grouped(rules[i].second));
    }
    fmt::format_to(out, "</p>\n");
  }
}

void writeValues(Out out, const SceneResult& result) {
  if (result.values.empty()) return;
  fmt::format_to(out, "<h3>Values</h3><div class=\"scroll\"><table><thead><tr><th>value</th><th>compared</th><th>same bits</th>"
                      "<th>allowed</th><th>differ</th><th>max ULP</th><th>mean ULP</th><th>max |error|</th>"
                      "<th>error / bound</th><th>worst at</th></tr></thead><tbody>\n");
  for (const ValueStats& value : result.values) {
    const std::string worst =
        value.worst ? fmt::format("({}, {}) sample {}<br>{} for {}", value.worst->x, value.worst->y, value.worst->sample,
                                  floatText(value.worst->actual), floatText(value.worst->expected))
                    : "";
    fmt::format_to(out,
                   "<tr><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td class=\"{}\">{}</td><td>{}</td><td>{:.3g}</td>"
                   "<td>{:.3g}</td><td>{:.3g}</td><td>{}</td></tr>\n",
                   escaped(value.name), grouped(value.compared), grouped(value.same), grouped(value.allowed),
                   value.differing > 0 ? "bad" : "zero", grouped(value.differing), ulps(value.maxUlp), value.meanUlp,
                   value.maxAbs, value.maxRatio, worst);
  }
  fmt::format_to(out, "</tbody></table></div>\n");
}

void writePlaces(Out out, const SceneResult& result) {
  if (result.differences.empty()) return;
  fmt::format_to(out, "<h3>Samples that are not the same: the first {} of {}</h3><div class=\"scroll\"><table><thead><tr>"
                      "<th>pixel</th><th>sample</th><th>verdict</th><th>expected</th><th>got</th><th>drawn</th><th class=\"text\">reason</th>"
                      "</tr></thead><tbody>\n",
                 std::min(kShownPlaces, result.differences.size()), grouped(result.allowed + result.differing));
  for (size_t i = 0; i < std::min(kShownPlaces, result.differences.size()); ++i) {
    const SampleDifference& d = result.differences[i];
    fmt::format_to(out,
                   "<tr><td>({}, {})</td><td>{}</td><td><span class=\"chip {}\">{}</span></td><td>{}</td>"
                   "<td>{}</td><td>{} → {}</td><td class=\"text\">{} <code class=\"soft\">{}</code></td></tr>\n",
                   d.x, d.y, d.sample, toString(d.verdict), toString(d.verdict), primitiveText(d.expectedPrimitive),
                   primitiveText(d.actualPrimitive), d.expectedCount, d.actualCount, escaped(d.reason), escaped(d.anchor));
  }
  fmt::format_to(out, "</tbody></table></div>\n");
}

}  // namespace

std::string htmlPicture(std::string_view png, uint32_t width, uint32_t height, std::string_view what) {
  return fmt::format("<img{} width=\"{}\" height=\"{}\" alt=\"{}\" src=\"data:image/png;base64,{}\">",
                     width < kPixelsShowBelow ? " class=\"pixels\"" : "", width, height, what, toBase64(png));
}

std::string htmlScene(const Report& report, const SceneEntry& entry) {
  const SceneResult& result = entry.result;
  std::string text;
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "<details class=\"scene\"{}>", hasFailed(entry) ? " open" : "");
  writeHead(out, entry);
  fmt::format_to(out, "<div class=\"body\">\n");
  if (entry.error) {
    fmt::format_to(out, "<p><b>{}: {}</b><br>{}</p>\n", escaped(entry.error->where), escaped(entry.error->what),
                   escaped(entry.error->hint));
  } else if (!result.reason.empty()) {
    fmt::format_to(out, "<p><b>{}</b></p>\n", escaped(result.reason));
    if (!result.baselineReason.empty()) fmt::format_to(out, "<p>Baseline: {}</p>\n", escaped(result.baselineReason));
  }
  if (const std::string command = explainCommand(report, entry); !command.empty()) {
    fmt::format_to(out, "<pre>{}</pre>\n", escaped(command));
  }
  writePictures(out, entry);
  writeFacts(out, entry);
  writePlaces(out, result);
  writeValues(out, result);
  for (const std::string& message : entry.validationMessages) fmt::format_to(out, "<pre>{}</pre>\n", escaped(message));
  if (!entry.rules.empty()) {
    fmt::format_to(out, "<p class=\"soft\">Exercises {}.", escaped(fmt::format("{}", fmt::join(entry.rules, ", "))));
    if (entry.link.starts_with("https://")) {
      fmt::format_to(out, " Comes from <a href=\"{0}\">{0}</a>.", escaped(entry.link));
    } else if (!entry.link.empty()) {
      fmt::format_to(out, " Comes from {}.", escaped(entry.link));
    }
    fmt::format_to(out, "</p>\n");
  }
  fmt::format_to(out, "</div></details>\n");
  return text;
}

}  // namespace rasterdiff::harness
