// The driver under test in a process of its own, drawing one load whenever it is told to: a crash or a hang costs its rows,
// not the run. It has as many cores as it may use threads.
#pragma once

#include <optional>

#include "harness/bench/load.hpp"
#include "harness/cli/process.hpp"
#include "harness/subject.hpp"
#include "scene/frame.hpp"

namespace rasterdiff::harness::bench {

class DriverProcess {
 public:
  struct Job {
    const Load* load = nullptr;
    Task task = Task::Coverage;
    size_t verified = 0;              ///< triangles of the frame below
    const Frame* expected = nullptr;  ///< the reference's frame of them
    unsigned threads = 1;
    SubjectOptions driver;
  };
  struct Drawn {
    double drawSeconds = 0;   ///< the device's own; 0 where the driver does not tell
    double wholeSeconds = 0;  ///< upload, draw, readback
    uint64_t peakBytes = 0;   ///< growth since before it was opened; 0 where the system does not tell
  };

  /// Forks and opens the driver. What the job points to must live until here. Error: NoDevice, DeviceLost, TimedOut.
  [[nodiscard]] static Result<DriverProcess> open(const Job& job);

  /// "llvmpipe: Mesa 22.3.6 …"
  [[nodiscard]] const std::string& line() const { return line_; }
  /// Draws the first `triangles`. Error: NotOffered, DeviceLost, TimedOut.
  [[nodiscard]] Result<Drawn> draw(size_t triangles);
  /// Draws the verified triangles and compares the frames. Errors as of draw.
  [[nodiscard]] Result<ErrorCount> verify();

  DriverProcess(DriverProcess&& other) noexcept;
  DriverProcess& operator=(DriverProcess&&) = delete;
  ~DriverProcess();

 private:
  DriverProcess(cli::Child child, double seconds) : child_(child), seconds_(seconds) {}
  [[nodiscard]] Result<std::string> ask(uint64_t triangles);
  [[nodiscard]] Result<std::string> answer();
  [[nodiscard]] Error death(bool timedOut);

  cli::Child child_;
  double seconds_;  ///< how long an answer may take
  std::string line_;
};

}  // namespace rasterdiff::harness::bench
