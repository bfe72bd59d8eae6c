#include "harness/report/bench_html.hpp"

#include <fmt/format.h>

#include <iterator>

#include "harness/bench/machine.hpp"
#include "harness/report/bench_plots.hpp"
#include "harness/report/bench_text.hpp"
#include "harness/report/markup.hpp"
#include "harness/report/numbers.hpp"
#include "harness/report/plot.hpp"
#include "report_css.hpp"

namespace rasterdiff::harness {
namespace {

using namespace bench;
using Out = std::back_insert_iterator<std::string>;

constexpr const char* kMoreStyle = R"(
.plots { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 440px), 1fr)); gap: 14px; margin: 12px 0; }
.plots > svg { display: block; width: 100%; height: auto; background: var(--card); border: 1px solid var(--line); border-radius: 10px; }
td.left, th.left { text-align: left; }
)";

std::string deviation(const Timing& timing) { return fmt::format("±{:.1f} %", 100 * timing.deviation); }

void writePlots(Out out, const std::vector<std::string>& plots) {
  if (plots.empty()) return;
  fmt::format_to(out, "<div class=\"plots\">\n");
  for (const std::string& plot : plots) fmt::format_to(out, "{}", plot);
  fmt::format_to(out, "</div>\n");
}

void writeRow(Out out, const Row& row, const LoadResult& load) {
  const std::string threads = row.threads > 1 ? fmt::format(", {} threads", row.threads) : "";
  fmt::format_to(out, "<tr><td title=\"{}\">{}{}</td>", escaped(row.what), escaped(row.method), threads);
  if (!row.timing) {
    fmt::format_to(out, "<td class=\"left bad\" colspan=\"7\">not timed: {}</td></tr>\n", escaped(row.refused));
    return;
  }
  const bool wrong = row.error && row.error->wrong > 0;
  fmt::format_to(out, "<td>{}</td><td>{}</td><td class=\"zero\">{}</td><td class=\"left{}\">{}</td><td>{}</td><td>{}</td><td class=\"left\">{}</td></tr>\n",
                 threeDigits(trianglesPerSecond(row)), threeDigits(samplesPerSecond(row)), deviation(*row.timing),
                 wrong ? " bad" : "", errorText(row), row.triangles < load.triangles ? grouped(row.triangles) : "all",
                 row.peakBytes ? threeDigits(static_cast<double>(*row.peakBytes)) + "B" : "", escaped(row.target));
}

void writeLoad(Out out, const LoadResult& load) {
  fmt::format_to(out, "<h2>{}<small>{} {}; {} × {} pixels, {}</small></h2>\n", escaped(load.name), grouped(load.triangles), escaped(load.what),
                 load.width, load.height, counted(load.samples, "sample"));
  if (!load.note.empty()) fmt::format_to(out, "<p class=\"soft\">{}</p>\n", escaped(load.note));
  fmt::format_to(out, "<div class=\"scroll\"><table><thead>");
  const Row* previous = nullptr;
  for (const Row& row : load.rows) {
    if (previous == nullptr || previous->task != row.task)
      fmt::format_to(out, "<tr><th>{}</th><th>triangles/s</th><th>samples/s</th><th></th><th class=\"left\">error</th><th>timed</th><th>memory</th>"
                          "<th class=\"left\">target</th></tr>{}\n", toString(row.task), previous == nullptr ? "</thead><tbody>" : "");
    writeRow(out, row, load);
    previous = &row;
  }
  fmt::format_to(out, "{}</table></div>\n", previous == nullptr ? "</thead>" : "</tbody>");
}

void writeSampling(Out out, const Results& results) {
  if (results.sampling.empty()) return;
  fmt::format_to(out, "<h2>Sampling a pixel<small>error against exact area</small></h2>\n");
  writePlots(out, samplingPlots(results));
  fmt::format_to(out, "<div class=\"scroll\"><table><thead><tr><th>method</th><th>ns a pixel</th><th></th><th>largest error</th><th>RMS error</th>"
                      "<th>wrong in 8 bits</th><th>pixels</th></tr></thead><tbody>\n");
  for (const SamplingRow& row : results.sampling)
    fmt::format_to(out, "<tr><td>{}</td><td>{:.3g}</td><td class=\"zero\">{}</td><td>{:.3g}</td><td>{:.3g}</td><td>{:.3g} %</td><td>{}</td></tr>\n",
                   escaped(row.method), 1e9 * row.timing.median, deviation(row.timing), row.maxError, row.rmsError,
                   row.pixels == 0 ? 0 : 100 * static_cast<double>(row.wrong) / static_cast<double>(row.pixels), grouped(row.pixels));
  fmt::format_to(out, "</tbody></table></div>\n");
}

void writeScaling(Out out, const Results& results) {
  if (results.scaling.empty()) return;
  fmt::format_to(out, "<h2>Scaling<small>one thing changed at a time</small></h2>\n");
  writePlots(out, scalingPlots(results));
  fmt::format_to(out, "<div class=\"scroll\"><table><thead><tr><th>changed</th><th></th><th class=\"left\">method</th><th>ns a triangle</th>"
                      "<th>ns a sample</th><th></th></tr></thead><tbody>\n");
  for (const ScalingSeries& series : results.scaling) {
    for (const ScalingSeries::Point& point : series.points) {
      if (!point.row.timing) continue;
      fmt::format_to(out, "<tr><td>{}</td><td>{:.0f}</td><td class=\"left\">{}</td><td>{:.4g}</td><td>{:.4g}</td><td class=\"zero\">{}</td></tr>\n",
                     escaped(series.name), point.x, escaped(point.row.method), 1e9 / trianglesPerSecond(point.row),
                     1e9 / samplesPerSecond(point.row), deviation(*point.row.timing));
    }
  }
  fmt::format_to(out, "</tbody></table></div>\n");
}

}  // namespace

std::string benchHtml(const Results& results) {
  std::string text;
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
                      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">"
                      "<title>rasterdiff bench</title><link rel=\"icon\" href=\"data:,\"><style>\n{}{}{}</style></head><body><main>\n",
                 kReportCss, kMoreStyle, plotStyle());
  fmt::format_to(out, "<header><h1>rasterdiff bench</h1><div class=\"driver\"><b>{}</b><br><span class=\"soft\">{}</span></div></header>\n",
                 escaped(machineLine(results.machine)), escaped(results.driver.empty() ? "no driver" : results.driver));
  fmt::format_to(out, "<p class=\"soft\">Medians of {} interleaved rounds ± median absolute deviation. Everything is verified before it is timed. Up is "
                      "faster, left is more exact; the line joins what no other method beats in both. Circles promise to be exact, diamonds do not, "
                      "the square is the driver, the triangle the reference as <code>check</code> runs it.</p>\n", results.rounds);
  writePlots(out, loadPlots(results));
  for (const LoadResult& load : results.loads) writeLoad(out, load);
  writeSampling(out, results);
  writeScaling(out, results);
  fmt::format_to(out, "<footer>{}</footer>\n</main></body></html>\n", secondsText(results.wallSeconds));
  return text;
}

}  // namespace rasterdiff::harness
