// What `stability` prints and writes: tables for people, JSON and CSV for programs, plots.
#pragma once

#include <string>
#include <vector>

#include "harness/stability/results.hpp"

namespace rasterdiff::harness {

/// "1", "256", "10k", "1e12": a value of a dial.
[[nodiscard]] std::string dialText(double dial);
/// One cell of a table: wrong samples, or the largest error in ULPs ("n/f": not finite; "!": broken; "-": the driver does not draw it).
[[nodiscard]] std::string cellText(const stability::Series& series, const stability::Point& point);
/// "never", or the value of the dial.
[[nodiscard]] std::string breakText(const stability::Series& series);

/// A table a family, then where each method and driver breaks.
[[nodiscard]] std::string stabilityText(const stability::Results& results);
[[nodiscard]] std::string stabilityJson(const stability::Results& results);
[[nodiscard]] std::string stabilityCsv(const stability::Results& results);
/// One plot a family of values, and of coverage where some method is wrong, in one stand-alone SVG file.
[[nodiscard]] std::string stabilitySvg(const stability::Results& results);
[[nodiscard]] std::string stabilityHtml(const stability::Results& results);

/// <svg> elements: error over the dial, both logarithmic. Samples that are right, and values without error, are left out.
[[nodiscard]] std::vector<std::string> stabilityPlots(const stability::Results& results, const stability::Family& family);

}  // namespace rasterdiff::harness
