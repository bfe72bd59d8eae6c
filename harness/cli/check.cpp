// `check`: draws every selected scene with both sides, in worker processes, and writes what was found.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <map>
#include <set>

#include "harness/cli/check_worker.hpp"
#include "harness/cli/invariant_check.hpp"
#include "harness/cli/isolated.hpp"
#include "harness/cli/job_groups.hpp"
#include "harness/cli/memory.hpp"
#include "harness/cli/driver_range.hpp"
#include "harness/cli/message.hpp"
#include "harness/cli/panel.hpp"
#include "harness/cli/progress.hpp"
#include "harness/cli/rule_choice.hpp"
#include "harness/cli/run.hpp"
#include "harness/compare/baseline.hpp"
#include "harness/report/html.hpp"
#include "harness/report/json.hpp"
#include "harness/report/junit.hpp"
#include "harness/report/output.hpp"
#include "harness/report/record.hpp"
#include "harness/report/summary.hpp"

namespace rasterdiff::harness::cli {
namespace {

/// Collects records; batches of one family become one entry.
class Collector {
 public:
  explicit Collector(const std::vector<Job>& jobs) : jobs_(jobs) {}

  void add(uint32_t job, SceneEntry entry) {
    const auto [at, isNew] = entryOfId_.try_emplace(jobs_[job].id, entries_.size());
    if (isNew) {
      entries_.push_back({job, std::move(entry)});
    } else {
      addBatch(entries_[at->second].entry, std::move(entry));
    }
  }

  /// In the order of the selection, whatever order the workers took.
  [[nodiscard]] std::vector<SceneEntry> entries() && {
    std::stable_sort(entries_.begin(), entries_.end(), [&](const auto& a, const auto& b) { return a.job < b.job; });
    std::vector<SceneEntry> sorted;
    for (auto& [job, entry] : entries_) sorted.push_back(std::move(entry));
    return sorted;
  }

