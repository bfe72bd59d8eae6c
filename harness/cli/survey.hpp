// One pass of a driver over scenes, judged against the known differences: what `list --rules` shows, and `check` with several drivers.
#pragma once

#include "harness/cli/options.hpp"
#include "harness/cli/progress.hpp"
#include "harness/cli/selection.hpp"
#include "harness/report/rule_survey.hpp"

namespace rasterdiff::harness::cli {

/// Draws every job in worker processes. A driver that cannot be opened has a refusal; one that crashes or hangs has that verdict
/// in the scene. Batches of a random family are an entry each.
[[nodiscard]] DriverPass passOver(const std::vector<Job>& jobs, const DriverChoice& choice, unsigned workers, Progress& progress);

/// The same, judged by the specification, by a worker a core.
[[nodiscard]] DriverPass passOver(const std::vector<Job>& jobs, const std::string& driver);

}  // namespace rasterdiff::harness::cli
