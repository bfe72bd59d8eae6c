#include "harness/compare/blessing.hpp"

#include <algorithm>
#include <fnmatch.h>
#include <nlohmann/json.hpp>

namespace rasterdiff::harness {
namespace {

using Json = nlohmann::json;

struct Run {
  std::string driver, version, info, rules;
};

struct Finding {
  std::string scene;
  std::vector<std::string> planes;  // empty: as it should be
  bool drawn = false, expected = false;
};

Finding findingOf(const Json& scene) {
  Finding finding;
  finding.scene = scene.at("id");
  const std::string verdict = scene.at("verdict");
  finding.drawn = verdict == "Same" || verdict == "Allowed" || verdict == "Differs";
  finding.expected = scene.value("baseline", "") == "ExpectedDiff";
  if (verdict == "Crashed") finding.planes = {"crash"};
  if (verdict != "Differs") return finding;
  if (scene.at("differing").get<uint64_t>() > 0) finding.planes.emplace_back("coverage");
  for (const auto& [name, value] : scene.at("values").items()) {
    if (value.at("differing").get<uint64_t>() > 0) finding.planes.push_back(name);
  }
  return finding;
}

bool selected(const std::string& scene, const std::vector<std::string>& globs) {
  return globs.empty() || std::ranges::any_of(globs, [&](const std::string& glob) { return fnmatch(glob.c_str(), scene.c_str(), 0) == 0; });
}

bool speaksOf(const BaselineEntry& entry, const Run& run, const std::string& scene) {
  return entry.driver == run.driver && (entry.rules.empty() || entry.rules == run.rules) &&
         run.info.starts_with(entry.version) && entry.scene == scene;
}

void apply(const Run& run, const Finding& finding, const BlessingOptions& options, Blessing& blessing) {
  std::vector<BaselineEntry>& entries = blessing.baseline.entries;
  const bool better = finding.drawn && finding.planes.empty();
  if (!better && (finding.planes.empty() || finding.expected)) return;
  const auto removed = std::ranges::remove_if(entries, [&](const BaselineEntry& e) { return speaksOf(e, run, finding.scene); });
  if (!removed.empty()) blessing.gone.push_back(finding.scene);
  entries.erase(removed.begin(), removed.end());
  if (better) return;
  entries.push_back({run.driver, run.version, run.rules, finding.scene, finding.planes, options.rule, options.anchor, options.reason, ""});
  blessing.added.push_back(finding.scene);
}

}  // namespace

Result<Blessing> bless(std::string_view results, const std::string& fileName, const Baseline& old,
                       const BlessingOptions& options) {
  try {
    const Json json = Json::parse(results);
    if (json.at("format") != "rasterdiff-results-1") throw std::invalid_argument("another format");
    Run run{json.at("driver").at("name"), "", json.at("driver").at("info"), json.at("rules")};
    run.version = run.info.substr(0, run.info.find(" ("));
    Blessing blessing;
    blessing.baseline = old;
    for (const Json& scene : json.at("scenes")) {
      const Finding finding = findingOf(scene);
      if (selected(finding.scene, options.globs)) apply(run, finding, options, blessing);
    }
    return blessing;
  } catch (const std::exception&) {
    return fail(ErrorCode::BadInput, fileName, "these are not the results of a check", "rasterdiff check --json FILE writes them");
  }
}

}  // namespace rasterdiff::harness
