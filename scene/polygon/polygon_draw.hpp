// Polygons as a draw: the triangles that fill them, in pixels of a viewport.
#pragma once

#include <array>
#include <span>
#include <string_view>

#include "scene/polygon/svg_polygon.hpp"
#include "scene/scene.hpp"

namespace rasterdiff {

/// What a polygon can hand to the fragment shader, by varying name.
inline constexpr std::array<std::string_view, 1> kPolygonVaryings{"position"};

/// A draw for TRIANGLE_LIST of the polygons' triangles, one polygon after the other; those without area add none. `z` is
/// the depth before the viewport's depth range. Each of `varyings` is asked for by name and interpolation; its two
/// components are x and y in pixels. A polygon that crosses itself off the grid gets its crossings rounded to the grid
/// (see Triangulation). Error: BadInput as triangulate(), or if no polygon covers any area.
[[nodiscard]] Result<Draw> polygonDraw(std::span<const SvgPolygon> polygons, const Viewport& viewport, double z,
                                       std::span<const Varying> varyings);

}  // namespace rasterdiff
