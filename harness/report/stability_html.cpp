#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "harness/report/markup.hpp"
#include "harness/report/numbers.hpp"
#include "harness/report/plot.hpp"
#include "harness/report/stability_text.hpp"
#include "report_css.hpp"

namespace rasterdiff::harness {
namespace {

using namespace stability;

constexpr const char* kMoreStyle = R"(
.plots { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 440px), 1fr)); gap: 14px; margin: 12px 0; }
.plots > svg { display: block; width: 100%; height: auto; background: var(--card); border: 1px solid var(--line); border-radius: 10px; }
td.left, th.left { text-align: left; }
)";

LinePlot plotOf(const Results& results, const Family& family, bool values) {
  LinePlot plot;
  plot.title = fmt::format("{}: {}", family.name, values ? "values" : "coverage");
  plot.subtitle = family.what;
  plot.xName = family.dial + " →";
  plot.yName = values ? "largest error, ULP" : "wrong samples";
  for (const Series* series : seriesOf(results, family.name, values)) {
    LinePlot::Line line{series->method, {}};
    for (const Point& point : series->points) {
      const double error = values ? point.maxUlp : static_cast<double>(point.wrong);
      if (error > 0 && std::isfinite(error)) line.points.emplace_back(point.dial, error);
    }
    if (!line.points.empty()) plot.lines.push_back(std::move(line));
  }
  return plot;
}

void writeTable(std::string& text, const Results& results, const Family& family, bool values) {
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "<div class=\"scroll\"><table><thead><tr><th class=\"left\">{}</th>", values ? "largest error, ULP" : "wrong samples");
  for (const double dial : family.values) fmt::format_to(out, "<th>{}</th>", dialText(dial));
  fmt::format_to(out, "<th>breaks at</th></tr></thead><tbody>\n");
  for (const Series* series : seriesOf(results, family.name, values)) {
    fmt::format_to(out, "<tr><td class=\"left\">{}</td>", escaped(series->method));
    for (const Point& point : series->points) {
      fmt::format_to(out, "<td{}>{}</td>", isBroken(*series, point) ? " class=\"bad\"" : "", cellText(*series, point));
    }
    fmt::format_to(out, "<td>{}</td></tr>\n", breakText(*series));
  }
  text += "</tbody></table></div>\n";
}

}  // namespace

std::vector<std::string> stabilityPlots(const Results& results, const Family& family) {
  std::vector<std::string> plots;
  for (const bool values : {false, true}) {
    const LinePlot plot = plotOf(results, family, values);
    if (!plot.lines.empty()) plots.push_back(svgOf(plot));
  }
  return plots;
}

std::string stabilitySvg(const Results& results) {
  std::vector<std::string> plots;
  for (const Family& family : results.families) {
    for (std::string& plot : stabilityPlots(results, family)) plots.push_back(std::move(plot));
  }
  return svgSheet("rasterdiff stability: error as a function of the dial", "", plots);
}

std::string stabilityHtml(const Results& results) {
  std::string text;
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
                      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">"
                      "<title>rasterdiff stability</title><link rel=\"icon\" href=\"data:,\"><style>\n{}{}{}</style></head><body><main>\n"
                      "<header><h1>rasterdiff stability</h1><div class=\"driver\">",
                 kReportCss, kMoreStyle, plotStyle());
  for (const std::string& driver : results.drivers) fmt::format_to(out, "<b>{}</b><br>", escaped(driver));
  fmt::format_to(out, "</div></header>\n<p class=\"soft\">Each family is one scene that gets harder from left to right. A method's values break "
                      "where more than {:.0f} ULP (half of 24 bits) are lost or one is not finite; a driver's where one is outside of its legal "
                      "interval. What has no error is not plotted.</p>\n", kLostUlp);
  for (const Family& family : results.families) {
    fmt::format_to(out, "<h2>{}<small>{}; dial: {}</small></h2>\n<div class=\"plots\">", escaped(family.name), escaped(family.what), escaped(family.dial));
    for (const std::string& plot : stabilityPlots(results, family)) text += plot;
    text += "</div>\n";
    writeTable(text, results, family, false);
    writeTable(text, results, family, true);
  }
  fmt::format_to(out, "<footer>{}</footer>\n</main></body></html>\n", secondsText(results.wallSeconds));
  return text;
}

}  // namespace rasterdiff::harness
