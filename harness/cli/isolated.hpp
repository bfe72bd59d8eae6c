// One piece of work that touches the driver, in a process of its own.
#pragma once

#include <functional>
#include <string>

#include "scene/result.hpp"

namespace rasterdiff::harness::cli {

/// Runs `work` in a child process and returns what it returned. Error: the work's own, DeviceLost if the child died,
/// TimedOut if it took longer than `seconds`.
[[nodiscard]] Result<std::string> isolated(double seconds, const std::function<Result<std::string>()>& work);

/// How long a driver may stay silent before it counts as hung: two submits' time and a little.
[[nodiscard]] double watchdogSeconds(double timeoutSeconds);

}  // namespace rasterdiff::harness::cli
