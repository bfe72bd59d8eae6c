// What one run of `check` found, for every writer: terminal, JSON, JUnit, HTML. Plain data; nothing is decided here.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "harness/compare/verdict.hpp"
#include "scene/limits.hpp"
#include "scene/result.hpp"

namespace rasterdiff::harness {

/// Which driver was tested, and under which rules.
struct RunSubject {
  std::string driver;  ///< as on the command line, to be typed again
  std::string name, info;
  std::string line;          ///< both and the device, for people
  std::vector<std::pair<std::string, std::string>> details;  ///< device name, API version, manifest
  Limits limits;
  std::string rules;       ///< "specification" or the profile's name
  bool rulesOpen = false;  ///< the specification's choices are open
};

/// PNG files, ready to be embedded. Empty: no picture.
struct Pictures {
  std::string reference, driver, difference;
  std::string thumbnail;
  std::string closeUp;             ///< SVG text; empty where nothing differs
  uint32_t width = 0, height = 0;  ///< of the first three, pixels
};

struct SceneEntry {
  SceneResult result;
  std::string what;                ///< one sentence, or empty
  std::string link;                ///< the report it comes from, or empty
  std::vector<std::string> rules;  ///< ids of the rules it exercises
  uint32_t width = 0, height = 0, samplesPerPixel = 0;
  uint64_t primitives = 0;  ///< assembled, before clipping and culling
  uint64_t batches = 1;     ///< scenes that were added up into this entry
  std::string address;      ///< how the command line names the scene of `differences`
  std::map<std::string, std::string> worstAt;  ///< value name → address of its worst place, where it is another batch
  Pictures pictures;
  std::vector<std::string> validationMessages;
  std::optional<Error> error;  ///< the scene could not be made: no verdict
};

struct Report {
  RunSubject subject;
  std::string rulesOption;  ///< the rules as they were asked for: a name or a file; empty where the driver's own were
  std::vector<SceneEntry> scenes;
  std::string stopped;  ///< why scenes were left out, or empty
  uint64_t notRun = 0;  ///< scenes left out after `stopped`
  unsigned workers = 1;
  double wallSeconds = 0;
};

/// Sums over some entries; those with an error count only as `errors`.
struct Totals {
  uint64_t scenes = 0, scenesSame = 0, scenesAllowed = 0, scenesDiffer = 0, skipped = 0, crashed = 0, timedOut = 0;
  uint64_t errors = 0, validationMessages = 0;
  uint64_t unexpected = 0, expected = 0, improved = 0;  ///< scenes, against the baseline
  uint64_t primitives = 0;
  uint64_t samples = 0, same = 0, allowed = 0, differing = 0, coveredSamples = 0;
  uint64_t values = 0, valuesSame = 0, valuesAllowed = 0, valuesDiffering = 0;
  double maxUlp = 0, maxRatio = 0;
  std::map<std::string, uint64_t> freedoms, ruleCoverage;
  std::map<PlacementAnswer::State, uint64_t> placements;  ///< scenes whose vertices had to be placed jointly
  std::map<std::string, ValueStats> byValue;  ///< "depth", each varying's name
  std::map<std::string, std::string> worstAt;  ///< value name → address of the scene of `byValue[...].worst`
  Seconds seconds;
};

[[nodiscard]] Totals totalsOf(std::span<const SceneEntry> entries);

/// "fill" of "fill/shared-diagonal"; "files" for scene files.
[[nodiscard]] std::string familyOf(const SceneEntry& entry);

/// Totals by family, in the order of first appearance.
[[nodiscard]] std::vector<std::pair<std::string, Totals>> totalsByFamily(std::span<const SceneEntry> entries);

/// Adds a batch to the entry of its family: counts are summed, the listed differences stay those of the first batch
/// that had any, of the worse verdict.
void addBatch(SceneEntry& sum, SceneEntry batch);

/// 0 = nothing unexpected, 1 = a difference, a stale baseline entry or a validation message, 2 = a scene could not be made, 3 = nothing could
/// be compared, 4 = the driver crashed or hung.
[[nodiscard]] int exitStatus(const Report& report);

/// One line: PASS or FAIL and the numbers behind it.
[[nodiscard]] std::string verdictLine(const Report& report);

/// The command that explains the first differing sample of an entry, or repeats its crash; empty if there is nothing to
/// explain.
[[nodiscard]] std::string explainCommand(const Report& report, const SceneEntry& entry);

/// What to type after a run that failed; empty after one that did not.
[[nodiscard]] std::string nextCommand(const Report& report);

/// Entries in the order in which they want to be read: crashes, hangs, errors, Differs, what the baseline
/// expects to differ or does not, Skipped, Allowed, Same.
[[nodiscard]] std::vector<const SceneEntry*> worstFirst(const Report& report);

/// The entry makes the run fail: an error, a difference or a crash that nobody expects, a stale baseline entry, a validation message.
[[nodiscard]] bool hasFailed(const SceneEntry& entry);

/// "Same", "Differs", …, or "Error" for an entry without a verdict.
[[nodiscard]] std::string_view verdictName(const SceneEntry& entry);

}  // namespace rasterdiff::harness
