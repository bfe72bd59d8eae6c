#include "harness/bench/measure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <memory>

#include "harness/bench/driver_process.hpp"
#include "harness/bench/statistics.hpp"

namespace rasterdiff::harness::bench {
namespace {

void refuse(Contender& contender, const Error& error) {
  for (Row& row : contender.rows) row.refused = error.what;
}

/// Two rows: what the device took, and the whole call. Error: NoDevice alone ends a run.
Result<Contender> driverContender(const Load& load, Task task, const Truth& truth, const Settings& settings,
                                  const Frame& expected, std::string& line) {
  Contender contender;
  contender.mostSeconds = settings.frameSeconds;
  contender.fixedParts = settings.fixedParts;
  contender.wholeSeconds = settings.frameWhole;
  contender.whole = load.scene.has_value();
  for (const char* method : {"driver", "driver-whole"}) {
    Row row;
    row.task = task;
    row.method = method;
    row.threads = settings.threads;
    contender.rows.push_back(row);
  }
  contender.rows[0].what = "the driver's own drawing";
  contender.rows[1].what = "the driver with upload and readback";
  Result<DriverProcess> opened =
      DriverProcess::open({&load, task, truth.triangles(), &expected, settings.threads, *settings.driver});
  if (!opened) {
    if (opened.error().code == ErrorCode::NoDevice || opened.error().code == ErrorCode::BadInput)
      return tl::unexpected(opened.error());
    refuse(contender, opened.error());
    return contender;
  }
  line = opened->line();
  const auto process = std::make_shared<DriverProcess>(std::move(*opened));
  const Result<ErrorCount> error = process->verify();
  if (!error) {
    refuse(contender, error.error());
    return contender;
  }
  for (Row& row : contender.rows) row.error = *error;
  for (Row& row : contender.rows) row.error->triangles = truth.triangles();
  const auto peak = std::make_shared<uint64_t>(0);
  contender.draw = [process, peak](size_t triangles) -> Result<std::vector<double>> {
    const Result<DriverProcess::Drawn> drawn = process->draw(triangles);
    if (!drawn) return tl::unexpected(drawn.error());
    *peak = drawn->peakBytes;
    return std::vector<double>{drawn->drawSeconds, drawn->wholeSeconds};
  };
  contender.peak = [peak](size_t) { return *peak > 0 ? std::optional<uint64_t>(*peak) : std::nullopt; };
  return contender;
}

/// A contender on its way through the rounds.
struct Runner {
  Contender contender;
  uint32_t draws = 1;  ///< a round
  std::vector<std::vector<double>> seconds;  ///< a row, a round
};

/// So many triangles that the first draw of the slowest, which looks at every sample of their boxes, takes no time.
size_t fewTriangles(const Load& load) {
  double sum = 0;
  size_t few = 0;
  while (few < std::min<size_t>(64, load.triangles.size()) && sum < 50'000) {
    const auto& v = load.triangles[few++].v;
    const auto [left, right] = std::minmax({v[0].x, v[1].x, v[2].x});
    const auto [top, bottom] = std::minmax({v[0].y, v[1].y, v[2].y});
    sum += (double{1} * right - left + kSubpixelOne) * (double{1} * bottom - top + kSubpixelOne) / (kSubpixelOne * kSubpixelOne);
  }
  return std::max<size_t>(1, few);
}

/// Draws more and more triangles until they take most of the time of a draw: what a draw costs anyway (a frame that is
/// cleared, read back) must not pass for the cost of triangles. Then goes on where all of them may be affordable.
Result<void> probe(Runner& runner, const Load& load) {
  constexpr double kHopeful = 16;  // so much less than earlier triangles may later ones cost, which those hide
  Contender& contender = runner.contender;
  const size_t all = std::max<size_t>(1, load.triangles.size());
  struct Draw {
    size_t triangles = 0;
    double seconds = 0;
  };
  Draw now{contender.whole ? all : std::min(all, fewTriangles(load)), 0}, before, enough;
  double fixed = 0;
  for (;;) {
    const Result<std::vector<double>> drawn = contender.draw(now.triangles);
    if (!drawn) return tl::unexpected(drawn.error());
    now.seconds = std::max(1e-7, drawn->back());
    if (contender.fixedParts > 0) fixed = fixed == 0 ? now.seconds : std::min(fixed, now.seconds);
    const double goal = std::max(contender.mostSeconds, contender.fixedParts * fixed);
    if (enough.triangles > 0 && now.seconds > contender.wholeSeconds) {
      now = enough;
      break;
    }
    if (now.triangles == all) break;
    double more = 4;
    if (now.seconds - fixed > goal / 2) {
      const double each = std::max(1e-10, (now.seconds - before.seconds) / static_cast<double>(now.triangles - before.triangles));
      if (now.seconds + each * static_cast<double>(all - now.triangles) > kHopeful * contender.wholeSeconds) break;
      if (enough.triangles == 0) enough = now;
      more = std::clamp(1 + (contender.wholeSeconds - now.seconds) / (each * static_cast<double>(now.triangles)), 1.5, 4.0);
    } else {
      // The first draw tells fixed cost and that of triangles together: where it was long already, little is added.
      more = std::clamp(0.75 * goal / std::max(1e-7, now.seconds - fixed), 1.5, now.seconds > contender.mostSeconds / 2 ? 2.0 : 16.0);
    }
    before = now;
    now.triangles = std::min(all, static_cast<size_t>(static_cast<double>(now.triangles) * more) + 1);
  }
  if (enough.triangles > 0 && now.triangles != all) now = enough;
  const size_t triangles = now.triangles;
  const double seconds = now.seconds;
  const double covered = coveredSamples(load, triangles);
  for (Row& row : contender.rows) row.triangles = std::min(triangles, load.triangles.size()), row.samples = covered;
  runner.draws = static_cast<uint32_t>(std::clamp(contender.mostSeconds / 2 / seconds, 1.0, 1000.0));
  const std::optional<uint64_t> peak = contender.peak(triangles);
  for (Row& row : contender.rows) row.peakBytes = peak;
  runner.seconds.resize(contender.rows.size());
  return {};
}

Result<void> round(Runner& runner, size_t triangles) {
  std::vector<double> sums(runner.seconds.size());
  for (uint32_t k = 0; k < runner.draws; ++k) {
    const Result<std::vector<double>> drawn = runner.contender.draw(triangles);
    if (!drawn) return tl::unexpected(drawn.error());
    for (size_t row = 0; row < sums.size(); ++row) sums[row] += (*drawn)[row];
  }
  for (size_t row = 0; row < sums.size(); ++row) runner.seconds[row].push_back(sums[row] / runner.draws);
  return {};
}

Result<std::vector<Contender>> contenders(const Load& load, Task task, const Truth& truth, const Settings& settings,
                                          Frame& expected, std::string& driverLine) {
  std::vector<Contender> all;
  if (task == Task::Coverage || load.scene) {
    Result<std::vector<Contender>> masks = maskContenders(load, truth, settings);
    if (!masks) return masks;
    for (Contender& mask : *masks) {
      mask.rows[0].task = task;
      all.push_back(std::move(mask));
    }
  }
  const bool driver = settings.driver && (chosen(settings, "driver") || chosen(settings, "driver-whole"));
  const bool frames = driver || chosen(settings, "render");
  if (task == Task::Coverage || !load.scene) {  // a scene's own depths and inputs are left to the reference and the driver
    Result<std::vector<Contender>> values = valueContenders(load, task, truth, settings, frames && !load.scene ? &expected : nullptr);
    if (!values) return values;
    std::ranges::move(*values, std::back_inserter(all));
  }
  if (!frames) return all;
  Result<Contender> render = renderContender(load, task, truth, settings, expected);
  if (!render) return tl::unexpected(render.error());
  if (chosen(settings, "render")) all.push_back(std::move(*render));
  if (!driver) return all;
  Result<Contender> subject = driverContender(load, task, truth, settings, expected, driverLine);
  if (!subject) return tl::unexpected(subject.error());
  all.push_back(std::move(*subject));
  return all;
}

}  // namespace

Result<std::vector<Row>> measure(const Load& load, Task task, const Settings& settings, std::string& driverLine,
                                 const Progress& progress) {
  const std::string place = fmt::format("{}, {}", load.name, toString(task));
  progress(place + ": verifying");
  const Truth truth(load, task == Task::Coverage ? settings.boxSamples : settings.boxSamples / 20);  // values cost more
  Frame expected;
  Result<std::vector<Contender>> all = contenders(load, task, truth, settings, expected, driverLine);
  if (!all) return tl::unexpected(all.error());

  std::vector<Runner> runners;
  for (Contender& contender : *all) runners.push_back({std::move(contender), 1, {}});
  const auto runs = [](const Runner& runner) { return runner.contender.rows[0].refused.empty(); };
  for (Runner& runner : runners) {
    if (!runs(runner)) continue;
    progress(fmt::format("{}: how fast is {}?", place, runner.contender.rows[0].method));
    if (const Result<void> probed = probe(runner, load); !probed) refuse(runner.contender, probed.error());
  }
  for (uint32_t r = 0; r < settings.rounds; ++r) {
    for (Runner& runner : runners) {
      if (!runs(runner)) continue;
      progress(fmt::format("{}: round {} of {}, {}", place, r + 1, settings.rounds, runner.contender.rows[0].method));
      const Result<void> done = round(runner, std::max<size_t>(1, runner.contender.rows[0].triangles));
      if (!done) refuse(runner.contender, done.error());
    }
  }
  std::vector<Row> rows;
  for (Runner& runner : runners) {
    for (size_t i = 0; i < runner.contender.rows.size(); ++i) {
      Row& row = runner.contender.rows[i];
      if (row.refused.empty() && median(runner.seconds[i]) > 0) row.timing = timingOf(runner.seconds[i], runner.draws);
      if (row.timing || !row.refused.empty()) rows.push_back(std::move(row));
    }
  }
  return rows;
}

Result<LoadResult> measureAll(const Load& load, const std::vector<Task>& tasks, const Settings& settings,
                              std::string& driverLine, const Progress& progress) {
  LoadResult result{load.name, load.what, load.width, load.height, load.samples, load.triangles.size(),
                    coveredSamples(load, load.triangles.size()), load.note, {}};
  for (const Task task : tasksOf(load)) {
    if (std::ranges::find(tasks, task) == tasks.end()) continue;
    Result<std::vector<Row>> rows = measure(load, task, settings, driverLine, progress);
    if (!rows) return tl::unexpected(rows.error());
    result.rows.insert(result.rows.end(), std::make_move_iterator(rows->begin()), std::make_move_iterator(rows->end()));
  }
  return result;
}

}  // namespace rasterdiff::harness::bench
