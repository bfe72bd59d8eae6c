// A triangle as it was before clipping: some devices judge its facing, or lay the planes of its values, by the projections
// of its own vertices, even of those outside of the view volume or behind the eye. [choice:cull-position]
// [choice:plane-positions]
#pragma once

#include <optional>

#include "rasterizer/vertex_stage.hpp"

namespace rasterdiff::rasterizer {

/// The vertices of a triangle, projected wherever they lie: under closed rules with SnappedUncut on the grid, else with the
/// deviation that is legal. None if some w is 0 or, in the second case, negative: there is no grid to snap to behind the eye,
/// and half a step there may be any distance here. [vk:primsrast-polygons]
[[nodiscard]] std::optional<std::array<RasterVertex, 3>> uncutVertices(const std::array<ClipPosition, 3>& clip,
                                                                       const VertexStage& stage);

/// Twice the area of the snapped vertices in grid steps (saturated to 32 bits), turned for each negative w; > 0: clockwise on the screen.
/// T: float or double, in which it is computed.
template <class T>
[[nodiscard]] T uncutDoubleArea(const std::array<ClipPosition, 3>& clip, const VertexStage& stage);

/// The same sign from clip coordinates, which are not snapped, in float32.
[[nodiscard]] float clipDeterminant(const std::array<ClipPosition, 3>& clip);

}  // namespace rasterdiff::rasterizer
