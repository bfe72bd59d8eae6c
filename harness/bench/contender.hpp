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
  double kernelSeconds = 0.03, frameSeconds = 0.3;  ///< one draw of a kernel, of the reference or driver, at most
};

/// Is the method wanted?
[[nodiscard]] bool chosen(const Settings& settings, const std::string& method);

struct Contender {
  std::vector<Row> rows;  ///< filled in but for the timing; several where one draw gives several figures
  double mostSeconds = 0; ///< one draw is to take no longer
  bool whole = false;     ///< draws all of a load or nothing
  /// Seconds of one draw of the first triangles, one figure a row.
  std::function<Result<std::vector<double>>(size_t triangles)> draw;
  /// The memory that a draw into a new target needs.
  std::function<std::optional<uint64_t>(size_t triangles)> peak;
};

/// The coverage kernels on a load, each verified; the wrong ones among the exact have `refused`.
[[nodiscard]] Result<std::vector<Contender>> maskContenders(const Load& load, const Truth& truth, const Settings& settings);

/// rasterizer::render, verified where coverage is all there is to a built-in load; `expected` becomes its frame of the
/// first `verified` triangles.
[[nodiscard]] Result<Contender> renderContender(const Load& load, Task task, const Truth& truth, const Settings& settings,
                                                Frame& expected);

/// Seconds that `work` takes.
[[nodiscard]] double secondsOf(const std::function<void()>& work);

}  // namespace rasterdiff::harness::bench
