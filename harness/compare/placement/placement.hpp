// The joint question behind a snap freedom: is there one legal placement of the vertices, the same for every primitive
// that shares them, that explains all samples at once? Enumerated exactly for a primitive (placement_table), solved by
// propagation for a mesh (placement_solver).
#pragma once

#include "harness/compare/placement/placement_answer.hpp"
#include "harness/compare/verdict.hpp"
#include "rasterizer/rules.hpp"
#include "scene/frame.hpp"
#include "scene/scene.hpp"

namespace rasterdiff::harness {

/// Asks the question for all samples where `actual` is not `reference`, under open rules; filled triangles only.
/// Error: as rasterizer::candidates.
[[nodiscard]] Result<PlacementAnswer> explainByPlacement(const Scene& scene, const rasterizer::Rules& rules,
                                                         const Frame& reference, const Frame& actual);

/// Where a result is Allowed because vertices may be elsewhere, asks the joint question and records the answer; if no
/// placement explains all samples together, the result Differs and the samples that cite such a freedom count as differing.
[[nodiscard]] Result<void> judgeJointly(const Scene& scene, const rasterizer::Rules& rules, const Frame& reference,
                                        const Frame& actual, SceneResult& result);

}  // namespace rasterdiff::harness
