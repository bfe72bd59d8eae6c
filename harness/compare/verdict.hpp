// What the comparison says of a scene, a sample, a value.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "harness/compare/placement/placement_answer.hpp"
#include "harness/compare/seconds.hpp"

namespace rasterdiff::harness {

enum class Verdict : uint8_t { Same, Allowed, Differs, Skipped, Crashed, TimedOut };
[[nodiscard]] std::string_view toString(Verdict verdict);

/// One sample where the driver's answer is not the reference's nominal one.
struct SampleDifference {
  uint32_t x = 0, y = 0, sample = 0;
  Verdict verdict = Verdict::Differs;
  std::string reason;  ///< freedom id ("tie-owner") if Allowed; what is wrong if Differs
  std::string anchor;
  uint32_t expectedPrimitive = 0, actualPrimitive = 0;
  uint32_t expectedCount = 0, actualCount = 0;
};

/// Statistics of one value plane over the samples where both sides have the same primitive.
struct ValueStats {
  std::string name;  ///< "depth" or the varying's name
  uint64_t compared = 0, same = 0, allowed = 0, differing = 0;
  double maxUlp = 0, meanUlp = 0, maxAbs = 0;
  double maxRatio = 0;  ///< largest error / (half-width of the legal interval): above 1 differs
  struct Worst {
    uint32_t x = 0, y = 0, sample = 0, component = 0;
    float expected = 0, actual = 0, lo = 0, hi = 0;
  };
  std::optional<Worst> worst;           ///< largest error in ULPs
  std::optional<Worst> firstDiffering;
};

/// How a scene's verdict stands to a baseline of known differences.
enum class BaselineStatus : uint8_t {
  None,          ///< no entry
  ExpectedDiff,  ///< differs in just the planes that the entry names
  Improved,      ///< listed, but no longer differs: the entry has to go
};
[[nodiscard]] std::string_view toString(BaselineStatus status);

struct SceneResult {
  std::string id;
  Verdict verdict = Verdict::Same;
  std::string reason;  ///< freedom ids used, or what is wrong, or why it was skipped
  uint64_t samples = 0, same = 0, allowed = 0, differing = 0;  ///< coverage: samples = same + allowed + differing
  uint64_t coveredSamples = 0;
  std::map<std::string, uint64_t> freedoms;    ///< freedom id → samples explained by it
  std::vector<SampleDifference> differences;   ///< the first ones, Differs before Allowed; counts above are complete
  std::vector<ValueStats> values;
  std::optional<PlacementAnswer> placement;  ///< where vertex positions are a freedom that the driver used
  std::map<std::string, uint64_t> ruleCoverage;  ///< rule id ("R15") → times it decided
  Seconds seconds;
  BaselineStatus baseline = BaselineStatus::None;
  std::string baselineRule;    ///< of the entry: "R39"
  std::string baselineReason;  ///< of the entry: the driver's bug in a sentence
};

/// What the ids of invariants begin with, among those of scenes; and how many random cases `check` puts to a driver.
inline constexpr std::string_view kInvariantPrefix = "invariant/";
inline constexpr uint64_t kInvariantCases = 8;

/// Planes that differ: "coverage", "depth" and names of varyings.
[[nodiscard]] std::vector<std::string> differingPlanes(const SceneResult& result);

/// A result that makes a run fail: it differs, crashed or timed out without a baseline entry for it, or improved on one.
[[nodiscard]] bool isUnexpected(const SceneResult& result);

}  // namespace rasterdiff::harness
