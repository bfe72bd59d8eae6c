// One pass of a driver over scenes of the catalogue, judged against the known differences: what `list --rules` shows.
#pragma once

#include "harness/cli/selection.hpp"
#include "harness/report/rule_survey.hpp"

namespace rasterdiff::harness::cli {

/// Draws every job with `driver`, judged by the specification, in worker processes, with progress on stderr. A driver that cannot be opened has a
/// refusal; one that crashes or hangs has that verdict in the scene.
[[nodiscard]] DriverPass passOver(const std::vector<Job>& jobs, const std::string& driver);

}  // namespace rasterdiff::harness::cli
