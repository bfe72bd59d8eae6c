// What a hunt says at its end: text for people, JSON for programs. Plain data; nothing is decided here.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "harness/hunt/campaign.hpp"
#include "harness/report/report.hpp"

namespace rasterdiff::harness::hunt {

/// A finding with the files that were written of it; empty paths: none were.
struct Written {
  const Finding* finding = nullptr;
  std::string file, picture;
};

struct HuntReport {
  RunSubject subject;
  std::string family;
  uint64_t seed = 1;
  Tally tally;
  size_t kept = 0, pairs = 0;
  std::vector<Written> findings;  ///< those that nobody knows, then the known ones
  std::string stopped;            ///< why the search ended early, or empty
  double seconds = 0;
};

/// "coverage-extra-points-multisampled": the stem of the finding's files.
[[nodiscard]] std::string fileStem(const Finding& finding);

/// 0 nothing new, 1 something was found, 4 the driver crashed or hung.
[[nodiscard]] int exitStatus(const HuntReport& report);

/// The command that repeats a finding, and the one that explains its sample (empty for crashes).
[[nodiscard]] std::string checkCommand(const HuntReport& report, const Written& written);
[[nodiscard]] std::string explainCommand(const HuntReport& report, const Written& written);

[[nodiscard]] std::string huntText(const HuntReport& report, bool listKnown);
[[nodiscard]] std::string huntJson(const HuntReport& report);

}  // namespace rasterdiff::harness::hunt
