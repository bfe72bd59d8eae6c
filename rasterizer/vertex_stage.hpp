// One vertex through division, viewport and snapping, with the box of places where it may legally go.
#pragma once

#include "rasterizer/geometry.hpp"
#include "rasterizer/snap.hpp"

namespace rasterdiff::rasterizer {

struct VertexStage {
  const Rules& rules;
  ViewportTransform viewport;
  uint32_t samples = 1;

  /// A vertex of the scene, inside the view volume.
  [[nodiscard]] RasterVertex original(const ClipPosition& position) const;
  /// A vertex of a cut polygon; weights come with it.
  [[nodiscard]] RasterVertex clipped(const ClipVertex& vertex) const;
};

/// Bound on the error of a float32 depth: reciprocal, product, product, sum. [vk:vertexpostproc-viewport]
[[nodiscard]] double depthErrorBound(double scaled, double offset, double result);

/// The stage of draws through viewport `index`.
[[nodiscard]] VertexStage vertexStage(const Scene& scene, const Rules& rules, uint32_t index);

}  // namespace rasterdiff::rasterizer
