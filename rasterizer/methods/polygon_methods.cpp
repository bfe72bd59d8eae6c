#include "rasterizer/methods/polygon_methods.hpp"

namespace rasterdiff::rasterizer {

std::span<const PolygonMethod> polygonMethods() {
  static constexpr PolygonMethod kMethods[] = {
      {"scanline", "edge table, integer crossings", drawPolygonScanline},
      {"scanline-float", "edge crossings in float32", drawPolygonScanlineFloat},
      {"convex-fan", "triangles around the first vertex", drawPolygonFan},
      {"triangulation", "triangles from a library's tessellator", drawPolygonTriangulated},
  };
  return kMethods;
}

}  // namespace rasterdiff::rasterizer