 private:
  struct Numbered {
    uint32_t job;
    SceneEntry entry;
  };
  const std::vector<Job>& jobs_;
  std::map<std::string, size_t> entryOfId_;
  std::vector<Numbered> entries_;
};

/// Meshes first: the longest work must not start last.
std::vector<uint32_t> workOrder(const std::vector<Job>& jobs, const CheckOptions& options) {
  std::vector<uint32_t> order;
  for (uint32_t job = 0; job < jobs.size(); ++job) {
    if (job % options.shards == options.shard - 1) order.push_back(job);
  }
  std::stable_partition(order.begin(), order.end(), [&](uint32_t job) { return jobs[job].id.starts_with("mesh/"); });
  return order;
}

/// Every scene has pictures in the report, a random family those of its first batch.
std::set<uint32_t> picturedJobs(const std::vector<Job>& jobs, const std::vector<uint32_t>& order, bool wanted) {
  std::set<uint32_t> pictured;
  std::set<std::string> seen;
  if (!wanted) return pictured;
  for (const uint32_t job : order) {
    if (seen.insert(jobs[job].id).second) pictured.insert(job);
  }
  return pictured;
}

Result<Baseline> baselineOf(const CheckOptions& options) {
  if (options.baseline.empty()) return builtInBaseline();
  if (options.baseline == "none") return Baseline{};
  return loadBaseline(options.baseline);
}

Result<void> writeOutputs(const CheckOptions& options, const Report& report) {
  if (!options.json.empty()) {
    if (Result<void> written = writeFile(options.json, jsonReport(report)); !written) return written;
  }
  if (!options.junit.empty()) {
    if (Result<void> written = writeFile(options.junit, junitReport(report)); !written) return written;
  }
  if (!options.report.empty()) {
    if (Result<void> written = writeFile(options.report, htmlReport(report)); !written) return written;
  }
  return {};
}

/// A baseline of another version of the driver excuses nothing: says so, what is old, and how to have one of this version.
void printOtherVersions(const Baseline& baseline, const Report& report) {
  const RunSubject& subject = report.subject;
  const std::vector<std::string> versions = otherVersions(baseline, subject.name, subject.info);
  uint64_t failed = 0, old = 0;
  for (const SceneEntry& entry : report.scenes) {
    if (entry.error || !isUnexpected(entry.result)) continue;
    ++failed;
    old += differsInSomeVersion(baseline, subject.name, subject.rules, entry.result) ? 1U : 0U;
  }
  if (versions.empty() || failed == 0) return;
  fmt::print("baseline  it knows {} {}, not {}: {} of the {} failing scenes differ there in the same planes; to have this version's known:\n"
             "          rasterdiff check --json results.json; rasterdiff bless results.json -o baseline.json --reason \"…\"; then --baseline baseline.json\n",
             subject.name, fmt::join(versions, ", "), subject.info, old, failed);
}

int finish(const CheckOptions& options, const Baseline& baseline, const Report& report) {
  fmt::print("{}", summaryText(report));
  printOtherVersions(baseline, report);
  if (const Result<void> written = writeOutputs(options, report); !written) {
    return complain(written.error(), "rasterdiff check --help");
  }
  for (const auto& [what, path] : {std::pair{"report", &options.report}, {"results", &options.json}}) {
    if (!path->empty()) fmt::print("{:<9} {}\n", what, *path);
  }
  const int status = exitStatus(report);
  if (status == 0) return 0;
  std::fflush(stdout);
  const std::string next = nextCommand(report);
  if (!next.empty()) fmt::print(stderr, "{}\n", next);
  return status;
}

int openFailed(const PoolOutcome& outcome) {
  if (outcome.openDeath) {
    const Error error{outcome.openDeath->timedOut ? ErrorCode::TimedOut : ErrorCode::DeviceLost, "--driver",
                      outcome.openDeath->what, "the driver cannot even be opened; try another one"};
    return complain(error, "rasterdiff devices");
  }
  const Result<Error> error = readErrorRecord(outcome.openError);
  const Error& known = error ? *error : error.error();
  return complain(known, nextCommand(known, "check"));
}

}  // namespace

int runVerb(const CheckOptions& options) {
  keepFreedMemory();  // of this process and of its workers
  const auto start = std::chrono::steady_clock::now();
  if (const Result<void> known = checkRulesName(options.choice.rules); !known) {
    return complain(known.error(), "rasterdiff check --help");
  }
  std::optional<RandomCount> count;
  if (options.count) count = RandomCount{*options.count, options.seed};
  const Result<std::vector<Job>> jobs = selectScenesAndInvariants(options.scenes, count);
  if (!jobs) return complain(jobs.error(), nextCommand(jobs.error(), "check"));
  // A path that cannot be written must not cost the minute before it is noticed.
  for (const std::string* path : {&options.json, &options.junit, &options.report}) {
    if (path->empty()) continue;
    if (const Result<void> writable = checkWritable(*path); !writable) {
      return complain(writable.error(), "rasterdiff check --help");
    }
  }

  if (namesSeveral(options.choice.driver)) return checkSeveral(options, *jobs);
  const std::vector<uint32_t> order = workOrder(*jobs, options);
  if (order.empty()) {
    return complain({ErrorCode::BadInput, "--shard", "this part of the work is empty",
                     fmt::format("there are only {} scenes to share out", jobs->size())}, "rasterdiff list");
  }
  const Result<Baseline> baseline = baselineOf(options);
  if (!baseline) return complain(baseline.error(), "rasterdiff check --help");
  const std::set<uint32_t> pictured = picturedJobs(*jobs, order, !options.report.empty());
  Report report;
  if (options.choice.rules != "auto") report.rulesOption = options.choice.rules;
  Collector collector(*jobs);
  Progress progress(order.size());
  PoolEvents events;
  events.opened = [&](std::string_view record) {
    if (Result<RunSubject> subject = readSubjectRecord(record); subject) report.subject = std::move(*subject);
  };
  events.record = [&](uint32_t job, std::string_view record) {
    Result<SceneEntry> entry = readSceneRecord(record);
    if (!entry) return false;
    progress.done(*entry);
    collector.add(job, std::move(*entry));
    return true;
  };
  events.died = [&](uint32_t job, const Death& death) {
    SceneEntry entry = entryOfDeath((*jobs)[job], death);
    progress.done(entry);
    collector.add(job, std::move(entry));
  };
  events.tick = [&] { progress.tick(); };

  PoolOptions pool;
  pool.workers = options.jobs > 0 ? options.jobs : coresToUse();
  pool.driverSeconds = watchdogSeconds(options.choice.timeoutSeconds);
  const unsigned workers = std::min<unsigned>(pool.workers, static_cast<unsigned>(order.size()));
  JobGroups groups;
  if (workers > 1) pool.groupOf = [&](uint32_t job) { return groups.of((*jobs)[job]); };
  const auto settings = [&](uint32_t job) {
    CheckSettings chosen{.pictures = pictured.contains(job), .dump = std::nullopt, .rounds = options.rounds, .threads = std::max(1U, coresToUse() / workers)};
    if (!options.dump.empty()) chosen.dump = options.dump;
    return chosen;
  };
  const PoolOutcome outcome =
      runPool(order, pool, [&](WorkerLink& link) { checkScenes(link, options.choice, *jobs, settings); }, events);
  progress.clear();
  report.scenes = std::move(collector).entries();
  if (report.scenes.empty()) return openFailed(outcome);
  for (SceneEntry& entry : report.scenes) {
    if (!entry.error) applyBaseline(*baseline, report.subject.name, report.subject.info, report.subject.rules, entry.result);
  }
  report.stopped = outcome.stopped;
  report.notRun = outcome.notRun;
  report.workers = workers;
  report.wallSeconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return finish(options, *baseline, report);
}

}  // namespace rasterdiff::harness::cli
