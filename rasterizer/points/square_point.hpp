// A point is a square around its vertex, which is not rounded; half-open, so that touching squares share no sample.
// [vk:primsrast-points]
#pragma once

#include <memory>

#include "rasterizer/lines/line_style.hpp"
#include "rasterizer/shape.hpp"
#include "rasterizer/vertex_stage.hpp"

namespace rasterdiff::rasterizer {

/// Sizes that a device may draw when `size` pixels are asked for: clamped to its pointSizeRange, the nearest advertised
/// size, or any size that is no farther from the requested one. [vk:limits-pointSizeRange] [vk:limits-pointSizeGranularity]
struct PointSize {
  float requested = 1;  ///< clamped, not rounded
  float nominal = 1, smallest = 1, largest = 1;

  [[nodiscard]] bool isFree() const { return smallest < largest; }
  /// Some rules draw any size, whatever is advertised.
  [[nodiscard]] float drawn(PointArithmetic arithmetic) const;
};
[[nodiscard]] PointSize pointSize(float size, const Limits& limits);

/// The square of a point with a vertex inside the view volume.
/// `centre`: the vertex in float32 framebuffer coordinates, for PointArithmetic::SnappedCentre.
[[nodiscard]] std::unique_ptr<Shape> makePointShape(const ClipPosition& position, const RasterVertex& vertex, FloatPosition centre,
                                                    const PointSize& size, const VertexStage& stage);

}  // namespace rasterdiff::rasterizer
