#include "harness/cli/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

#include "harness/report/numbers.hpp"

namespace rasterdiff::harness::cli {
namespace {

constexpr double kTerminalSeconds = 0.2, kPlainSeconds = 10;

}  // namespace

Progress::Progress(size_t total)
    : total_(total), terminal_(isatty(STDERR_FILENO) == 1), start_(std::chrono::steady_clock::now()), last_(start_) {}

void Progress::done(const SceneEntry& entry) {
  ++finished_;
  samples_ += entry.result.samples;
  const Verdict verdict = entry.result.verdict;
  if (entry.error || verdict == Verdict::Differs || verdict == Verdict::Crashed || verdict == Verdict::TimedOut) ++failed_;
}

void Progress::tick() {
  const auto now = std::chrono::steady_clock::now();
  if (std::chrono::duration<double>(now - last_).count() < (terminal_ ? kTerminalSeconds : kPlainSeconds)) return;
  last_ = now;
  const std::string line = fmt::format("{}/{} scenes, {} samples{}, {}", grouped(finished_), grouped(total_),
                                       grouped(samples_), failed_ > 0 ? fmt::format(", {} failed", grouped(failed_)) : "",
                                       secondsText(std::chrono::duration<double>(now - start_).count()));
  if (terminal_) {
    fmt::print(stderr, "\r\x1b[K{}", line);
    std::fflush(stderr);
    shown_ = true;
  } else {
    fmt::print(stderr, "{}\n", line);
  }
}

void Progress::clear() {
  if (shown_) fmt::print(stderr, "\r\x1b[K");
}

}  // namespace rasterdiff::harness::cli
