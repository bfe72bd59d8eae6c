// A polygon as the triangles that a library makes of it (scene/polygon/triangulation.hpp).
#include "rasterizer/methods/polygon_methods.hpp"
#include "rasterizer/methods/triangle_pixels.hpp"
#include "scene/polygon/triangulation.hpp"

namespace rasterdiff::rasterizer {

Result<PixelMask> drawPolygonTriangulated(const Polygon& polygon, FillRule rule, int32_t width, int32_t height) {
  if (auto ok = checkPolygon(polygon, width, height); !ok) return tl::unexpected(ok.error());
  const Result<Triangulation> triangulation = triangulate(polygon, rule);
  if (!triangulation) return tl::unexpected(triangulation.error());
  PixelMask mask(width, height);
  for (const auto& triangle : triangulation->triangles) addTrianglePixels({triangle}, mask);
  return mask;
}

}  // namespace rasterdiff::rasterizer
