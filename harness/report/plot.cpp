#include "harness/report/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <numeric>

#include "harness/report/markup.hpp"
#include "harness/report/plot_axes.hpp"

namespace rasterdiff::harness {
namespace {

using Out = std::back_insert_iterator<std::string>;

constexpr double kLeft = 50, kRight = kPlotWidth - 12, kTop = 46, kBottom = kPlotHeight - 42;
constexpr double kZeroWidth = 128;  // of the column for x = 0

constexpr const char* kStyle = R"(.plot, .sheet { --p-ink: #1b1d22; --p-soft: #666b76; --p-grid: #e2e2dc; --p-exact: #2c7a57; --p-inexact: #a36a00;
  --p-driver: #c81e33; --p-reference: #6a3fb0; --p-line: #7cc4a0; --p-card: #ffffff; font: 11px ui-monospace, "DejaVu Sans Mono", Menlo, Consolas, monospace; }
@media (prefers-color-scheme: dark) { .plot, .sheet { --p-ink: #e9eaee; --p-soft: #9aa1ae; --p-grid: #2d313a; --p-exact: #68c79a; --p-inexact: #f0bd3a;
  --p-driver: #ff6b7a; --p-reference: #b79bff; --p-line: #3f8f6a; --p-card: #1c1f25; } }
.plot text { fill: var(--p-ink); stroke: var(--p-card); stroke-width: 3; paint-order: stroke; } .plot .soft { fill: var(--p-soft); } .plot .title { font-size: 14px; font-weight: 700; }
.plot .grid { stroke: var(--p-grid); stroke-width: 1; } .plot .lead { stroke: var(--p-soft); stroke-width: 0.7; }
.plot .pareto { fill: none; stroke: var(--p-line); stroke-width: 2; stroke-linejoin: round; }
.plot .Exact { fill: var(--p-exact); } .plot .Inexact { fill: var(--p-inexact); }
.plot .Driver { fill: var(--p-driver); } .plot .Reference { fill: var(--p-reference); }
.plot .line { fill: none; stroke-width: 2; } .plot .l0 { stroke: var(--p-exact); } .plot .l1 { stroke: var(--p-driver); }
.plot .l2 { stroke: var(--p-inexact); } .plot .l3 { stroke: var(--p-reference); }
.plot .l1 { stroke-dasharray: 6 3; } .plot .l2 { stroke-dasharray: 2 3; } .plot .l3 { stroke-dasharray: 8 3 2 3; }
)";

constexpr const char* kMarks[] = {"Exact", "Inexact", "Driver", "Reference"};

void writeMark(Out out, double x, double y, Mark mark) {
  const char* name = kMarks[static_cast<size_t>(mark)];
  switch (mark) {
    case Mark::Exact: fmt::format_to(out, "<circle class=\"{}\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"4\"/>", name, x, y); return;
    case Mark::Inexact:
      fmt::format_to(out, "<path class=\"{}\" d=\"M{:.1f} {:.1f}l4.5 4.5l-4.5 4.5l-4.5 -4.5z\"/>", name, x, y - 4.5);
      return;
    case Mark::Driver:
      fmt::format_to(out, "<rect class=\"{}\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"8\" height=\"8\"/>", name, x - 4, y - 4);
      return;
    case Mark::Reference:
      fmt::format_to(out, "<path class=\"{}\" d=\"M{:.1f} {:.1f}l5 9h-10z\"/>", name, x, y - 5.5);
      return;
  }
}

template <class Plot>
void writeFrame(Out out, const Plot& plot) {
  fmt::format_to(out, "<svg class=\"plot\" xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{}\">\n",
                 kPlotWidth, kPlotHeight, escaped(plot.title));
  fmt::format_to(out, "<text class=\"title\" x=\"10\" y=\"16\">{}</text><text class=\"soft\" x=\"10\" y=\"31\">{}</text>\n",
                 escaped(plot.title), escaped(plot.subtitle));
  fmt::format_to(out, "<text class=\"soft\" x=\"{}\" y=\"{}\" text-anchor=\"end\">{}</text>", kRight, kPlotHeight - 8, escaped(plot.xName));
  fmt::format_to(out, "<text class=\"soft\" x=\"10\" y=\"{}\">↑ {}</text>\n", kPlotHeight - 8, escaped(plot.yName));
}

void writeTicksY(Out out, const LogAxis& axis) {
  for (const double value : axis.ticks())
    fmt::format_to(out, "<path class=\"grid\" d=\"M{0} {1:.1f}H{2}\"/><text class=\"soft\" x=\"{3}\" y=\"{4:.1f}\" text-anchor=\"end\">{5}</text>\n",
                   kLeft, axis.at(value), kRight, kLeft - 6, axis.at(value) + 4, tickText(value));
}

void writeTickX(Out out, double x, const std::string& text) {
  fmt::format_to(out, "<path class=\"grid\" d=\"M{0:.1f} {1}V{2}\"/><text class=\"soft\" x=\"{0:.1f}\" y=\"{3}\" text-anchor=\"middle\">{4}</text>\n",
                 x, kTop, kBottom, kBottom + 15, text);
}

/// Labels of the column for x = 0: in the order of their points, so that the lines to them do not cross.
void writeZeroLabels(Out out, const ScatterPlot& plot, double x, const LogAxis& axis, LabelPlacer& labels) {
  constexpr double kGap = 18, kSpacing = 12.5;
  std::vector<const PlotPoint*> points;
  for (const PlotPoint& point : plot.points)
    if (!(point.x > 0)) points.push_back(&point);
  std::ranges::sort(points, [](const PlotPoint* a, const PlotPoint* b) { return a->y > b->y; });
  std::vector<double> wanted;
  for (const PlotPoint* point : points) wanted.push_back(axis.at(point->y));
  const std::vector<double> heights = spread(wanted, kSpacing, kTop, kBottom - 6);
  for (size_t i = 0; i < points.size(); ++i) {
    fmt::format_to(out, "<path class=\"lead\" d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\"/><text x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n", x, wanted[i],
                   x + kGap - 2, heights[i], x + kGap, heights[i] + 4, escaped(points[i]->label));
    labels.avoid(x + kGap, heights[i], points[i]->label);
  }
}

}  // namespace

std::vector<size_t> paretoOrder(std::span<const PlotPoint> points) {
  std::vector<size_t> order(points.size()), best;
  std::iota(order.begin(), order.end(), size_t{0});
  std::ranges::sort(order, [&](size_t a, size_t b) {
    return points[a].x != points[b].x ? points[a].x < points[b].x : points[a].y > points[b].y;
  });
  for (const size_t i : order)
    if (best.empty() || points[i].y > points[best.back()].y) best.push_back(i);
  return best;
}

std::string svgOf(const ScatterPlot& plot) {
  std::string text;
  const auto out = std::back_inserter(text);
  std::vector<double> errors, speeds;
  for (const PlotPoint& point : plot.points) {
    speeds.push_back(point.y);
    if (point.x > 0) errors.push_back(point.x);
  }
  const double zero = kLeft + 14;
  const LogAxis x(errors, kLeft + kZeroWidth, kRight - 40), y(speeds, kBottom, kTop);
  const auto xAt = [&](const PlotPoint& point) { return point.x > 0 ? x.at(point.x) : zero; };
  writeFrame(out, plot);
  writeTicksY(out, y);
  writeTickX(out, zero, "0");
  if (!errors.empty())
    for (const double tick : x.ticks()) writeTickX(out, x.at(tick), tickText(tick));

  const std::vector<size_t> pareto = paretoOrder(plot.points);
  fmt::format_to(out, "<path class=\"pareto\" d=\"");  // a staircase: below it everything is beaten
  for (size_t i = 0; i < pareto.size(); ++i)
    fmt::format_to(out, "{}{:.1f}{}{:.1f}", i == 0 ? "M" : "H", xAt(plot.points[pareto[i]]), i == 0 ? " " : "V", y.at(plot.points[pareto[i]].y));
  fmt::format_to(out, "H{}\"/>\n", kRight);

  LabelPlacer labels(kLeft, kTop - 6, kPlotWidth - 2, kBottom);
  for (const PlotPoint& point : plot.points) labels.avoid(xAt(point), y.at(point.y));
  writeZeroLabels(out, plot, zero, y, labels);
  for (const PlotPoint& point : plot.points) {
    const double px = xAt(point), py = y.at(point.y);
    if (point.x > 0) {
      const LabelPlacer::Place place = labels.place(px, py, point.label);
      if (place.moved)
        fmt::format_to(out, "<path class=\"lead\" d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\"/>", px, py, place.x + (place.toLeft ? 2 : -2), place.y - 4);
      fmt::format_to(out, "<text x=\"{:.1f}\" y=\"{:.1f}\"{}>{}</text>\n", place.x, place.y, place.toLeft ? " text-anchor=\"end\"" : "",
                     escaped(point.label));
    }
    writeMark(out, px, py, point.mark);
  }
  return text + "</svg>\n";
}

std::string svgOf(const LinePlot& plot) {
  std::string text;
  const auto out = std::back_inserter(text);
  std::vector<double> xs, ys;
  for (const LinePlot::Line& line : plot.lines)
    for (const auto& [px, py] : line.points) xs.push_back(px), ys.push_back(py);
  const LogAxis x(xs, kLeft + 6, kRight - 20), y(ys, kBottom, kTop);
  writeFrame(out, plot);
  writeTicksY(out, y);
  for (const double tick : x.ticks()) writeTickX(out, x.at(tick), tickText(tick));
  LabelPlacer labels(kLeft, kTop - 6, kPlotWidth - 2, kBottom);
  for (size_t i = 0; i < plot.lines.size(); ++i) {
    const LinePlot::Line& line = plot.lines[i];
    if (line.points.empty()) continue;
    fmt::format_to(out, "<path class=\"line l{}\" d=\"", i % 4);
    for (size_t k = 0; k < line.points.size(); ++k)
      fmt::format_to(out, "{}{:.1f} {:.1f}", k == 0 ? "M" : "L", x.at(line.points[k].first), y.at(line.points[k].second));
    fmt::format_to(out, "\"/>");
    const auto& [px, py] = line.points[line.points.size() / 2];
    const LabelPlacer::Place place = labels.place(x.at(px), y.at(py) - 12, line.label);
    fmt::format_to(out, "<text x=\"{:.1f}\" y=\"{:.1f}\"{}>{}</text>\n", place.x, place.y, place.toLeft ? " text-anchor=\"end\"" : "",
                   escaped(line.label));
  }
  return text + "</svg>\n";
}

std::string plotStyle() { return kStyle; }

std::string svgSheet(const std::string& title, const std::string& subtitle, std::span<const std::string> plots) {
  constexpr size_t kColumns = 2;
  constexpr int kGap = 16, kHead = 56;
  const auto rows = static_cast<int>((plots.size() + kColumns - 1) / kColumns);
  const int width = 2 * kPlotWidth + 3 * kGap, height = kHead + rows * (kPlotHeight + kGap);
  std::string text;
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "<svg class=\"sheet\" xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\">\n<style>\n", width, height);
  fmt::format_to(out, ".sheet .paper {{ fill: #f6f6f3; }} .sheet .card {{ fill: #ffffff; }}\n@media (prefers-color-scheme: dark) "
                      "{{ .sheet .paper {{ fill: #14161a; }} .sheet .card {{ fill: #1c1f25; }} }}\n"
                      ".sheet > text {{ fill: var(--p-ink); font-size: 12px; }} .sheet > .head {{ font-size: 18px; font-weight: 700; }}\n{}</style>\n",
                 kStyle);
  fmt::format_to(out, "<rect class=\"paper\" width=\"{}\" height=\"{}\"/><text class=\"head\" x=\"{}\" y=\"26\">{}</text><text x=\"{}\" y=\"45\">{}</text>\n",
                 width, height, kGap, escaped(title), kGap, escaped(subtitle));
  for (size_t i = 0; i < plots.size(); ++i) {
    const int x = kGap + static_cast<int>(i % kColumns) * (kPlotWidth + kGap), y = kHead + static_cast<int>(i / kColumns) * (kPlotHeight + kGap);
    fmt::format_to(out, "<rect class=\"card\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" rx=\"10\"/>\n", x, y, kPlotWidth, kPlotHeight);
    // A plot is as large as what it is in: without a size that would be the sheet.
    fmt::format_to(out, "<svg x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\">{}</svg>\n", x, y, kPlotWidth, kPlotHeight, plots[i]);
  }
  return text + "</svg>\n";
}

}  // namespace rasterdiff::harness
