#include "harness/cli/isolated.hpp"

#include <array>
#include <cstdint>

#include "harness/cli/pool.hpp"
#include "harness/report/record.hpp"

namespace rasterdiff::harness::cli {

double watchdogSeconds(double timeoutSeconds) { return 2 * timeoutSeconds + 2; }

Result<std::string> isolated(double seconds, const std::function<Result<std::string>()>& work) {
  constexpr std::array<uint32_t, 1> kOneJob{0};
  constexpr char kAnswer = '+', kError = '-';
  Result<std::string> result = fail(ErrorCode::DeviceLost, {}, "the driver's process could not be started");
  PoolEvents events;
  events.record = [&](uint32_t, std::string_view record) {
    if (record.empty()) return false;
    if (record.front() == kAnswer) {
      result = std::string(record.substr(1));
      return true;
    }
    const Result<Error> error = readErrorRecord(record.substr(1));
    result = tl::unexpected(error ? *error : error.error());
    return true;
  };
  events.died = [&](uint32_t, const Death& death) {
    result = fail(death.timedOut ? ErrorCode::TimedOut : ErrorCode::DeviceLost, {},
                  (death.timedOut ? "the driver hung: " : "the driver crashed: ") + death.what,
                  "the results of the other commands do not depend on it");
  };
  const PoolOptions options{1, seconds, seconds, 1};
  (void)runPool(kOneJob, options, [&](WorkerLink& link) {
    link.opened({});
    while (link.nextJob()) {
      const Result<std::string> answer = work();
      link.done(answer ? kAnswer + *answer : kError + recordOf(answer.error()), false);
    }
  }, events);
  return result;
}

}  // namespace rasterdiff::harness::cli
