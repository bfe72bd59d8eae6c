#include "harness/cli/pool.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <vector>

#include "harness/cli/job_queue.hpp"
#include "harness/cli/process.hpp"
#include "harness/pipe_bytes.hpp"

namespace rasterdiff::harness::cli {
namespace {

using Clock = std::chrono::steady_clock;
constexpr uint32_t kLongestMessage = 1U << 30;
constexpr size_t kHeader = 1 + sizeof(uint32_t);

struct Worker {
  Child child;
  std::string received;  ///< bytes that are not a whole message yet
  bool open = false;
  bool leaving = false;  ///< has said that it ends
  std::optional<uint32_t> job;
  std::optional<size_t> group;  ///< of JobQueue
  std::string phase{kDriverPhase};
  Clock::time_point since = Clock::now();
};

class Pool {
 public:
  Pool(std::span<const uint32_t> order, const PoolOptions& options, const std::function<void(WorkerLink&)>& body,
       const PoolEvents& events)
      : waiting_(order, options.groupOf), options_(options), body_(body), events_(events) {}

  PoolOutcome run() {
    while (!giveUp_) {
      while (!giveUp_ && workers_.size() < wanted()) start();
      if (workers_.empty()) break;
      waitForMessages();
      for (size_t w = 0; w < workers_.size(); ++w) watch(workers_[w]);
      std::erase_if(workers_, [](const Worker& worker) { return worker.child.pid < 0; });
      if (events_.tick) events_.tick();
    }
    for (Worker& worker : workers_) {
      if (worker.job) ++outcome_.notRun;
      (void)endChild(worker.child);
    }
    outcome_.notRun += waiting_.size();
    return outcome_;
  }

 private:
  /// Workers for the jobs that are running or waiting.
  [[nodiscard]] size_t wanted() const {
    const auto busy = static_cast<size_t>(
        std::count_if(workers_.begin(), workers_.end(), [](const Worker& worker) { return worker.job.has_value(); }));
    return std::min<size_t>(options_.workers, busy + waiting_.size());
  }

  void start() {
    std::vector<Child> siblings;
    for (const Worker& worker : workers_) siblings.push_back(worker.child);
    Worker worker;
    worker.child = startChild(siblings, [this](int jobs, int messages) {
      WorkerLink link(jobs, messages);
      body_(link);
    });
    if (worker.child.pid < 0) return stop("no further process could be started");
    workers_.push_back(std::move(worker));
  }

  void stop(std::string why) {
    giveUp_ = true;
    outcome_.stopped = std::move(why);
  }

  void waitForMessages() {
    constexpr int kTickMilliseconds = 200;
    std::vector<pollfd> pipes;
    for (const Worker& worker : workers_) pipes.push_back({worker.child.messages, POLLIN, 0});
    if (poll(pipes.data(), pipes.size(), kTickMilliseconds) <= 0) return;
    for (size_t w = 0; w < pipes.size() && !giveUp_; ++w) {
      if (pipes[w].revents != 0) receive(workers_[w]);
    }
  }

  void receive(Worker& worker) {
    std::string chunk(1 << 16, '\0');
    const ssize_t got = read(worker.child.messages, chunk.data(), chunk.size());
    if (got < 0 && errno == EINTR) return;
    if (got <= 0) return lose(worker, false, {});
    worker.received.append(chunk, 0, static_cast<size_t>(got));
    size_t at = 0;
    while (worker.child.pid >= 0 && worker.received.size() - at >= kHeader) {
      uint32_t size = 0;
      std::memcpy(&size, worker.received.data() + at + 1, sizeof size);
      if (size > kLongestMessage) return lose(worker, false, "it wrote an impossible message");
      if (worker.received.size() - at - kHeader < size) break;
      handle(worker, worker.received[at], std::string_view(worker.received).substr(at + kHeader, size));
      at += kHeader + size;
    }
    worker.received.erase(0, std::min(at, worker.received.size()));
  }

