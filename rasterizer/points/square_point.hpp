// A point is a square around its vertex, which is not rounded; half-open, so that touching squares share no sample.
// [vk:primsrast-points]
#pragma once

#include <memory>

#include "rasterizer/shape.hpp"
#include "rasterizer/vertex_stage.hpp"

namespace rasterdiff::rasterizer {

/// `size` clamped to the device's pointSizeRange and rounded to its granularity. [vk:limits-pointSizeRange]
[[nodiscard]] float quantisedPointSize(float size, const Limits& limits);

/// The square of a point with a vertex inside the view volume. `size` in pixels, quantised.
[[nodiscard]] std::unique_ptr<Shape> makePointShape(const ClipPosition& position, const RasterVertex& vertex, float size,
                                                    const VertexStage& stage);

}  // namespace rasterdiff::rasterizer
