// The scene that catches a mutant: the first of the default check's that tells it from the reference, those that name
// the mutant's rule first.
#pragma once

#include <algorithm>
#include <optional>
#include <ostream>

#include "catalogue_scenes.hpp"
#include "harness/compare/compare.hpp"
#include "rasterizer/mistakes/played_device.hpp"
#include "rasterizer/render.hpp"

namespace rasterdiff {
namespace rasterizer {

inline void PrintTo(const DeliberateErrorInfo& mutant, std::ostream* out) { *out << mutant.name; }

}  // namespace rasterizer

/// The reference with `error` in it, on the device that shows it.
[[nodiscard]] inline rasterizer::Rules referenceWith(rasterizer::DeliberateError error) {
  rasterizer::Rules rules = *rasterizer::Rules::profile("reference", rasterizer::playedDevice(error));
  rules.error = error;
  return rules;
}

struct Catch {
  const Scene* scene = nullptr;
  Frame frame;  ///< the mutant's
  harness::SceneResult result;
};

[[nodiscard]] inline std::optional<Catch> firstCatch(const rasterizer::DeliberateErrorInfo& mutant,
                                                     const rasterizer::Rules& rules) {
  for (const bool ofTheRule : {true, false}) {
    for (const CatalogueScene& entry : catalogueScenes()) {
      const bool names = std::ranges::find(entry.rules, mutant.rule) != entry.rules.end();
      if (names != ofTheRule) continue;
      const Result<Frame> expected = rasterizer::render(entry.scene, rules);
      Result<Frame> actual = rasterizer::render(entry.scene, referenceWith(mutant.error));
      if (!expected || !actual) continue;
      Result<harness::SceneResult> result = harness::compare(entry.scene, rules, *expected, *actual);
      if (!result || result->verdict != harness::Verdict::Differs) continue;
      return Catch{&entry.scene, std::move(*actual), std::move(*result)};
    }
  }
  return std::nullopt;
}

}  // namespace rasterdiff
