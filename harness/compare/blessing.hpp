// From the results of a run to baseline entries: what differs today is known from now on, with the reason a person gives.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "harness/compare/baseline.hpp"

namespace rasterdiff::harness {

struct BlessingOptions {
  std::vector<std::string> globs;  ///< scenes to bless; none: all that differ
  std::string reason;              ///< one sentence, not empty
  std::string rule, anchor;        ///< "R39", "vk:fragops-scissor"; may be empty
};

struct Blessing {
  Baseline baseline;               ///< the old entries that still hold, then the new ones
  std::vector<std::string> added;  ///< names of the scenes
  std::vector<std::string> gone;   ///< scenes whose old entry had to go: they no longer differ, or in other planes
};

/// `results`: the text of a `check --json` file called `fileName`. A scene that differs and is not expected gets an entry
/// for the driver, its version (without what stands in parentheses) and the rules of that run; an old entry for the same is
/// replaced, and one whose scene was drawn without a difference goes.
/// Error: BadInput with the file's name for text that is no such file.
[[nodiscard]] Result<Blessing> bless(std::string_view results, const std::string& fileName, const Baseline& old,
                                     const BlessingOptions& options);

}  // namespace rasterdiff::harness
