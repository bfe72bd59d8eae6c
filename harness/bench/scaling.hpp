// How costs grow: triangle size, triangle count, target size, samples and threads, one changed at a time.
#pragma once

#include "harness/bench/measure.hpp"

namespace rasterdiff::harness::bench {

/// Random triangles, coverage. Only rows that used the number of threads in question are kept. Errors as of measure.
[[nodiscard]] Result<std::vector<ScalingSeries>> measureScaling(const Settings& settings, std::string& driverLine,
                                                                const Progress& progress);

}  // namespace rasterdiff::harness::bench
