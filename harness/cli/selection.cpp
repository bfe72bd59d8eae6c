#include "harness/cli/selection.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <string_view>

#include "harness/cli/random_family.hpp"
#include "scene/catalogue/catalogue.hpp"
#include "scene/file/scene_file.hpp"
#include "scene/supersample.hpp"

namespace rasterdiff::harness::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* kList = "rasterdiff list";

Job jobOf(const CatalogueEntry& entry) {
  return {entry.name, entry.name, entry.what, entry.link, entry.rules, entry.make};
}

Result<Job> jobOfFile(const std::string& path) {
  Result<Scene> scene = loadScene(path);
  if (!scene) return tl::unexpected(scene.error());
  const auto kept = std::make_shared<const Scene>(std::move(*scene));
  return Job{path, path, {}, {}, {}, [kept]() -> Result<Scene> { return *kept; }};
}

Result<std::vector<Job>> jobsOfFolder(const std::string& folder) {
  std::vector<std::string> paths;
  std::error_code error;
  for (fs::recursive_directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    if (at->path().string().ends_with(".scene.json")) paths.push_back(at->path().string());
  }
  if (error) return fail(ErrorCode::Io, folder, "cannot be read: " + error.message(), kList);
  if (paths.empty()) return fail(ErrorCode::BadInput, folder, "holds no *.scene.json file", kList);
  std::sort(paths.begin(), paths.end());
  std::vector<Job> jobs;
  for (const std::string& path : paths) {
    Result<Job> job = jobOfFile(path);
    if (!job) return tl::unexpected(job.error());
    jobs.push_back(std::move(*job));
  }
  return jobs;
}

/// Length of the longest common beginning: good enough to guess what was meant.
std::string nearest(std::string_view word) {
  std::string_view best;
  size_t longest = 0;
  for (const CatalogueEntry& entry : catalogue()) {
    const auto differs = std::mismatch(word.begin(), word.end(), entry.name.begin(), entry.name.end());
    const auto common = static_cast<size_t>(differs.first - word.begin());
    if (common > longest) {
      longest = common;
      best = entry.name;
    }
  }
  return longest < 2 ? "" : fmt::format(", did you mean {}?", best);
}

Result<std::vector<Job>> jobsOfWord(const std::string& word) {
  std::error_code ignored;
  if (word.find('@') != std::string::npos && !fs::exists(word, ignored)) {
    Result<Job> batch = batchByAddress(word);
    if (!batch) return tl::unexpected(batch.error());
    return std::vector<Job>{std::move(*batch)};
  }
  if (word.ends_with(".json")) {
    Result<Job> job = jobOfFile(word);
    if (!job) return tl::unexpected(job.error());
    return std::vector<Job>{std::move(*job)};
  }
  std::vector<Job> jobs;
  for (const CatalogueEntry* entry : matchCatalogue(word)) jobs.push_back(jobOf(*entry));
  if (!jobs.empty()) return jobs;
  if (fs::is_directory(word, ignored)) return jobsOfFolder(word);
  if (fs::exists(word, ignored)) {
    return fail(ErrorCode::BadInput, word, "is no scene file: their names end in .scene.json",
                "a mesh goes into a scene file, as \"draws\": [{\"mesh\": \"FILE.obj\"}]");
  }
  return fail(ErrorCode::BadInput, "SCENE", fmt::format("no scene is named '{}'{}", word, nearest(word)), kList);
}

/// The random families of the selection become batches; every kind ("random-lines") gets the count, shared out evenly.
Result<std::vector<Job>> withBatches(std::vector<Job> jobs, const RandomCount& count) {
  const auto kindOf = [](const Job& job) { return job.id.substr(0, job.id.find('/')); };
  std::vector<const CatalogueEntry*> families;
  std::map<std::string, uint64_t> familiesOfKind;
  for (const Job& job : jobs) {
    families.push_back(randomFamily(job.id));
    if (families.back() != nullptr) ++familiesOfKind[kindOf(job)];
  }
  if (familiesOfKind.empty()) {
    return fail(ErrorCode::BadInput, "--count", "no random family is selected",
                "rasterdiff check 'random/*' --count 1000000");
  }
  constexpr uint64_t kMostJobs = 10'000'000;
  if (count.primitives / kBatchPrimitives > kMostJobs / familiesOfKind.size()) {
    return fail(ErrorCode::BadInput, "--count", fmt::format("more than {} scenes", kMostJobs),
                "use several runs with different --seed");
  }
  std::vector<Job> all;
  uint64_t number = 0;
  for (size_t i = 0; i < jobs.size(); ++i) {
    if (families[i] == nullptr) {
      all.push_back(std::move(jobs[i]));
      continue;
    }
    const uint64_t shared = familiesOfKind[kindOf(jobs[i])] * kBatchPrimitives;
    const uint64_t batches = (count.primitives + shared - 1) / shared;
    for (uint64_t b = 0; b < batches; ++b) all.push_back(batchOf(*families[i], count.seed * kMostJobs + number++));
  }
  return all;
}

}  // namespace

Result<Scene> drawable(const Job& job) {
  Result<Scene> scene = job.make();
  if (!scene) return scene;
  if (Result<void> valid = validate(*scene); !valid) return tl::unexpected(valid.error());
  return supersampled(*scene);
}

Result<std::vector<Job>> selectScenes(std::span<const std::string> words, const std::optional<RandomCount>& count) {
  const std::vector<std::string> everything{"*"};
  std::vector<Job> jobs;
  std::set<std::string> seen;
  for (const std::string& word : words.empty() ? std::span<const std::string>(everything) : words) {
    Result<std::vector<Job>> found = jobsOfWord(word);
    if (!found) return found;
    for (Job& job : *found) {
      if (seen.insert(job.address).second) jobs.push_back(std::move(job));
    }
  }
  if (count) return withBatches(std::move(jobs), *count);
  return jobs;
}

Result<Job> selectScene(const std::string& word) {
  Result<std::vector<Job>> jobs = jobsOfWord(word);
  if (!jobs) return tl::unexpected(jobs.error());
  if (jobs->size() != 1) {
    return fail(ErrorCode::BadInput, "SCENE", fmt::format("'{}' names {} scenes, this verb takes one", word, jobs->size()),
                fmt::format("rasterdiff list '{}'", word));
  }
  return std::move(jobs->front());
}

}  // namespace rasterdiff::harness::cli
