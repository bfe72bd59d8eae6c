#include "harness/cli/invariant_check.hpp"

#include <fmt/format.h>
#include <fnmatch.h>

#include "harness/cli/metered.hpp"
#include "harness/cli/pool.hpp"
#include "harness/invariants/run.hpp"
#include "scene/stopwatch.hpp"

namespace rasterdiff::harness::cli {
namespace {

constexpr uint64_t kSeed = 1;

Job jobOf(const invariants::Invariant& invariant) {
  const std::string name = std::string(kInvariantPrefix) + std::string(invariant.name);
  Job job{name, name, std::string(invariant.what), {}, {std::string(invariant.rule)}, [name]() -> Result<Scene> {
            return fail(ErrorCode::BadInput, name, "is an invariant of several scenes", "rasterdiff invariants --help");
          }};
  job.invariant = &invariant;
  return job;
}

Result<std::vector<Job>> invariantsOf(const std::string& word) {
  std::vector<Job> jobs;
  for (const invariants::Invariant& invariant : invariants::invariants()) {
    Job job = jobOf(invariant);
    if (fnmatch(word.c_str(), job.id.c_str(), 0) == 0) jobs.push_back(std::move(job));
  }
  if (jobs.empty()) return fail(ErrorCode::BadInput, "SCENE", fmt::format("no invariant is named '{}'", word), "rasterdiff invariants --help");
  return jobs;
}

void conclude(SceneResult& result, const invariants::Outcome& outcome) {
  result.samples = outcome.samples;
  result.differing = std::min(outcome.brokenCases, outcome.samples);
  result.same = outcome.samples - result.differing;
  if (outcome.cases == 0) {
    result.verdict = Verdict::Skipped;
    result.reason = "the driver offers none of its cases";
  } else if (outcome.broken) {
    const invariants::Broken& at = *outcome.broken;
    result.verdict = Verdict::Differs;
    result.reason = fmt::format("broken in {} of {} cases, first at ({}, {}) sample {}: {}", outcome.brokenCases, outcome.cases, at.x, at.y,
                                at.sample, at.what);
  }
}

}  // namespace

Result<std::vector<Job>> selectScenesAndInvariants(std::span<const std::string> words, const std::optional<RandomCount>& count) {
  std::vector<std::string> scenes, properties;
  for (const std::string& word : words) (word.starts_with(kInvariantPrefix) ? properties : scenes).push_back(word);
  if (words.empty() && !count) properties.push_back(std::string(kInvariantPrefix) + "*");
  std::vector<Job> jobs;
  if (words.empty() || !scenes.empty()) {
    Result<std::vector<Job>> selected = selectScenes(scenes, count);
    if (!selected) return selected;
    jobs = std::move(*selected);
  }
  for (const std::string& word : properties) {
    Result<std::vector<Job>> selected = invariantsOf(word);
    if (!selected) return selected;
    std::move(selected->begin(), selected->end(), std::back_inserter(jobs));
  }
  return jobs;
}

CheckedScene checkInvariant(const Job& job, Subject& subject, const std::function<void(std::string_view)>& entering) {
  CheckedScene checked{entryOf(job), false};
  entering(kDriverPhase);
  MeteredSubject metered(subject);
  Stopwatch watch;
  const Result<invariants::Outcome> outcome = invariants::run(*job.invariant, metered, kSeed, kInvariantCases);
  SceneResult& result = checked.entry.result;
  result.seconds = metered.seconds();
  result.seconds.compare = watch.lap() - result.seconds.driver;  // with the making of the cases
  if (outcome) {
    conclude(result, *outcome);
    return checked;
  }
  result.verdict = outcome.error().code == ErrorCode::TimedOut ? Verdict::TimedOut : Verdict::Crashed;
  result.reason = outcome.error().what;
  checked.subjectLost = true;
  return checked;
}

}  // namespace rasterdiff::harness::cli
