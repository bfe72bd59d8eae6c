// `check` with several drivers at once: a pass of each over the same scenes.
#pragma once

#include "harness/cli/selection.hpp"
#include "harness/cli/options.hpp"

namespace rasterdiff::harness::cli {

/// Draws every job with every driver that `options.choice.driver` names, prints a table and a summary, and writes --json.
/// Returns the exit status; a complaint where an option is about one driver only.
[[nodiscard]] int checkSeveral(const CheckOptions& options, const std::vector<Job>& jobs);

}  // namespace rasterdiff::harness::cli