  void handle(Worker& worker, char kind, std::string_view payload) {
    worker.since = Clock::now();
    switch (kind) {
      case 'O':
        worker.open = true;
        if (events_.opened) events_.opened(payload);
        return giveJob(worker);
      case 'E':
        outcome_.openError = payload;
        return stop("the driver could not be opened");
      case 'P': worker.phase = payload; return;
      case 'R':
      case 'L': {
        if (!worker.job || !events_.record(*worker.job, payload)) {
          return lose(worker, false, "its record cannot be read");
        }
        worker.job.reset();
        worker.leaving = kind == 'L';
        if (!worker.leaving) {
          losses_ = 0;
          return giveJob(worker);
        }
        return countLoss();
      }
      default: return lose(worker, false, "it wrote an unknown message");
    }
  }

  void giveJob(Worker& worker) {
    worker.phase = kDriverPhase;
    worker.job = waiting_.next(worker.group);
    if (!worker.job) {
      worker.leaving = true;
      close(worker.child.jobs);
      worker.child.jobs = -1;
      return;
    }
    const uint32_t job = *worker.job;
    // A worker that is gone already shows as the end of its message pipe.
    (void)writeFully(worker.child.jobs, reinterpret_cast<const char*>(&job), sizeof job);
  }

  void watch(Worker& worker) {
    if (giveUp_ || worker.child.pid < 0) return;
    const double allowed = worker.phase == kDriverPhase ? options_.driverSeconds : options_.otherSeconds;
    const double passed = std::chrono::duration<double>(Clock::now() - worker.since).count();
    if (passed > allowed) lose(worker, true, fmt::format("no sign of life for {:.1f} s", passed));
  }

  /// The worker is gone, or has to go.
  void lose(Worker& worker, bool timedOut, const std::string& why) {
    const std::string words = lastWords(worker.child);
    const std::string end = endChild(worker.child);
    if (worker.leaving && !worker.job) return;
    std::string what = why.empty() ? (end.empty() ? "ended without a word" : end) : why;
    what += worker.open ? fmt::format(" in the {} phase", worker.phase) : " while the driver was opened";
    if (!words.empty()) what += fmt::format("; last line on stderr: {}", words);
    const Death death{timedOut, std::move(what)};
    if (!worker.open) {
      outcome_.openDeath = death;
      return stop("the driver could not be opened");
    }
    if (worker.job) events_.died(*worker.job, death);
    worker.job.reset();
    waiting_.leave(worker.group);
    countLoss();
  }

  void countLoss() {
    if (++losses_ >= options_.lossesInARow && !waiting_.empty()) {
      stop(fmt::format("the driver was lost {} times in a row", losses_));
    }
  }

  JobQueue waiting_;
  const PoolOptions& options_;
  const std::function<void(WorkerLink&)>& body_;
  const PoolEvents& events_;
  std::vector<Worker> workers_;
  PoolOutcome outcome_;
  unsigned losses_ = 0;
  bool giveUp_ = false;
};

}  // namespace

std::optional<uint32_t> WorkerLink::nextJob() const {
  uint32_t job = 0;
  if (!readFully(jobs_, reinterpret_cast<char*>(&job), sizeof job)) return std::nullopt;
  return job;
}

void WorkerLink::send(char kind, std::string_view payload) const {
  const auto size = static_cast<uint32_t>(std::min<size_t>(payload.size(), kLongestMessage));
  std::string message(1, kind);
  message.append(reinterpret_cast<const char*>(&size), sizeof size);
  message.append(payload.substr(0, size));
  // Without a reader there is nobody left to work for: the worker dies with its parent.
  (void)writeFully(messages_, message.data(), message.size());
}

PoolOutcome runPool(std::span<const uint32_t> order, const PoolOptions& options,
                    const std::function<void(WorkerLink&)>& worker, const PoolEvents& events) {
  struct sigaction ignore {}, before {};
  ignore.sa_handler = SIG_IGN;  // a worker that died between two messages must not take us along
  sigaction(SIGPIPE, &ignore, &before);
  PoolOutcome outcome = Pool(order, options, worker, events).run();
  sigaction(SIGPIPE, &before, nullptr);
  return outcome;
}

}  // namespace rasterdiff::harness::cli
