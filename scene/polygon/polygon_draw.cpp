#include "scene/polygon/polygon_draw.hpp"

#include "scene/camera/screen.hpp"
#include "scene/polygon/triangulation.hpp"

namespace rasterdiff {

Result<Draw> polygonDraw(std::span<const SvgPolygon> polygons, const Viewport& viewport, double z,
                         std::span<const Varying> varyings) {
  constexpr double kUnit = 1.0 / kSubpixelOne;  // pixels
  Draw draw;
  draw.varyings.assign(varyings.begin(), varyings.end());
  for (Varying& varying : draw.varyings) varying.components = 2;
  for (const SvgPolygon& polygon : polygons) {
    const Result<Triangulation> parts = triangulate(polygon.polygon, polygon.fillRule);
    if (!parts) return tl::unexpected(parts.error());
    for (const std::array<SubpixelPosition, 3>& triangle : parts->triangles) {
      for (const SubpixelPosition v : triangle) {
        const double x = v.x * kUnit, y = v.y * kUnit;
        draw.positions.push_back(clipFromPixels(viewport, {x, y, z, 1}));
        for (Varying& varying : draw.varyings) {
          varying.values.push_back(static_cast<float>(x));
          varying.values.push_back(static_cast<float>(y));
        }
      }
    }
  }
  if (draw.positions.empty()) {
    return fail(ErrorCode::BadInput, "polygon", "no polygon covers any area", "give three points that are not in line");
  }
  return draw;
}

}  // namespace rasterdiff
