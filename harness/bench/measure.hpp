// One load, one task: verify everyone, find out how much each can draw in the time it has, then draw in interleaved rounds.
#pragma once

#include "harness/bench/contender.hpp"

namespace rasterdiff::harness::bench {

/// What is being done, for people who wait.
using Progress = std::function<void(const std::string&)>;

/// Rows of all chosen contenders; `driverLine` becomes what the driver says of itself. A contender that cannot draw the
/// load, that crashed, or that is wrong where it promised to be exact has a row that says so.
/// Error: NoDevice; what the reference cannot draw.
[[nodiscard]] Result<std::vector<Row>> measure(const Load& load, Task task, const Settings& settings, std::string& driverLine,
                                               const Progress& progress);

/// A load with the rows of all `tasks` that it stands for.
[[nodiscard]] Result<LoadResult> measureAll(const Load& load, const std::vector<Task>& tasks, const Settings& settings,
                                            std::string& driverLine, const Progress& progress);

}  // namespace rasterdiff::harness::bench
