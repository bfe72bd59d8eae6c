#include "harness/compare/baseline.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fnmatch.h>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "known_differences_json.hpp"
#include "rasterizer/rules.hpp"

namespace rasterdiff::harness {
namespace {

using Json = nlohmann::ordered_json;

// nlohmann reports a byte offset; people want line and column.
std::string placeOf(std::string_view text, const std::string& fileName, size_t byte) {
  const std::string_view before = text.substr(0, std::min(byte > 0 ? byte - 1 : 0, text.size()));
  const auto line = std::count(before.begin(), before.end(), '\n') + 1;
  const size_t start = before.rfind('\n');
  const size_t column = start == std::string_view::npos ? before.size() + 1 : before.size() - start;
  return fmt::format("{}:{}:{}", fileName, line, column);
}

Result<BaselineEntry> parseEntry(const Json& json, const std::string& where) {
  if (!json.is_object()) return fail(ErrorCode::BadInput, where, "an entry has to be an object");
  BaselineEntry entry;
  const std::vector<std::pair<const char*, std::string*>> texts{
      {"driver", &entry.driver}, {"version", &entry.version}, {"rules", &entry.rules}, {"scene", &entry.scene},
      {"rule", &entry.rule},     {"anchor", &entry.anchor},   {"reason", &entry.reason}, {"when", &entry.when}};
  for (const auto& [key, value] : json.items()) {
    const auto text = std::find_if(texts.begin(), texts.end(), [&](const auto& t) { return key == t.first; });
    if (text != texts.end()) {
      if (!value.is_string()) return fail(ErrorCode::BadInput, where, fmt::format("\"{}\" has to be a string", key));
      *text->second = value.get<std::string>();
    } else if (key == "planes") {
      if (!value.is_array()) return fail(ErrorCode::BadInput, where, "\"planes\" has to be a list of names");
      for (const Json& plane : value) {
        if (!plane.is_string()) return fail(ErrorCode::BadInput, where, "\"planes\" has to be a list of names");
        entry.planes.push_back(plane.get<std::string>());
      }
    } else {
      return fail(ErrorCode::BadInput, where, fmt::format("unknown field \"{}\"", key),
                  "fields: driver, version, rules, scene, planes, rule, anchor, reason, when");
    }
  }
  if (entry.driver.empty() || entry.scene.empty() || entry.planes.empty() || entry.reason.empty()) {
    return fail(ErrorCode::BadInput, where, "an entry needs driver, scene, planes and reason",
                "a difference without a reason is not known, only old");
  }
  return entry;
}

// Rules that this program does not know by name: a profile from a file.
bool isFromFile(std::string_view rulesName) {
  const auto known = rasterizer::profiles();
  return rulesName != "spec" && std::find(known.begin(), known.end(), rulesName) == known.end();
}

bool isAbout(const BaselineEntry& entry, std::string_view driverName, std::string_view rulesName, const std::string& scene) {
  return entry.driver == driverName && appliesUnder(entry, rulesName) && fnmatch(entry.scene.c_str(), scene.c_str(), 0) == 0;
}

// In these planes, and no others.
bool differsAsSaid(const BaselineEntry& entry, const SceneResult& result) {
  std::vector<std::string> expected = entry.planes, actual = differingPlanes(result);
  std::sort(expected.begin(), expected.end());
  std::sort(actual.begin(), actual.end());
  const bool crashed = result.verdict == Verdict::Crashed && expected == std::vector<std::string>{"crash"};
  return crashed || (result.verdict == Verdict::Differs && expected == actual);
}

}  // namespace

bool appliesUnder(const BaselineEntry& entry, std::string_view rulesName) {
  if (entry.rules == "profile") return rulesName == "lavapipe" || isFromFile(rulesName);
  return entry.rules.empty() || entry.rules == rulesName;
}

const Baseline& builtInBaseline() {
  static const Baseline baseline = parseBaseline(kKnownDifferencesJson, "known_differences.json").value();
  return baseline;
}

Result<Baseline> loadBaseline(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return fail(ErrorCode::Io, path, "the baseline cannot be read", "harness/compare/known_differences.json in the sources is an example");
  const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  return parseBaseline(text, path);
}

Result<Baseline> parseBaseline(std::string_view text, const std::string& fileName) {
  Json json;
  try {
    json = Json::parse(text);
  } catch (const Json::parse_error& error) {
    return fail(ErrorCode::BadInput, placeOf(text, fileName, error.byte), "not JSON", "an object with a list \"entries\"");
  } catch (const Json::out_of_range&) {
    return fail(ErrorCode::BadInput, fileName, "a number that no double holds", "entries are texts and lists of texts");
  }
  if (!json.is_object() || !json.contains("entries") || !json["entries"].is_array()) {
    return fail(ErrorCode::BadInput, fileName, "a baseline is an object with a list \"entries\"");
  }
  Baseline baseline;
  for (size_t i = 0; i < json["entries"].size(); ++i) {
    Result<BaselineEntry> entry = parseEntry(json["entries"][i], fmt::format("{}: entries[{}]", fileName, i));
    if (!entry) return tl::unexpected<Error>(entry.error());
    baseline.entries.push_back(std::move(*entry));
  }
  return baseline;
}

std::string writeBaseline(const Baseline& baseline) {
  Json entries = Json::array();
  for (const BaselineEntry& entry : baseline.entries) {
    entries.push_back({{"driver", entry.driver}, {"version", entry.version}, {"rules", entry.rules}, {"scene", entry.scene}, {"planes", entry.planes},
                       {"rule", entry.rule}, {"anchor", entry.anchor}, {"reason", entry.reason}});
    if (!entry.when.empty()) entries.back()["when"] = entry.when;
  }
  return Json{{"entries", entries}}.dump(2) + "\n";
}

void applyBaseline(const Baseline& baseline, std::string_view driverName, std::string_view driverInfo, std::string_view rulesName,
                   SceneResult& result) {
  result.baseline = BaselineStatus::None;
  result.baselineRule.clear();
  result.baselineReason.clear();
  for (const BaselineEntry& entry : baseline.entries) {
    if (!isAbout(entry, driverName, rulesName, result.id) || !driverInfo.starts_with(entry.version)) continue;
    if (result.verdict == Verdict::Same || result.verdict == Verdict::Allowed) {
      if (isFromFile(rulesName)) return;
      if (result.id.starts_with(kInvariantPrefix) || result.id.starts_with("random")) return;  // a few random cases prove nothing mended
      result.baseline = BaselineStatus::Improved;
      result.baselineRule = entry.rule;
      result.baselineReason = entry.reason;
      return;
    }
    if (!differsAsSaid(entry, result)) continue;
    result.baseline = BaselineStatus::ExpectedDiff;
    result.baselineRule = entry.rule;
    result.baselineReason = entry.reason;
    return;
  }
}

std::vector<std::string> otherVersions(const Baseline& baseline, std::string_view driverName, std::string_view driverInfo) {
  std::vector<std::string> versions;
  for (const BaselineEntry& entry : baseline.entries) {
    if (entry.driver != driverName || entry.version.empty()) continue;
    if (driverInfo.starts_with(entry.version)) return {};
    if (std::find(versions.begin(), versions.end(), entry.version) == versions.end()) versions.push_back(entry.version);
  }
  return versions;
}

bool differsInSomeVersion(const Baseline& baseline, std::string_view driverName, std::string_view rulesName, const SceneResult& result) {
  return std::any_of(baseline.entries.begin(), baseline.entries.end(), [&](const BaselineEntry& entry) {
    return isAbout(entry, driverName, rulesName, result.id) && differsAsSaid(entry, result);
  });
}

}  // namespace rasterdiff::harness
