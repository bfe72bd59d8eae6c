#include "harness/bench/scaling.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "harness/bench/machine.hpp"

namespace rasterdiff::harness::bench {
namespace {

/// What is drawn at one point of a series.
struct Recipe {
  double x = 0;
  size_t triangles = 100'000;
  double area = 100;  // pixels
  uint32_t width = 1920, height = 1080, samples = 1;
  unsigned threads = 1;
};

Result<void> measurePoint(const Recipe& recipe, Settings settings, std::string& driverLine, const Progress& progress,
                          ScalingSeries& series) {
  settings.threads = recipe.threads;
  Result<rasterdiff::bench::Workload> workload = rasterdiff::bench::randomTriangles(
      fmt::format("{} {:.0f}", series.name, recipe.x), recipe.triangles, recipe.area, recipe.width, recipe.height);
  if (!workload) return tl::unexpected(workload.error());
  const Load load = loadOf(std::move(*workload), recipe.samples);
  Result<std::vector<Row>> rows = measure(load, Task::Coverage, settings, driverLine, progress);
  if (!rows) return tl::unexpected(rows.error());
  for (Row& row : *rows) {
    if (row.method == "driver-whole" || row.threads != recipe.threads) continue;
    series.points.push_back({recipe.x, std::move(row)});
  }
  return {};
}

struct Plan {
  ScalingSeries series;
  std::vector<Recipe> recipes;
};

std::vector<Plan> plans() {
  std::vector<Plan> all;
  Plan size{{"triangle size", "pixels a triangle", "the cost of a sample falls to what filling takes", true, {}}, {}};
  for (const double area : {1.0, 10.0, 100.0, 1e3, 1e4, 1e5}) {
    Recipe recipe{area};
    recipe.area = area;
    recipe.triangles = static_cast<size_t>(std::clamp(5e7 / area, 500.0, 1e6));
    size.recipes.push_back(recipe);
  }
  all.push_back(std::move(size));
  Plan count{{"triangle count", "triangles", "10 pixels each: the cost of a triangle stays", false, {}}, {}};
  for (const size_t triangles : {size_t{1'000}, size_t{10'000}, size_t{100'000}, size_t{1'000'000}})
    count.recipes.push_back({static_cast<double>(triangles), triangles, 10});
  all.push_back(std::move(count));
  Plan target{{"target size", "pixels a side", "100 pixels each: the cost of a triangle stays", false, {}}, {}};
  for (const uint32_t side : {256U, 512U, 1024U, 2048U, 4096U}) target.recipes.push_back({static_cast<double>(side), 100'000, 100, side, side});
  all.push_back(std::move(target));
  Plan samples{{"samples", "samples a pixel", "100 pixels each: the cost of a sample does not rise", true, {}}, {}};
  for (const uint32_t n : {1U, 2U, 4U, 8U, 16U}) samples.recipes.push_back({static_cast<double>(n), 100'000, 100, 1920, 1080, n});
  all.push_back(std::move(samples));
  Plan threads{{"threads", "threads", "100 pixels each: the cost of a triangle falls", false, {}}, {}};
  const unsigned cores = thisMachine().cores;
  for (unsigned n = 1; n <= cores; n *= 2) threads.recipes.push_back({static_cast<double>(n), 1'000'000, 100, 1920, 1080, 1, n});
  all.push_back(std::move(threads));
  return all;
}

}  // namespace

Result<std::vector<ScalingSeries>> measureScaling(const Settings& settings, std::string& driverLine, const Progress& progress) {
  std::vector<ScalingSeries> all;
  for (Plan& plan : plans()) {
    for (const Recipe& recipe : plan.recipes)
      if (const Result<void> done = measurePoint(recipe, settings, driverLine, progress, plan.series); !done)
        return tl::unexpected(done.error());
    all.push_back(std::move(plan.series));
  }
  return all;
}

}  // namespace rasterdiff::harness::bench
