// The exact diff: every sample and every value of two frames, with a reason for each difference.
#pragma once

#include "harness/compare/row_passes.hpp"
#include "harness/compare/verdict.hpp"
#include "rasterizer/render.hpp"

namespace rasterdiff::harness {

inline constexpr size_t kListedDifferences = 16;

/// Judges `actual` (the driver's) against `reference` = rasterizer::render(scene, rules). Fills everything of the
/// result except `seconds` and `ruleCoverage`. Both frames must have been made from `scene`. The result does not depend on
/// the number of threads. `early`, if given, may have judged rows of both frames before: what it has is not looked at again, with the
/// same result.
[[nodiscard]] Result<SceneResult> compare(const Scene& scene, const rasterizer::Rules& rules, const Frame& reference,
                                          const Frame& actual, unsigned threads = 1, const RowPasses* early = nullptr);

}  // namespace rasterdiff::harness
