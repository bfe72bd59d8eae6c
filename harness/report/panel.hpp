// Many drivers over the same scenes, one row a driver: is every legal renderer let through, is every deliberate error caught?
#pragma once

#include <map>
#include <string>
#include <vector>

#include "harness/report/report.hpp"

namespace rasterdiff::harness {

/// What one driver's pass came to. Rows are added up as they come: a pass itself is much larger.
struct PanelRow {
  std::string driver, info;
  bool shouldDiffer = false;                ///< a deliberate error: it is to be caught
  std::string refusal;                      ///< why it could not be used; then nothing else is known
  uint64_t scenes = 0, samples = 0, differing = 0, values = 0, valuesDiffering = 0;
  uint64_t crashed = 0;                     ///< scenes that it crashed or hung in, was not asked about, or that could not be made
  std::vector<std::string> failing;         ///< scenes that nothing allows
  std::map<std::string, uint64_t> families; ///< of those
  double seconds = 0;

  /// A legal renderer differs somewhere, or a deliberate error nowhere.
  [[nodiscard]] bool failed() const { return !refusal.empty() || crashed > 0 || failing.empty() == shouldDiffer; }
};

[[nodiscard]] PanelRow panelRow(const Report& pass, bool shouldDiffer);

struct Panel {
  std::string drivers;      ///< as on the command line: "legal:1..100"
  std::string rules;        ///< as asked for
  std::vector<PanelRow> rows;
  double wallSeconds = 0;
};

/// 0 every row is as it should be, 1 some is not, 3 some driver could not be used, 4 some scene crashed or hung.
[[nodiscard]] int exitStatus(const Panel& panel);

/// Deliberate errors: a row each, with who catches it. Others: those that fail. Then one line that sums up.
[[nodiscard]] std::string panelText(const Panel& panel);
[[nodiscard]] std::string panelJson(const Panel& panel);

}  // namespace rasterdiff::harness
