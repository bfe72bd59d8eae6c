// The built-in scenes: named, findable by glob, each with the rules it exercises.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/result.hpp"
#include "scene/scene.hpp"

namespace rasterdiff {

struct CatalogueEntry {
  std::string name;                ///< "fill/shared-diagonal"
  std::string what;                ///< one sentence: what would go wrong here
  std::vector<std::string> rules;  ///< ids of docs/rules.md: "R15"
  std::string link;                ///< the real-world report it comes from, or empty
  std::function<Result<Scene>()> make;
  /// Random families: the same kind of scene from another seed, with at least so many primitives. Null for all others.
  std::function<Result<Scene>(uint64_t seed, uint32_t primitives)> remake{};
};

/// All built-in scenes in a fixed order.
[[nodiscard]] std::span<const CatalogueEntry> catalogue();

/// Entries whose name matches a shell glob (`line/*`, `fill/shared-?`). Empty if none does.
[[nodiscard]] std::vector<const CatalogueEntry*> matchCatalogue(std::string_view glob);

}  // namespace rasterdiff
