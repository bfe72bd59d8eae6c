#include "harness/cli/hunt_workers.hpp"

#include <functional>
#include <thread>

#include "harness/cli/isolated.hpp"
#include "harness/cli/pool.hpp"
#include "harness/cli/rule_choice.hpp"
#include "harness/hunt/record.hpp"
#include "harness/report/record.hpp"

namespace rasterdiff::harness::cli {
namespace {

using Clock = std::chrono::steady_clock;

/// A driver and the rules that it is judged by.
struct Opened {
  std::unique_ptr<Subject> subject;
  rasterizer::Rules rules;
};

Result<Opened> open(const DriverChoice& choice) {
  Result<std::unique_ptr<Subject>> subject = openSubject(subjectOptions(choice));
  if (!subject) return tl::unexpected(subject.error());
  Result<rasterizer::Rules> rules = rulesFor(choice, **subject);
  if (!rules) return tl::unexpected(rules.error());
  return Opened{std::move(*subject), std::move(*rules)};
}

/// The life of a worker: `job` gets the driver and returns the record, and says whether the driver was lost.
void serve(WorkerLink& link, const DriverChoice& choice,
           const std::function<std::string(uint32_t job, const hunt::Judge& judge, bool& lost)>& run) {
  Result<Opened> opened = open(choice);
  if (!opened) return link.cannotOpen(recordOf(opened.error()));
  // The process ends with the work and the system frees what the driver holds: a hang on closing is nobody's loss.
  Subject& driver = *opened->subject.release();
  const hunt::Judge judging = [&](const Scene& scene) {
    link.entering(kDriverPhase);  // the watchdog's clock starts anew with every scene
    return hunt::judge(scene, driver, opened->rules);
  };
  link.opened({});
  while (const std::optional<uint32_t> job = link.nextJob()) {
    bool lost = false;
    const std::string record = run(*job, judging, lost);
    link.done(record, lost);
    if (lost) return;
  }
}

std::vector<uint32_t> firstNumbers(size_t count) {
  std::vector<uint32_t> numbers(count);
  for (uint32_t i = 0; i < count; ++i) numbers[i] = i;
  return numbers;
}

constexpr std::string_view kTooLate = "-";

}  // namespace

HuntWorkers::HuntWorkers(const HuntOptions& options)
    : options_(options), workers_(options.jobs > 0 ? options.jobs : std::max(1U, std::thread::hardware_concurrency())) {}

Result<RunSubject> HuntWorkers::introduce() const {
  const Result<std::string> record = isolated(watchdogSeconds(options_.choice.timeoutSeconds), [&]() -> Result<std::string> {
    const Result<Opened> opened = open(options_.choice);
    if (!opened) return tl::unexpected(opened.error());
    const Subject& s = *opened->subject;
    return recordOf(RunSubject{options_.choice.driver, s.name(), s.info(), subjectLine(s), s.details(), s.limits(), opened->rules.name, opened->rules.open});
  });
  if (!record) return tl::unexpected(record.error());
  return readSubjectRecord(*record);
}

hunt::Judgement HuntWorkers::judgedAlone(const Scene& scene) const {
  const Result<std::string> record = isolated(watchdogSeconds(options_.choice.timeoutSeconds), [&]() -> Result<std::string> {
    const Result<Opened> opened = open(options_.choice);
    if (!opened) return tl::unexpected(opened.error());
    return hunt::recordOf(hunt::judge(scene, *opened->subject, opened->rules));
  });
  if (record) {
    if (Result<hunt::Judgement> judgement = hunt::readJudgementRecord(*record)) return std::move(*judgement);
  }
  const bool hung = !record && record.error().code == ErrorCode::TimedOut;
  hunt::Judgement judgement;
  judgement.verdict = hung ? Verdict::TimedOut : Verdict::Crashed;
  judgement.reason = record ? "its record cannot be read" : record.error().what;
  judgement.differences = {{hung ? "hang" : "crash"}};
  return judgement;
}

bool HuntWorkers::isSteady(const hunt::Shrunk& shrunk) const { return find(judgedAlone(shrunk.scene), shrunk.kind) != nullptr; }

std::vector<hunt::LaneResult> HuntWorkers::lanes(const hunt::Campaign& campaign, uint64_t first, uint32_t count,
                                                 std::optional<Clock::time_point> deadline) {
  enum class State : uint8_t { Missing, Done, Lost };
  std::vector<hunt::LaneResult> results(count);
  std::vector<State> states(count, State::Missing);
  PoolEvents events;
  events.record = [&](uint32_t job, std::string_view record) {
    if (record == kTooLate) return true;
    Result<hunt::LaneResult> lane = hunt::readLaneRecord(record);
    if (!lane) return false;
    results[job] = std::move(*lane);
    states[job] = State::Done;
    return true;
  };
  events.died = [&](uint32_t job, const Death&) { states[job] = State::Lost; };
  const std::vector<uint32_t> order = firstNumbers(count);
  PoolOptions pool;
  pool.workers = workers_;
  pool.driverSeconds = watchdogSeconds(options_.choice.timeoutSeconds);
  const PoolOutcome outcome = runPool(order, pool, [&](WorkerLink& link) {
    serve(link, options_.choice, [&](uint32_t job, const hunt::Judge& judging, bool& lost) {
      if (deadline && Clock::now() >= *deadline) return std::string(kTooLate);
      const hunt::LaneResult lane = hunt::searchLane(campaign.corpus(), campaign.laneOptions(first + job), judging);
      lost = lane.tally.lost > 0;
      return hunt::recordOf(lane);
    });
  }, events);
  stopped_ = outcome.stopped;
  for (uint32_t job = 0; job < count; ++job) {
    if (states[job] == State::Missing) {
      results.resize(job);
      break;
    }
    if (states[job] == State::Done) continue;
    results[job] = hunt::searchLane(campaign.corpus(), campaign.laneOptions(first + job), [&](const Scene& scene) { return judgedAlone(scene); });
  }
  return results;
}

std::vector<hunt::Shrunk> HuntWorkers::shrink(const std::vector<hunt::Raw>& raw) {
  std::vector<hunt::Shrunk> results;
  for (const hunt::Raw& r : raw) results.push_back({r.scene, r.signature.kind, {}, 0});
  std::vector<uint32_t> inWorkers;
  for (uint32_t job = 0; job < raw.size(); ++job) {
    if (raw[job].verdict == Verdict::Differs) {
      inWorkers.push_back(job);
      continue;
    }
    // Every try costs a process, and a hang the whole timeout.
    const hunt::ShrinkOptions few{raw[job].verdict == Verdict::Crashed ? 200U : 12U};
    results[job] = hunt::shrink(raw[job].scene, raw[job].signature.kind, [&](const Scene& scene) { return judgedAlone(scene); }, few);
  }
  PoolEvents events;
  events.record = [&](uint32_t job, std::string_view record) {
    Result<hunt::Shrunk> shrunk = hunt::readShrunkRecord(record);
    if (!shrunk) return false;
    results[job] = std::move(*shrunk);
    return true;
  };
  events.died = [&](uint32_t job, const Death& death) { results[job].judgement.reason = "not shrunk: " + death.what; };
  PoolOptions pool;
  pool.workers = workers_;
  pool.driverSeconds = watchdogSeconds(options_.choice.timeoutSeconds);
  (void)runPool(inWorkers, pool, [&](WorkerLink& link) {
    serve(link, options_.choice, [&](uint32_t job, const hunt::Judge& judging, bool& lost) {
      const hunt::Shrunk shrunk = hunt::shrink(raw[job].scene, raw[job].signature.kind, judging);
      lost = shrunk.judgement.verdict == Verdict::Crashed || shrunk.judgement.verdict == Verdict::TimedOut;
      return hunt::recordOf(shrunk);
    });
  }, events);
  return results;
}

}  // namespace rasterdiff::harness::cli
