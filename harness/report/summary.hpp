// A run's result for the terminal.
#pragma once

#include <string>

#include "harness/report/report.hpp"

namespace rasterdiff::harness {

/// Driver, rules, table of families, freedoms, rule coverage, values, first differences with the command that explains
/// each, what was skipped, times, and the verdict as the last line.
[[nodiscard]] std::string summaryText(const Report& report);

}  // namespace rasterdiff::harness
