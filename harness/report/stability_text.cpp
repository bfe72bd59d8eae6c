#include "harness/report/stability_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

#include "harness/report/numbers.hpp"

namespace rasterdiff::harness {
namespace {

using namespace stability;

constexpr int kNameWidth = 32, kCellWidth = 10;

void writeRow(std::string& text, const Series& series) {
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "    {:<{}}", series.method, kNameWidth);
  for (const Point& point : series.points) fmt::format_to(out, "{:>{}}", cellText(series, point), kCellWidth);
  fmt::format_to(out, "  {}\n", breakText(series));
}

bool isAlwaysRight(const Series& series) {
  return std::ranges::all_of(series.points, [](const Point& p) { return p.wrong == 0; });
}

void writeFamily(std::string& text, const Results& results, const Family& family) {
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "{}: {}\n  {:<{}}", family.name, family.what, family.dial, kNameWidth + 2);
  for (const double dial : family.values) fmt::format_to(out, "{:>{}}", dialText(dial), kCellWidth);
  fmt::format_to(out, "  breaks at\n  wrong samples\n");
  size_t right = 0;
  for (const Series* series : seriesOf(results, family.name, false)) {
    if (isAlwaysRight(*series) && !series->judged) {
      ++right;
    } else {
      writeRow(text, *series);
    }
  }
  if (right > 0) fmt::format_to(out, "    {} never wrong\n", counted(right, "method"));
  text += "  largest error of a value, ULP\n";
  for (const Series* series : seriesOf(results, family.name, true)) writeRow(text, *series);
  text += '\n';
}

}  // namespace

std::string dialText(double dial) {
  if (dial < 1) return fmt::format("{:.3g}", dial);
  if (dial < 1000) return fmt::format("{:.4g}", dial);
  if (dial < 100000) return grouped(static_cast<uint64_t>(dial));
  return fmt::format("1e{:.0f}", std::log10(dial));
}

std::string cellText(const Series& series, const Point& point) {
  if (!point.offered) return "-";
  if (!series.values) return grouped(point.wrong);
  if (point.notFinite > 0) return "n/f!";
  const std::string error = point.maxUlp < 1e5 ? ulps(point.maxUlp) : fmt::format("{:.1e}", point.maxUlp);
  return fmt::format("{}{}", error, isBroken(series, point) ? "!" : "");
}

std::string breakText(const Series& series) {
  const std::optional<double> at = breaksAt(series);
  return at ? dialText(*at) : "never";
}

std::string stabilityText(const Results& results) {
  std::string text;
  const auto out = std::back_inserter(text);
  for (const Family& family : results.families) writeFamily(text, results, family);
  std::map<std::string, std::string> broken;
  std::vector<std::string> order;
  for (const Series& series : results.series) {
    const std::string name = fmt::format("{} ({})", series.method, series.values ? "values" : "coverage");
    const auto [entry, isNew] = broken.try_emplace(name);
    if (isNew) order.push_back(name);
    if (const auto at = breaksAt(series)) {
      entry->second += fmt::format("{}{} {}", entry->second.empty() ? "" : ", ", series.family, dialText(*at));
    }
  }
  text += "Where each breaks\n";
  for (const std::string& name : order) fmt::format_to(out, "  {:<38} {}\n", name, broken[name].empty() ? "nowhere" : broken[name]);
  fmt::format_to(out, "\nA method's values break where more than {:.0f} ULP (half of 24 bits) are lost, or one is not finite;\n"
                      "a driver's where one is outside of its legal interval. Methods are measured on the snapped corners.\n", kLostUlp);
  for (const std::string& driver : results.drivers) fmt::format_to(out, "driver    {}\n", driver);
  fmt::format_to(out, "time      {}\n", secondsText(results.wallSeconds));
  return text;
}

std::string stabilityCsv(const Results& results) {
  std::string text = "family,dial,method,measure,cases,wrong,maxUlp,notFinite\n";
  for (const Series& series : results.series) {
    for (const Point& p : series.points) {
      if (!p.offered) continue;
      fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{},{},{}\n", series.family, p.dial, series.method,
                     series.values ? "values" : "coverage", p.cases, p.wrong, p.maxUlp, p.notFinite);
    }
  }
  return text;
}

}  // namespace rasterdiff::harness
