// From the words of `bench` to loads: workloads by name in every size and sample count that is asked, or scenes.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "harness/bench/load.hpp"
#include "harness/cli/options.hpp"

namespace rasterdiff::harness::cli {

/// Made when its turn comes: a million triangles need not wait in memory.
struct BenchLoad {
  std::string name;
  std::function<Result<bench::Load>()> make;
};

/// Error: BadInput for an unknown workload, size or sample count; as selectScenes for scenes.
[[nodiscard]] Result<std::vector<BenchLoad>> benchLoads(const BenchOptions& options);

/// `--tasks`. Error: BadInput.
[[nodiscard]] Result<std::vector<bench::Task>> benchTasks(const BenchOptions& options);

}  // namespace rasterdiff::harness::cli
