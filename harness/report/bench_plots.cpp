#include "harness/report/bench_plots.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "harness/bench/machine.hpp"
#include "harness/report/bench_text.hpp"
#include "harness/report/numbers.hpp"
#include "harness/report/plot.hpp"

namespace rasterdiff::harness {
namespace {

using namespace bench;

Mark markOf(const Row& row) {
  if (row.method.starts_with("driver")) return Mark::Driver;
  if (row.method == "render") return Mark::Reference;
  return row.exact ? Mark::Exact : Mark::Inexact;
}

/// The method's name, with what tells it from others of that name.
std::string labelOf(const Row& row, const std::vector<Row>& rows) {
  const auto alike = std::ranges::count_if(rows, [&](const Row& other) { return other.method == row.method && other.task == row.task; });
  std::string label = row.method;
  if (alike > 1 && !row.target.empty()) label += " " + row.target;
  if (row.threads > 1) label += fmt::format(" x{}", row.threads);
  return label;
}

/// Wrong samples in a million where there are no values, else the largest error in ULPs (half an ULP is what rounding costs).
double errorOf(const Row& row) {
  const ErrorCount& error = *row.error;
  if (error.values > 0) return error.maxUlp;
  return error.covered == 0 ? 0 : 1e6 * static_cast<double>(error.wrong) / static_cast<double>(error.covered);
}

}  // namespace

std::vector<std::string> loadPlots(const Results& results) {
  std::vector<std::string> plots;
  for (const LoadResult& load : results.loads) {
    for (const Task task : {Task::Coverage, Task::Depth, Task::Varyings}) {
      ScatterPlot plot;
      plot.title = fmt::format("{}: {}", load.name, toString(task));
      plot.subtitle = fmt::format("{} {}; {} x {}, {}", grouped(load.triangles), load.what, load.width, load.height, counted(load.samples, "sample"));
      bool values = false;
      for (const Row& row : load.rows) {
        if (row.task != task || !row.timing || !row.error) continue;
        values = values || row.error->values > 0;
        plot.points.push_back({errorOf(row), trianglesPerSecond(row), labelOf(row, load.rows), markOf(row)});
      }
      plot.xName = values ? "largest error, ULP →" : "wrong samples in a million →";
      plot.yName = "triangles/s";
      if (plot.points.size() > 1) plots.push_back(svgOf(plot));
    }
  }
  return plots;
}

std::vector<std::string> samplingPlots(const Results& results) {
  if (results.sampling.empty()) return {};
  ScatterPlot plot;
  plot.title = "Area of a pixel by n × n samples";
  plot.subtitle = "partly covered pixels, against exact area";
  plot.xName = "RMS error, parts of a pixel →";
  plot.yName = "pixels/s";
  for (const SamplingRow& row : results.sampling)
    plot.points.push_back({row.rmsError, 1 / row.timing.median, row.method, row.samples == 0 ? Mark::Exact : Mark::Inexact});
  return {svgOf(plot)};
}

std::vector<std::string> scalingPlots(const Results& results) {
  std::vector<std::string> plots;
  for (const ScalingSeries& series : results.scaling) {
    LinePlot plot;
    plot.title = "Scaling with " + series.name;
    plot.subtitle = series.expected;
    plot.xName = series.variable + " →";
    plot.yName = series.perSample ? "ps a sample" : "ns a triangle";
    std::map<std::string, size_t> lines;
    for (const ScalingSeries::Point& point : series.points) {
      if (!point.row.timing) continue;
      const auto [at, isNew] = lines.try_emplace(point.row.method, plot.lines.size());
      if (isNew) plot.lines.push_back({point.row.method, {}});
      const double cost = series.perSample ? 1e12 / samplesPerSecond(point.row) : 1e9 / trianglesPerSecond(point.row);
      plot.lines[at->second].points.emplace_back(point.x, cost);
    }
    plots.push_back(svgOf(plot));
  }
  return plots;
}

std::string benchSvg(const Results& results) {
  std::vector<std::string> plots = loadPlots(results);
  for (const auto& more : {samplingPlots(results), scalingPlots(results)}) plots.insert(plots.end(), more.begin(), more.end());
  return svgSheet("rasterdiff bench: speed against error", machineLine(results.machine), plots);
}

}  // namespace rasterdiff::harness
