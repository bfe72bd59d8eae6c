#include "harness/cli/check_worker.hpp"

#include <sched.h>

#include <algorithm>

#include "harness/cli/invariant_check.hpp"
#include "harness/cli/rule_choice.hpp"
#include "harness/report/record.hpp"

namespace rasterdiff::harness::cli {

void checkScenes(WorkerLink& link, const DriverChoice& choice, const std::vector<Job>& jobs, const JobSettings& settings) {
  Result<std::unique_ptr<Subject>> subject = openSubject(subjectOptions(choice));
  if (!subject) return link.cannotOpen(recordOf(subject.error()));
  const Result<rasterizer::Rules> rules = rulesFor(choice, **subject);
  if (!rules) return link.cannotOpen(recordOf(rules.error()));
  // The process ends with the work and the system frees what the driver holds: a hang on closing is nobody's loss.
  Subject& driver = *subject->release();
  link.opened(recordOf(RunSubject{choice.driver, driver.name(), driver.info(), subjectLine(driver), driver.details(),
                                  driver.limits(), rules->name, rules->open}));
  while (const std::optional<uint32_t> job = link.nextJob()) {
    const auto entering = [&](std::string_view phase) { link.entering(phase); };
    const bool property = jobs[*job].invariant != nullptr;
    const CheckedScene checked =
        property ? checkInvariant(jobs[*job], driver, entering) : checkScene(jobs[*job], driver, *rules, settings(*job), entering);
    link.done(recordOf(checked.entry), checked.subjectLost);
    if (checked.subjectLost) return;
  }
}

SceneEntry entryOfDeath(const Job& job, const Death& death) {
  SceneEntry entry = entryOf(job);
  entry.result.verdict = death.timedOut ? Verdict::TimedOut : Verdict::Crashed;
  entry.result.reason = death.what;
  return entry;
}

unsigned coresToUse() {
  cpu_set_t cores;
  CPU_ZERO(&cores);
  if (sched_getaffinity(0, sizeof cores, &cores) != 0) return 2;
  return static_cast<unsigned>(std::max(1, CPU_COUNT(&cores)));
}

}  // namespace rasterdiff::harness::cli
