// The scenes of the default check, made once. Meshes are left out: they are large and add nothing that smaller scenes
// lack.
#pragma once

#include <string>
#include <vector>

#include "scene/catalogue/catalogue.hpp"

namespace rasterdiff {

struct CatalogueScene {
  std::vector<std::string> rules;
  Scene scene;
};

[[nodiscard]] inline const std::vector<CatalogueScene>& catalogueScenes() {
  static const std::vector<CatalogueScene> all = [] {
    std::vector<CatalogueScene> made;
    for (const CatalogueEntry& entry : catalogue()) {
      if (!entry.name.starts_with("mesh/")) made.push_back({entry.rules, entry.make().value()});
    }
    return made;
  }();
  return all;
}

}  // namespace rasterdiff
