// The life of a worker process that checks scenes on a driver, and what the parent has to know to run such workers.
#pragma once

#include <functional>
#include <vector>

#include "harness/cli/options.hpp"
#include "harness/cli/pool.hpp"
#include "harness/cli/scene_check.hpp"

namespace rasterdiff::harness::cli {

/// What a job adds to the settings of all (`pictures`).
using JobSettings = std::function<CheckSettings(uint32_t job)>;

/// Opens the driver once, sends a subject record (readSubjectRecord), then a scene record (readSceneRecord) for each job.
void checkScenes(WorkerLink& link, const DriverChoice& choice, const std::vector<Job>& jobs, const JobSettings& settings);

/// The entry of a job whose worker died of it.
[[nodiscard]] SceneEntry entryOfDeath(const Job& job, const Death& death);

/// Workers for --jobs 0: one a core that this process may use.
[[nodiscard]] unsigned coresToUse();

}  // namespace rasterdiff::harness::cli
