// Small plots as SVG text, readable on a light and on a dark page: points on logarithmic axes with the Pareto line, and
// lines over a logarithmic variable. What is plotted is the caller's business.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace rasterdiff::harness {

inline constexpr int kPlotWidth = 440, kPlotHeight = 400;  ///< user units of one plot

/// Colour and shape of a point.
enum class Mark : uint8_t { Exact, Inexact, Driver, Reference };

struct PlotPoint {
  double x = 0, y = 0;  ///< x = 0 has a column of its own; y > 0
  std::string label;
  Mark mark = Mark::Inexact;
};

struct ScatterPlot {
  std::string title, subtitle, xName, yName;
  std::vector<PlotPoint> points;
};

/// Which points no other one beats in both: smaller x and larger y, in the order of x.
[[nodiscard]] std::vector<size_t> paretoOrder(std::span<const PlotPoint> points);

/// An <svg> element with the class "plot".
[[nodiscard]] std::string svgOf(const ScatterPlot& plot);

struct LinePlot {
  std::string title, subtitle, xName, yName;
  struct Line {
    std::string label;
    std::vector<std::pair<double, double>> points;  ///< x > 0, y > 0
  };
  std::vector<Line> lines;
};
[[nodiscard]] std::string svgOf(const LinePlot& plot);

/// The style that the plots rely on, as text of a <style> element.
[[nodiscard]] std::string plotStyle();

/// Plots side by side in one stand-alone SVG file.
[[nodiscard]] std::string svgSheet(const std::string& title, const std::string& subtitle, std::span<const std::string> plots);

}  // namespace rasterdiff::harness
