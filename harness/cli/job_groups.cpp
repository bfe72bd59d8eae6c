#include "harness/cli/job_groups.hpp"

#include <fmt/format.h>

namespace rasterdiff::harness::cli {

std::string JobGroups::of(const Job& job) {
  const bool slow = job.id.starts_with("mesh/") || job.address != job.id;
  if (slow || job.invariant != nullptr) return job.id;
  const Result<Scene> scene = job.make();
  if (!scene || !validate(*scene)) return job.id;
  return fmt::format("{}", pipelines_.of(*scene));
}

}  // namespace rasterdiff::harness::cli
