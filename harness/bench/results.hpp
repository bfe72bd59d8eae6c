// What a measurement of speed against error gives: plain data that the writers of harness/report turn into text.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rasterdiff::harness::bench {

/// What has to come out of a draw; only contenders for the same task on the same load are compared.
enum class Task : uint8_t {
  Coverage,  ///< which samples are covered: a mask, an index or a count a sample
  Depth,     ///< and the depth of the nearest primitive
  Varyings,  ///< and four perspective floats
};
[[nodiscard]] constexpr std::string_view toString(Task task) {
  return task == Task::Coverage ? "coverage" : task == Task::Depth ? "depth" : "varyings";
}

/// Seconds of one draw over the rounds of a run; each round is the mean of `draws` draws.
struct Timing {
  double median = 0, fastest = 0;
  double deviation = 0;  ///< median absolute deviation from the median, as a fraction of it
  uint32_t rounds = 0, draws = 0;
};

/// Against the exact answer, on the first `triangles` of a load.
struct ErrorCount {
  uint64_t triangles = 0;
  uint64_t covered = 0;  ///< samples that these triangles cover, overdraw counted
  uint64_t wrong = 0;    ///< samples with another coverage, primitive or count
  uint64_t values = 0;   ///< floats compared: those of samples where the primitive is right
  double maxUlp = 0, meanUlp = 0;
};

/// One contender on one load.
struct Row {
  Task task = Task::Coverage;
  std::string method, what;
  bool exact = false;        ///< promises the exact answer: it is not timed where it breaks that
  std::string target;        ///< instruction set by Highway's name; empty: that of the build, or the driver's choice
  unsigned threads = 1;
  uint64_t triangles = 0;    ///< timed: the first of the load
  double samples = 0;        ///< covered samples of these
  std::optional<Timing> timing;
  std::optional<ErrorCount> error;
  std::optional<uint64_t> peakBytes;  ///< how far the process grew while it drew, its target included
  std::string refused;                ///< why there is no timing
};

[[nodiscard]] inline double trianglesPerSecond(const Row& row) {
  return row.timing ? static_cast<double>(row.triangles) / row.timing->median : 0;
}
[[nodiscard]] inline double samplesPerSecond(const Row& row) { return row.timing ? row.samples / row.timing->median : 0; }

struct LoadResult {
  std::string name, what;
  uint32_t width = 0, height = 0, samples = 1;
  uint64_t triangles = 0;
  double coveredSamples = 0;  ///< of all triangles, overdraw counted
  std::string note;           ///< what was left out, and why
  std::vector<Row> rows;
};

/// One way to sample pixels: error against exact area, and what it costs.
struct SamplingRow {
  std::string method;
  uint32_t samples = 0;  ///< a pixel; 0: exact area
  uint64_t pixels = 0;   ///< partly covered ones
  double maxError = 0, rmsError = 0;  ///< fraction of a pixel's area
  uint64_t wrong = 0;                 ///< pixels that differ in 8 bits
  Timing timing;                      ///< of one pixel
};

/// One variable is changed, all else stays.
struct ScalingSeries {
  std::string name;      ///< "triangle size"
  std::string variable;  ///< "pixels a triangle"
  std::string expected;  ///< what a good method shows, in words
  bool perSample = false;  ///< the figure to look at is the time per covered sample, not per triangle
  struct Point {
    double x = 0;
    Row row;
  };
  std::vector<Point> points;
};

struct Machine {
  std::string cpu, compiler, system, date;  ///< date: UTC, 2025-01-31 12:00
  unsigned cores = 1;                       ///< that this process may use
  std::vector<std::string> targets;         ///< instruction sets, best first
  double loadAverage = 0;                   ///< of the last minute, when the run began
};

struct Results {
  Machine machine;
  std::string driver;  ///< one line; empty: none
  uint32_t rounds = 5;
  std::vector<LoadResult> loads;
  std::vector<SamplingRow> sampling;
  std::vector<ScalingSeries> scaling;
  double wallSeconds = 0;
};

}  // namespace rasterdiff::harness::bench
