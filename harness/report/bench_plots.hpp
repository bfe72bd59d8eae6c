// Which plots a measurement of speed against error is shown in; plot.hpp draws them.
#pragma once

#include <string>
#include <vector>

#include "harness/bench/results.hpp"

namespace rasterdiff::harness {

/// Speed against error, one plot a load and task with at least two timed rows.
[[nodiscard]] std::vector<std::string> loadPlots(const bench::Results& results);
/// Cost against error of the ways to sample a pixel; none where they were not measured.
[[nodiscard]] std::vector<std::string> samplingPlots(const bench::Results& results);
/// One plot a series.
[[nodiscard]] std::vector<std::string> scalingPlots(const bench::Results& results);

/// All of them in one stand-alone SVG file.
[[nodiscard]] std::string benchSvg(const bench::Results& results);

}  // namespace rasterdiff::harness
