// Whatever can draw the first triangles of a load while a clock runs: kernels, the reference, the driver.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "harness/bench/load.hpp"
#include "harness/bench/truth.hpp"
#include "harness/subject.hpp"

namespace rasterdiff::harness::bench {

struct Settings {
  std::string kernels = "*";  ///< glob, or several with commas between them, over the methods' names
  uint32_t rounds = 5;
  unsigned threads = 1;       ///< for methods that can use several
  bool targets = false;       ///< every instruction set of this machine, not only the best
  std::optional<SubjectOptions> driver;
  double boxSamples = 2e7;    ///< looked at before a timing, see Truth
  double kernelSeconds = 0.03, frameSeconds = 0.3;  ///< one draw of a kernel, of the reference or driver, about
  double fixedParts = 4;      ///< of the latter: or this many times what a draw of next to nothing costs, if that is more
  double kernelWhole = 0.5, frameWhole = 1;  ///< seconds; what draws all of a load in this time is timed on all of it
};

/// Is the method wanted?
[[nodiscard]] bool chosen(const Settings& settings, const std::string& method);

struct Contender {
  std::vector<Row> rows;  ///< filled in but for the timing; several where one draw gives several figures
  double mostSeconds = 0; ///< one draw is to take about this
  double fixedParts = 0;  ///< or this many times what a draw costs anyway (a frame cleared, read back), if that is more
  double wholeSeconds = 0;  ///< if all of a load takes no longer, nothing less is timed: what is hidden costs less, and grows
  bool whole = false;     ///< draws all of a load or nothing
  /// Seconds of one draw of the first triangles, one figure a row.
  std::function<Result<std::vector<double>>(size_t triangles)> draw;
  /// The memory that a draw into a new target needs.
  std::function<std::optional<uint64_t>(size_t triangles)> peak;
};

/// A method that can use threads and chooses an instruction set, and one way to run it.
struct Run {
  unsigned threads = 1;
  int64_t target = 0;  ///< as Highway numbers them; 0: the best
};

/// The ways to run a method: one, unless it is `dispatched` and several threads or targets are asked for.
[[nodiscard]] std::vector<Run> runsOf(const Settings& settings, bool dispatched);

/// Name of the instruction set of a run of a dispatched method.
[[nodiscard]] std::string targetName(const Run& run);

/// While it lives, dispatched methods use the run's instruction set.
class TargetScope {
 public:
  explicit TargetScope(const Run& run);
  ~TargetScope();
  TargetScope(const TargetScope&) = delete;
  TargetScope& operator=(const TargetScope&) = delete;

 private:
  bool changed_;
};

/// The coverage kernels on a load, each verified; the wrong ones among the exact have `refused`.
[[nodiscard]] Result<std::vector<Contender>> maskContenders(const Load& load, const Truth& truth, const Settings& settings);

/// The kernels of index, count, depth and varyings, each with the planes that a task can want, verified against the
/// correctly rounded one. `expected`, if wanted, becomes that one's frame of the verified triangles.
[[nodiscard]] Result<std::vector<Contender>> valueContenders(const Load& load, Task task, const Truth& truth,
                                                             const Settings& settings, Frame* expected);

/// rasterizer::render, verified against `expected`; where that has no planes, render's own frame of the verified
/// triangles takes its place.
[[nodiscard]] Result<Contender> renderContender(const Load& load, Task task, const Truth& truth, const Settings& settings,
                                                Frame& expected);

/// Seconds that `work` takes.
[[nodiscard]] double secondsOf(const std::function<void()>& work);

}  // namespace rasterdiff::harness::bench
