// Ways to fill a polygon, by name: two scanline algorithms, the fan and a library's triangulation.
#pragma once

#include <span>
#include <string_view>

#include "rasterizer/methods/polygon.hpp"

namespace rasterdiff::rasterizer {

/// Scanline with an edge table: every edge enters the active list at its first row of pixel centres and carries its
/// crossing from row to row as an integer quotient and remainder; between sorted crossings the winding number is
/// constant. Exact for every polygon. Source: lecture "Scan Conversion"; exact increments as in Bresenham 1965.
[[nodiscard]] Result<PixelMask> drawPolygonScanline(const Polygon& polygon, FillRule rule, int32_t width,
                                                    int32_t height);

/// The same with crossings in float32, a pixel filled where its centre is between two of them: what the lecture's text
/// gives when it is typed in as it stands. Wrong near and on edges.
[[nodiscard]] Result<PixelMask> drawPolygonScanlineFloat(const Polygon& polygon, FillRule rule, int32_t width,
                                                         int32_t height);

/// Triangles (v0, vi, vi+1), each by integer edge functions with top-left ties; the union is filled. Exact for convex
/// polygons; a concave one is filled beyond its border. `rule` is not looked at.
[[nodiscard]] Result<PixelMask> drawPolygonFan(const Polygon& polygon, FillRule rule, int32_t width, int32_t height);

/// The triangles of scene/polygon/triangulation.hpp, each as in the fan.
[[nodiscard]] Result<PixelMask> drawPolygonTriangulated(const Polygon& polygon, FillRule rule, int32_t width,
                                                        int32_t height);

struct PolygonMethod {
  std::string_view name, what;
  Result<PixelMask> (*draw)(const Polygon&, FillRule, int32_t width, int32_t height);
};

/// "scanline", "scanline-float", "convex-fan", "triangulation".
[[nodiscard]] std::span<const PolygonMethod> polygonMethods();

}  // namespace rasterdiff::rasterizer
