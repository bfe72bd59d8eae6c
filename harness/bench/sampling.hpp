// What it costs to know how much of a pixel is covered: n × n samples, the standard patterns, and exact area.
#pragma once

#include "harness/bench/measure.hpp"

namespace rasterdiff::harness::bench {

/// Errors over the partly covered pixels of triangles of 8 to 40 pixels (as in docs/methods.md), time of one pixel. The
/// method "exact-area" is what the others are held against.
[[nodiscard]] std::vector<SamplingRow> measureSampling(const Settings& settings, const Progress& progress);

}  // namespace rasterdiff::harness::bench
