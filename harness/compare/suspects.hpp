// What could be wrong with a driver: every known mistake is tried out on the reference, and those that give the driver's
// answer are named, with the rules that they break.
#pragma once

#include <string_view>
#include <vector>

#include "harness/compare/verdict.hpp"
#include "rasterizer/render.hpp"

namespace rasterdiff::harness {

/// The frame `reference` with the answer of `actual` at one sample: its comparison is about that sample alone.
[[nodiscard]] Frame withOneSampleOf(const Frame& reference, const Frame& actual, const rasterizer::SampleQuery& query);

/// A deliberate error of the reference that leaves nothing to explain at the sample.
struct Suspect {
  std::string_view mutant, rule, what;
  uint64_t left = 0;  ///< samples and values of the whole scene that it leaves unexplained
};

struct Suspicion {
  uint64_t differing = 0;         ///< samples and values of the whole scene that nothing allows
  std::vector<Suspect> suspects;  ///< those that leave the least, and equally little
  size_t tried = 0;
};

/// Tries the mistakes that break one of `ruleIds`, all of them if none of these fits. Renders the scene once for each.
/// Error: what render and compare say of the scene.
[[nodiscard]] Result<Suspicion> suspicionOf(const Scene& scene, const rasterizer::Rules& rules, const Frame& actual,
                                            const rasterizer::SampleQuery& query, const std::vector<std::string_view>& ruleIds);

}  // namespace rasterdiff::harness
