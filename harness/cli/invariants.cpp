// `invariants`: puts to a driver what has to hold without any reference, each invariant in a process of its own.
#include <fmt/format.h>
#include <fnmatch.h>

#include <cstdio>
#include <filesystem>

#include "harness/cli/isolated.hpp"
#include "harness/cli/message.hpp"
#include "harness/cli/rule_choice.hpp"
#include "harness/cli/run.hpp"
#include "harness/invariants/run.hpp"
#include "harness/report/json_parts.hpp"
#include "harness/report/numbers.hpp"
#include "harness/report/output.hpp"
#include "scene/file/scene_file.hpp"

namespace rasterdiff::harness::cli {
namespace {

using invariants::Invariant;

/// What the process of one invariant says; `scenes` are texts of scene files.
Json recordOf(const invariants::Outcome& outcome, const Subject& subject) {
  Json json{{"cases", outcome.cases}, {"skipped", outcome.skipped}, {"samples", outcome.samples}, {"driver", subjectLine(subject)}};
  if (!outcome.broken) return json;
  Json scenes = Json::array();
  for (const Scene& scene : outcome.scenes) scenes.push_back(writeScene(scene));
  const invariants::Broken& at = *outcome.broken;
  json["broken"] = {{"cases", outcome.brokenCases}, {"x", at.x}, {"y", at.y}, {"sample", at.sample}, {"what", at.what}};
  json["scenes"] = scenes;
  return json;
}

Result<std::string> askDriver(const Invariant& invariant, const InvariantsOptions& options) {
  const Result<std::unique_ptr<Subject>> subject = openSubject(subjectOptions(options.choice));
  if (!subject) return tl::unexpected(subject.error());
  const Result<invariants::Outcome> outcome = invariants::run(invariant, **subject, options.seed, options.count);
  if (!outcome) return tl::unexpected(outcome.error());
  return textOf(recordOf(*outcome, **subject), -1);
}

/// Writes the scenes of a broken case and replaces them by the names of their files.
Result<void> writeScenes(Json& result, const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);  // writing says what is wrong
  Json files = Json::array();
  for (const Json& scene : result.at("scenes")) {
    const std::string name = fmt::format("{}-{}.scene.json", result.at("name").get<std::string>(), files.size() + 1);
    const std::string path = (std::filesystem::path(folder) / name).string();
    if (Result<void> written = writeFile(path, scene.get<std::string>()); !written) return written;
    files.push_back(path);
  }
  result.erase("scenes");
  result["files"] = files;
  return {};
}

void print(const Invariant& invariant, const Json& result) {
  fmt::print("{:<29} {:<4} ", invariant.name, invariant.rule);
  if (result.contains("error")) {
    fmt::print("LOST: {}\n", result.at("error").get<std::string>());
  } else if (result.contains("broken")) {
    const Json& at = result.at("broken");
    fmt::print("BROKEN at ({}, {}) sample {}: {}; in {} of {} cases\n", at.at("x").get<uint32_t>(), at.at("y").get<uint32_t>(), at.at("sample").get<uint32_t>(),
               at.at("what").get<std::string>(), at.at("cases").get<uint64_t>(), result.at("cases").get<uint64_t>());
    for (const Json& file : result.at("files")) fmt::print("{:<34} {}\n", "", file.get<std::string>());
  } else {
    const uint64_t skipped = result.at("skipped");
    fmt::print("holds over {} samples in {}{}\n", grouped(result.at("samples")), counted(result.at("cases"), "case"),
               skipped > 0 ? fmt::format(" ({} not offered)", skipped) : "");
  }
  std::fflush(stdout);
}

struct Results {
  Json list = Json::array();
  std::string driver;
  size_t broken = 0, lost = 0;
};

/// Error: the driver cannot be opened, or a file cannot be written.
Result<Results> runAll(const std::vector<const Invariant*>& chosen, const InvariantsOptions& options) {
  Results results;
  for (const Invariant* invariant : chosen) {
    constexpr double kOtherSeconds = 300;  // for all cases of one invariant
    const Result<std::string> answer = isolated(kOtherSeconds + watchdogSeconds(options.choice.timeoutSeconds), [&] { return askDriver(*invariant, options); });
    Json result = {{"name", invariant->name}, {"rule", invariant->rule}, {"anchor", invariant->anchor}, {"what", invariant->what}};
    if (answer) {
      const Json told = Json::parse(*answer, nullptr, false);
      if (!told.is_object()) return fail(ErrorCode::DeviceLost, std::string(invariant->name), "the driver's process wrote nonsense");
      result.update(told);
      results.driver = result.at("driver");
      result.erase("driver");
      result["holds"] = !result.contains("broken");
      if (result.contains("scenes")) {
        if (Result<void> written = writeScenes(result, options.folder); !written) return tl::unexpected(written.error());
        ++results.broken;
      }
    } else if (exitStatusOf(answer.error().code) == 4) {
      result["error"] = answer.error().what;
      ++results.lost;
    } else {
      return tl::unexpected(answer.error());
    }
    print(*invariant, result);
    results.list.push_back(std::move(result));
  }
  return results;
}

}  // namespace

int runVerb(const InvariantsOptions& options) {
  constexpr const char* kHelp = "rasterdiff invariants --help";
  std::vector<const Invariant*> chosen;
  for (const Invariant& invariant : invariants::invariants()) {
    if (fnmatch(options.glob.c_str(), std::string(invariant.name).c_str(), 0) == 0) chosen.push_back(&invariant);
  }
  if (chosen.empty()) {
    std::string names;
    for (const Invariant& invariant : invariants::invariants()) names += fmt::format("{}{}", names.empty() ? "" : ", ", invariant.name);
    return complain({ErrorCode::BadInput, "NAME", fmt::format("no invariant is named '{}'", options.glob), names}, kHelp);
  }
  if (!options.json.empty()) {
    if (const Result<void> writable = checkWritable(options.json); !writable) return complain(writable.error(), kHelp);
  }
  const Result<Results> results = runAll(chosen, options);
  if (!results) return complain(results.error(), nextCommand(results.error(), "invariants"));
  const bool holds = results->broken + results->lost == 0;
  fmt::print("{}: {} of {} hold on {}\n", holds ? "PASS" : "FAIL", chosen.size() - results->broken - results->lost, counted(chosen.size(), "invariant"), results->driver);
  if (!options.json.empty()) {
    const Json document{{"format", "rasterdiff-invariants-1"}, {"driver", results->driver}, {"seed", options.seed}, {"count", options.count}, {"invariants", results->list}};
    if (const Result<void> written = writeFile(options.json, textOf(document)); !written) return complain(written.error(), kHelp);
  }
  if (holds) return 0;
  std::fflush(stdout);
  for (const Json& result : results->list) {
    if (result.contains("holds") && result.at("holds") == true) continue;
    fmt::print(stderr, "rasterdiff invariants {} --driver {} --seed {} --count {}\n", result.at("name").get<std::string>(), shellQuoted(options.choice.driver),
               options.seed, options.count);
    break;
  }
  return results->lost > 0 ? 4 : 1;
}

}  // namespace rasterdiff::harness::cli
