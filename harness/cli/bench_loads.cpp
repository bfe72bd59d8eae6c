#include "harness/cli/bench_loads.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <memory>
#include <optional>
#include <sstream>

#include "harness/cli/selection.hpp"
#include "scene/mesh/obj.hpp"
#include "scene/sample_locations.hpp"

namespace rasterdiff::harness::cli {
namespace {

struct Size {
  uint32_t width = 0, height = 0;
};

std::vector<std::string> listed(const std::string& text) {
  std::vector<std::string> parts;
  std::istringstream in(text);
  for (std::string part; std::getline(in, part, ',');) parts.push_back(part);
  return parts;
}

std::optional<uint32_t> wholeNumber(std::string_view text) {
  uint32_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return number;
}

/// "4096" or "1920x1080".
Result<Size> sizeOf(const std::string& text) {
  const size_t x = text.find('x');
  const auto width = wholeNumber(text.substr(0, x));
  const auto height = x == std::string::npos ? width : wholeNumber(text.substr(x + 1));
  if (!width || !height || *width == 0 || *height == 0 || *width > kMaxTargetExtent || *height > kMaxTargetExtent)
    return fail(ErrorCode::BadInput, "--size", fmt::format("'{}' is no size", text), "as in 1920x1080 or 4096");
  return Size{*width, *height};
}

Result<uint32_t> samplesOf(const std::string& text) {
  const auto samples = wholeNumber(text);
  if (!samples || standardSampleLocations(*samples).empty())
    return fail(ErrorCode::BadInput, "--samples", fmt::format("'{}' is no number of samples", text), "1, 2, 4, 8 or 16");
  return *samples;
}

Result<std::vector<std::string>> workloadNames(const BenchOptions& options) {
  const char* usual = options.quick ? "W1,W2,W4b" : "W1,W2,W3,W4a,W4b,W5";
  std::vector<std::string> names = listed(options.workloads.empty() ? usual : options.workloads);
  const auto known = rasterdiff::bench::builtInNames();
  for (const std::string& name : names) {
    if (std::ranges::find(known, name) == known.end()) {
      return fail(ErrorCode::BadInput, "--workload", fmt::format("there is no workload '{}'", name),
                  fmt::format("one of {}", fmt::join(known, ", ")));
    }
  }
  return names;
}

Result<std::vector<BenchLoad>> scenes(const BenchOptions& options) {
  const Result<std::vector<Job>> jobs = selectScenes(options.scenes, std::nullopt);
  if (!jobs) return tl::unexpected(jobs.error());
  std::vector<BenchLoad> loads;
  for (const Job& job : *jobs) {
    loads.push_back({job.id, [job]() -> Result<bench::Load> {
                       const Result<Scene> scene = drawable(job);
                       if (!scene) return tl::unexpected(scene.error());
                       bench::Load load = bench::loadOf(*scene);
                       load.name = job.id;
                       return load;
                     }});
  }
  return loads;
}

}  // namespace

Result<std::vector<BenchLoad>> benchLoads(const BenchOptions& options) {
  if (!options.scenes.empty()) return scenes(options);
  const Result<std::vector<std::string>> names = workloadNames(options);
  if (!names) return tl::unexpected(names.error());
  std::vector<BenchLoad> loads;
  for (const std::string& sizeText : listed(options.size)) {
    const Result<Size> size = sizeOf(sizeText);
    if (!size) return tl::unexpected(size.error());
    for (const std::string& samplesText : listed(options.samples)) {
      const Result<uint32_t> samples = samplesOf(samplesText);
      if (!samples) return tl::unexpected(samples.error());
      for (const std::string& name : *names) {
        loads.push_back({name, [name, size = *size, samples = *samples]() -> Result<bench::Load> {
                           Result<std::string> mesh = name.starts_with("W4") ? findBunny() : Result<std::string>("");
                           if (!mesh) return tl::unexpected(mesh.error());
                           auto load = rasterdiff::bench::builtInWorkload(name, *mesh, 1, size.width, size.height);
                           if (!load) return tl::unexpected(load.error());
                           return bench::loadOf(std::move(*load), samples);
                         }});
      }
    }
  }
  if (loads.empty()) return fail(ErrorCode::BadInput, "--size", "no size or no number of samples is given", "as in --size 1920x1080 --samples 1,4");
  return loads;
}

Result<std::vector<bench::Task>> benchTasks(const BenchOptions& options) {
  std::vector<bench::Task> tasks;
  for (const std::string& name : listed(options.tasks)) {
    bool known = false;
    for (const bench::Task task : {bench::Task::Coverage, bench::Task::Depth, bench::Task::Varyings}) {
      if (name != bench::toString(task)) continue;
      tasks.push_back(task);
      known = true;
    }
    if (!known) return fail(ErrorCode::BadInput, "--tasks", fmt::format("there is no task '{}'", name), "coverage, depth, varyings");
  }
  return tasks;
}

}  // namespace rasterdiff::harness::cli
