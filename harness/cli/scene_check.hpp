// One scene through the whole line: make, draw with the driver, draw with the reference, compare, picture, dump.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string_view>

#include "harness/cli/selection.hpp"
#include "harness/report/report.hpp"
#include "harness/subject.hpp"
#include "rasterizer/rules.hpp"

namespace rasterdiff::harness::cli {

struct CheckSettings {
  bool pictures = false;
  std::optional<std::filesystem::path> dump;  ///< folder for both sides' planes
  uint32_t rounds = 1;                        ///< draws and comparisons of each scene, whose median times are told
  unsigned threads = 1;                       ///< of the reference and of the comparison
};

struct CheckedScene {
  SceneEntry entry;          ///< with an error instead of a verdict if the scene could not be made
  bool subjectLost = false;  ///< the driver is beyond use
};

/// `entering` is told each phase: "scene", kDriverPhase, "reference", "compare", "report".
[[nodiscard]] CheckedScene checkScene(const Job& job, Subject& subject, const rasterizer::Rules& rules,
                                      const CheckSettings& settings,
                                      const std::function<void(std::string_view)>& entering);

/// An entry with what is known before anything is drawn.
[[nodiscard]] SceneEntry entryOf(const Job& job);

}  // namespace rasterdiff::harness::cli
