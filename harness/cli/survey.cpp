#include "harness/cli/survey.hpp"

#include <algorithm>
#include <chrono>
#include <numeric>
#include <utility>

#include "harness/cli/check_worker.hpp"
#include "harness/cli/isolated.hpp"
#include "harness/cli/progress.hpp"
#include "harness/compare/baseline.hpp"
#include "harness/report/record.hpp"

namespace rasterdiff::harness::cli {
namespace {

/// Meshes first: the longest work must not start last.
std::vector<uint32_t> workOrder(const std::vector<Job>& jobs) {
  std::vector<uint32_t> order(jobs.size());
  std::iota(order.begin(), order.end(), 0U);
  std::ranges::stable_partition(order, [&](uint32_t job) { return jobs[job].id.starts_with("mesh/"); });
  return order;
}

std::string refusalOf(const PoolOutcome& outcome) {
  if (outcome.openDeath) return outcome.openDeath->what;
  const Result<Error> error = readErrorRecord(outcome.openError);
  return error ? error->what : error.error().what;
}

}  // namespace

DriverPass passOver(const std::vector<Job>& jobs, const DriverChoice& choice, unsigned workers, Progress& progress) {
  const auto start = std::chrono::steady_clock::now();
  DriverPass pass;
  pass.driver = choice.driver;
  std::vector<std::pair<uint32_t, SceneEntry>> found;
  PoolEvents events;
  events.opened = [&](std::string_view record) {
    if (Result<RunSubject> subject = readSubjectRecord(record); subject) pass.subject = std::move(*subject);
  };
  events.record = [&](uint32_t job, std::string_view record) {
    Result<SceneEntry> entry = readSceneRecord(record);
    if (!entry) return false;
    progress.done(*entry);
    found.emplace_back(job, std::move(*entry));
    return true;
  };
  events.died = [&](uint32_t job, const Death& death) {
    found.emplace_back(job, entryOfDeath(jobs[job], death));
    progress.done(found.back().second);
  };
  events.tick = [&] { progress.tick(); };

  PoolOptions pool;
  pool.workers = workers;
  pool.driverSeconds = watchdogSeconds(choice.timeoutSeconds);
  const std::vector<uint32_t> order = workOrder(jobs);
  const PoolOutcome outcome = runPool(
      order, pool, [&](WorkerLink& link) { checkScenes(link, choice, jobs, [](uint32_t) { return CheckSettings{}; }); }, events);
  if (found.empty()) pass.refusal = refusalOf(outcome);
  std::ranges::sort(found, {}, &std::pair<uint32_t, SceneEntry>::first);
  for (auto& [job, entry] : found) {
    if (!entry.error) applyBaseline(builtInBaseline(), pass.subject.name, pass.subject.info, pass.subject.rules, entry.result);
    pass.scenes.push_back(std::move(entry));
  }
  pass.stopped = outcome.stopped;
  pass.notRun = outcome.notRun;
  pass.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return pass;
}

DriverPass passOver(const std::vector<Job>& jobs, const std::string& driver) {
  DriverChoice choice;
  choice.driver = driver;
  choice.rules = "spec";  // a profile copies its driver's bugs
  Progress progress(jobs.size());
  DriverPass pass = passOver(jobs, choice, coresToUse(), progress);
  progress.clear();
  return pass;
}

}  // namespace rasterdiff::harness::cli
