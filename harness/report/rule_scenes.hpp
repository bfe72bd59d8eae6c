// Which scenes of the catalogue exercise which rule.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "scene/catalogue/catalogue.hpp"

namespace rasterdiff::harness {

struct RuleScenes {
  std::string id;            ///< "R15"
  std::string name, anchor;  ///< empty for rules that nothing counts
  std::vector<const CatalogueEntry*> scenes;
};

/// Every rule that a scene names or that is counted, by number.
[[nodiscard]] std::vector<RuleScenes> ruleScenes(std::span<const CatalogueEntry* const> entries);

/// 15 of "R15"; 0 if there is no number.
[[nodiscard]] int ruleNumber(std::string_view id);

}  // namespace rasterdiff::harness
