// `<polygon points="...">` elements out of SVG text, on the subpixel grid, and as a scene that both renderers draw.
// Styling, groups, style sheets and all other elements are left to real SVG programs.
#pragma once

#include <span>
#include <string_view>

#include "rasterizer/methods/polygon.hpp"
#include "rasterizer/methods/svg_points.hpp"
#include "scene/scene.hpp"

namespace rasterdiff::rasterizer {

struct SvgPolygon {
  Polygon polygon;                        ///< user units taken as pixels, rounded to 1/256, ties to even
  FillRule fillRule = FillRule::NonZero;  ///< attribute fill-rule; SVG's initial value
  friend bool operator==(const SvgPolygon&, const SvgPolygon&) = default;
};

/// Rounds points to the grid. Error: BadInput for fewer than three, or one beyond kMaxPolygonCoordinate.
[[nodiscard]] Result<Polygon> polygonFromPoints(std::span<const SvgPoint> points);

/// All polygon elements of an SVG document or fragment, in order. Error: BadInput, `where` "svg:line:column", for
/// broken markup, an element without points, bad points, an unknown fill-rule, and for `transform` or `viewBox`
/// attributes anywhere, which would move the picture (user units must be pixels).
[[nodiscard]] Result<std::vector<SvgPolygon>> parseSvgPolygons(std::string_view svg);

/// One draw of triangles a polygon, in pixels, z = ½, w = 1, on a target of `width` × `height` pixels. A polygon that
/// crosses itself off the grid gets its crossings rounded to the grid (see Triangulation).
/// Error: BadInput if there is no polygon, one covers no area, or the scene does not validate.
[[nodiscard]] Result<Scene> polygonScene(std::span<const SvgPolygon> polygons, uint32_t width, uint32_t height,
                                         uint32_t samples = 1);

}  // namespace rasterdiff::rasterizer
