// Known differences of a driver: each names its scene, the planes that differ, the broken rule and the reason, so that
// an old bug is not an alarm, and a new one, or a mended one, is.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "harness/compare/verdict.hpp"
#include "scene/result.hpp"

namespace rasterdiff::harness {

struct BaselineEntry {
  std::string driver;               ///< driverName: "llvmpipe"
  std::string version;              ///< the start of driverInfo: "Mesa 22.3"; empty for every version
  std::string rules;                ///< rules it was judged under: "spec"; "profile": any that describe a driver; empty: all
  std::string scene;                ///< name, or a glob
  std::vector<std::string> planes;  ///< "coverage", "depth", names of varyings: these differ, and no others; "crash" alone: it crashed
  std::string rule;                 ///< "R39"
  std::string anchor;               ///< "vk:fragops-scissor"
  std::string reason;               ///< one sentence
  std::string when;                 ///< traits of any scene that shows it, for `hunt`: "multisampled scissor"; empty: not stated
};

struct Baseline {
  std::vector<BaselineEntry> entries;
};

/// May the entry explain what differs under these rules?
[[nodiscard]] bool appliesUnder(const BaselineEntry& entry, std::string_view rulesName);

/// The differences known to this project (harness/compare/known_differences.json).
[[nodiscard]] const Baseline& builtInBaseline();

/// Reads a baseline file. Error: Io or BadInput with `file:line:col` for syntax, the entry's number for content.
[[nodiscard]] Result<Baseline> loadBaseline(const std::string& path);
[[nodiscard]] Result<Baseline> parseBaseline(std::string_view text, const std::string& fileName);

/// The text of a baseline file; parseBaseline reads it back.
[[nodiscard]] std::string writeBaseline(const Baseline& baseline);

/// Sets `baseline` and `baselineReason` of a result that `driver` (name and info) gave. Under a profile from a file nothing
/// counts as mended: it may describe the difference.
void applyBaseline(const Baseline& baseline, std::string_view driverName, std::string_view driverInfo, std::string_view rulesName,
                   SceneResult& result);

/// The versions that entries of this driver name, if no such entry is of this one ("Mesa 22.3" for Mesa 25.0.7); else none.
[[nodiscard]] std::vector<std::string> otherVersions(const Baseline& baseline, std::string_view driverName, std::string_view driverInfo);

/// Does a result differ exactly as an entry says, of whatever version of the driver?
[[nodiscard]] bool differsInSomeVersion(const Baseline& baseline, std::string_view driverName, std::string_view rulesName, const SceneResult& result);

}  // namespace rasterdiff::harness
