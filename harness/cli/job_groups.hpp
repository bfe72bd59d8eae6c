// Which jobs a worker gains from doing one after the other: those for which a driver compiles the same pipelines.
#pragma once

#include <string>

#include "harness/cli/selection.hpp"
#include "vkref/pipeline_groups.hpp"

namespace rasterdiff::harness::cli {

class JobGroups {
 public:
  /// The name of the job's group. Makes scenes, except meshes and batches of random primitives: those take too long, and
  /// are grouped by their entry.
  [[nodiscard]] std::string of(const Job& job);

 private:
  vkref::PipelineGroups pipelines_;
};

}  // namespace rasterdiff::harness::cli
