// The reference: Scene in, Frame out. Links no Vulkan.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "rasterizer/freedoms.hpp"
#include "rasterizer/rule_counts.hpp"
#include "rasterizer/rules.hpp"
#include "scene/frame.hpp"
#include "scene/result.hpp"
#include "scene/scene.hpp"

namespace rasterdiff::rasterizer {

/// Says that rows [first, end) of `frame` will not change any more. Called by the thread that has drawn them, while they are in its cache.
using RowsDrawn = std::function<void(const Frame& frame, uint32_t first, uint32_t end)>;

/// Renders `scene` under `rules`. Only the planes of `needsOf(scene)` are allocated, computed or stored; value bounds
/// are there for every value plane; `coverage` only where `rules.open`. `threads`: the most that it may use, for large scenes;
/// frame and counts are the same for any number. `drawn`, if given, may be called by several threads at a time, for each row at most once:
/// scenes that are not drawn row after row may leave it out. What it is given is no longer that frame when this returns.
/// Error: an invalid scene (BadInput), or a sample count without standard locations (NotOffered).
[[nodiscard]] Result<Frame> render(const Scene& scene, const Rules& rules, RuleCounts* counts = nullptr, unsigned threads = 1,
                                   const RowsDrawn& drawn = {});

/// The same frame and counts, triangle by triangle and row by row: the definition that the kernels behind render() are held to.
[[nodiscard]] Result<Frame> renderRowByRow(const Scene& scene, const Rules& rules, RuleCounts* counts = nullptr);

struct SampleQuery {
  uint32_t x = 0, y = 0, sample = 0;
};

/// One primitive that covers, or may legally cover, a queried sample.
struct Candidate {
  uint32_t primitive = 0;  ///< 1-based, as in Frame::primitive
  Coverage coverage = Coverage::In;
  Freedom freedom = Freedom::None;  ///< why Either
  /// Exactly one of two candidates with opposite tie edges covers. [vk:primsrast-polygons-basic]
  std::optional<std::array<SubpixelPosition, 2>> tieEdge;
  Bounds depth;                     ///< legal depths before the depth test (scenes with depth)
  std::vector<Bounds> varyings;     ///< flattened over varyings and components (scenes with varyings)
};

/// For each query, every primitive that may cover it, in drawing order, decided exactly (all legal placements of the
/// three vertices are tried). Used for the samples where a driver disagrees: the evidence behind a verdict.
[[nodiscard]] Result<std::vector<std::vector<Candidate>>> candidates(const Scene& scene, const Rules& rules,
                                                                     std::span<const SampleQuery> queries);

}  // namespace rasterdiff::rasterizer
