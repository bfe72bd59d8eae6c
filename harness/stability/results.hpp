// What one run of `stability` found; and its series as text, to get them out of a driver's process.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "harness/stability/measure.hpp"

namespace rasterdiff::harness::stability {

struct Results {
  std::vector<Family> families;
  std::vector<Series> series;        ///< methods first, then drivers
  std::vector<std::string> drivers;  ///< what was tested, a line each
  double wallSeconds = 0;
};

/// The series of one family, methods first.
[[nodiscard]] std::vector<const Series*> seriesOf(const Results& results, std::string_view family, bool values);

[[nodiscard]] std::string recordOf(const std::vector<Series>& series);
/// Error: BadInput for a text that recordOf did not write.
[[nodiscard]] Result<std::vector<Series>> readRecord(std::string_view text);

}  // namespace rasterdiff::harness::stability
