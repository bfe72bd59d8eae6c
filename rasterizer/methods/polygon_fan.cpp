// A polygon as a fan of triangles around its first vertex: right for convex polygons only.
#include "rasterizer/methods/polygon_methods.hpp"
#include "rasterizer/methods/triangle_pixels.hpp"

namespace rasterdiff::rasterizer {

Result<PixelMask> drawPolygonFan(const Polygon& polygon, FillRule, int32_t width, int32_t height) {
  if (auto ok = checkPolygon(polygon, width, height); !ok) return tl::unexpected(ok.error());
  PixelMask mask(width, height);
  const std::vector<SubpixelPosition>& v = polygon.vertices;
  for (size_t i = 2; i < v.size(); ++i) addTrianglePixels({{v[0], v[i - 1], v[i]}}, mask);
  return mask;
}

}  // namespace rasterdiff::rasterizer
