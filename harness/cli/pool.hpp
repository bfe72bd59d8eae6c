// Worker processes that may crash or hang without taking the run with them. The pool knows forks, pipes, signals and
// clocks; what a job is, and what its record says, is the caller's. The calling process never runs a job itself.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace rasterdiff::harness::cli {

/// The worker's end. Wire format: kind (1 byte), length (4 bytes), payload.
class WorkerLink {
 public:
  WorkerLink(int jobs, int messages) : jobs_(jobs), messages_(messages) {}

  void opened(std::string_view driverRecord) const { send('O', driverRecord); }
  void cannotOpen(std::string_view errorRecord) const { send('E', errorRecord); }
  /// Blocks until there is work; nothing = go home.
  [[nodiscard]] std::optional<uint32_t> nextJob() const;
  /// What the worker is about to do. The clock of the watchdog starts anew.
  void entering(std::string_view phase) const { send('P', phase); }
  /// The job is done. `subjectLost`: the driver is beyond use, and the worker ends after this record.
  void done(std::string_view record, bool subjectLost) const { send(subjectLost ? 'L' : 'R', record); }

 private:
  void send(char kind, std::string_view payload) const;
  int jobs_, messages_;
};

inline constexpr std::string_view kDriverPhase = "driver";

struct PoolOptions {
  unsigned workers = 1;
  double driverSeconds = 42;   ///< longest stay in the driver phase, opening included
  double otherSeconds = 300;   ///< longest stay in any other phase
  unsigned lossesInARow = 5;   ///< crashes and hangs without a good record between them, after which the pool gives up
  /// Jobs that a worker gains from doing one after the other, as the driver keeps what it has compiled; none: the order is kept.
  std::function<std::string(uint32_t job)> groupOf{};
};

/// How a worker ended that did not end by itself.
struct Death {
  bool timedOut = false;
  std::string what;  ///< "killed by signal 11 (Segmentation fault) in the driver phase; last words: …"
};

/// All are called in the calling process.
struct PoolEvents {
  std::function<void(std::string_view driverRecord)> opened;  ///< once a worker
  std::function<bool(uint32_t job, std::string_view record)> record;  ///< false: unreadable, counts as a crash
  std::function<void(uint32_t job, const Death&)> died;
  std::function<void()> tick;  ///< several times a second
};

struct PoolOutcome {
  std::string openError;  ///< an error record: no worker could open the driver
  std::optional<Death> openDeath;  ///< a worker died while it opened the driver
  std::string stopped;    ///< why jobs were left out, or empty
  uint64_t notRun = 0;
};

/// Runs every job of `order` in worker processes; `worker` is the life of one of them.
[[nodiscard]] PoolOutcome runPool(std::span<const uint32_t> order, const PoolOptions& options,
                                  const std::function<void(WorkerLink&)>& worker, const PoolEvents& events);

}  // namespace rasterdiff::harness::cli
