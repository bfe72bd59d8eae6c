// `bench`: speed against error for every kernel, the reference and the driver, on the built-in workloads or any scene.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>

#include "harness/bench/machine.hpp"
#include "harness/bench/measure.hpp"
#include "harness/bench/sampling.hpp"
#include "harness/bench/scaling.hpp"
#include "harness/cli/bench_loads.hpp"
#include "harness/cli/message.hpp"
#include "harness/cli/rule_choice.hpp"
#include "harness/cli/run.hpp"
#include "harness/report/bench_data.hpp"
#include "harness/report/bench_html.hpp"
#include "harness/report/bench_plots.hpp"
#include "harness/report/bench_text.hpp"
#include "harness/report/numbers.hpp"
#include "harness/report/output.hpp"

namespace rasterdiff::harness::cli {
namespace {

using Clock = std::chrono::steady_clock;

/// Progress on stderr: one rewriting line on a terminal, a plain line now and then elsewhere.
class StatusLine {
 public:
  void show(const std::string& what) {
    const auto now = Clock::now();
    if (std::chrono::duration<double>(now - last_).count() < (terminal_ ? 0.1 : 10.0)) return;
    last_ = now;
    const std::string time = secondsText(std::chrono::duration<double>(now - start_).count());
    fmt::print(stderr, "{}{}  {}{}", terminal_ ? "\r\x1b[K" : "", time, what, terminal_ ? "" : "\n");
    std::fflush(stderr);
    shown_ = terminal_;
  }
  void clear() {
    if (shown_) fmt::print(stderr, "\r\x1b[K");
    shown_ = false;
  }

 private:
  bool terminal_ = isatty(STDERR_FILENO) == 1, shown_ = false;
  Clock::time_point start_ = Clock::now(), last_ = start_;
};

bench::Settings settingsOf(const BenchOptions& options) {
  bench::Settings settings;
  settings.kernels = options.kernels;
  settings.rounds = options.rounds;
  settings.threads = options.threads;
  settings.targets = options.targets;
  if (options.choice.driver != "none") settings.driver = subjectOptions(options.choice);
  if (options.quick) {
    settings.boxSamples = 1e6;
    settings.kernelSeconds = 0.004;
    settings.frameSeconds = 0.05;
    settings.fixedParts = 1;
    settings.kernelWhole = settings.frameWhole = 0;
  }
  return settings;
}

/// The many points of the series: a little of each, and not every slow method.
bench::Settings scalingSettings(const BenchOptions& options) {
  bench::Settings settings = settingsOf(options);
  if (options.kernels == "*") settings.kernels = "spans,hierarchical,render,driver";
  settings.targets = false;
  settings.boxSamples = 2e5;
  settings.kernelSeconds = std::min(settings.kernelSeconds, 0.02);
  settings.frameSeconds = std::min(settings.frameSeconds, 0.1);
  settings.fixedParts = 1;
  settings.kernelWhole = settings.frameWhole = 0;
  return settings;
}

Result<void> writeOutputs(const BenchOptions& options, const bench::Results& results) {
  const std::pair<const std::string*, std::string (*)(const bench::Results&)> writers[] = {
      {&options.json, benchJson}, {&options.csv, benchCsv}, {&options.svg, benchSvg}, {&options.report, benchHtml}};
  for (const auto& [path, write] : writers) {
    if (path->empty()) continue;
    if (Result<void> written = writeFile(*path, write(results)); !written) return written;
  }
  return {};
}

Result<bench::Results> measured(const BenchOptions& options, StatusLine& status) {
  bench::Results results;
  results.machine = bench::thisMachine();
  results.rounds = options.rounds;
  const Result<std::vector<BenchLoad>> loads = benchLoads(options);
  if (!loads) return tl::unexpected(loads.error());
  const Result<std::vector<bench::Task>> tasks = benchTasks(options);
  if (!tasks) return tl::unexpected(tasks.error());
  const bench::Settings settings = settingsOf(options);
  const auto progress = [&](const std::string& what) { status.show(what); };
  for (const BenchLoad& wanted : *loads) {
    status.show(fmt::format("{}: making it", wanted.name));
    const Result<bench::Load> load = wanted.make();
    if (!load) return tl::unexpected(load.error());
    Result<bench::LoadResult> result = bench::measureAll(*load, *tasks, settings, results.driver, progress);
    if (!result) return tl::unexpected(result.error());
    results.loads.push_back(std::move(*result));
  }
  if (options.scenes.empty()) results.sampling = bench::measureSampling(settings, progress);
  if (options.scaling) {
    Result<std::vector<bench::ScalingSeries>> scaling = bench::measureScaling(scalingSettings(options), results.driver, progress);
    if (!scaling) return tl::unexpected(scaling.error());
    results.scaling = std::move(*scaling);
  }
  return results;
}

/// 4 if the driver died, 1 if an exact method was wrong, else 0; and the row that says so.
std::pair<int, const bench::Row*> statusOf(const bench::Results& results) {
  std::pair<int, const bench::Row*> worst{0, nullptr};
  for (const bench::LoadResult& load : results.loads) {
    for (const bench::Row& row : load.rows) {
      const bool wrong = row.exact && row.error && row.error->wrong > 0;
      const bool died = row.refused.starts_with("the driver crashed") || row.refused.starts_with("the driver hung");
      const int status = died ? 4 : wrong ? 1 : 0;
      if (status > worst.first) worst = {status, &row};
    }
  }
  return worst;
}

}  // namespace

int runVerb(const BenchOptions& options) {
  const auto start = Clock::now();
  for (const std::string* path : {&options.json, &options.csv, &options.svg, &options.report}) {
    if (path->empty()) continue;  // one that cannot be written must not cost minutes before it is noticed
    if (const Result<void> writable = checkWritable(*path); !writable) return complain(writable.error(), "rasterdiff bench --help");
  }
  StatusLine status;
  Result<bench::Results> results = measured(options, status);
  status.clear();
  if (!results) return complain(results.error(), nextCommand(results.error(), "bench"));
  const bool anything = std::ranges::any_of(results->loads, [](const auto& load) { return !load.rows.empty(); });
  if (!anything) {
    return complain({ErrorCode::BadInput, "--kernels", fmt::format("no method is named '{}' here", options.kernels),
                     "methods: those of `rasterdiff bench --quick`, render, driver, driver-whole"}, "rasterdiff bench --help");
  }
  results->wallSeconds = std::chrono::duration<double>(Clock::now() - start).count();
  fmt::print("{}", benchText(*results));
  if (const Result<void> written = writeOutputs(options, *results); !written) return complain(written.error(), "rasterdiff bench --help");
  for (const auto& [what, path] : {std::pair{"report", &options.report}, {"plots", &options.svg}, {"results", &options.json}, {"rows", &options.csv}})
    if (!path->empty()) fmt::print("{:<9} {}\n", what, *path);
  const auto [exit, row] = statusOf(*results);
  if (exit == 0) return 0;
  std::fflush(stdout);
  fmt::print(stderr, "{}: {}\n{}\n", row->method, row->refused, exit == 4 ? "rasterdiff devices" : "rasterdiff bench --help");
  return exit;
}

}  // namespace rasterdiff::harness::cli
