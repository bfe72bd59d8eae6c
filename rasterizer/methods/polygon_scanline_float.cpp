// Scanline filling as the lecture words it, with crossings in float32; made to be measured, not to be used.
#include <algorithm>
#include <utility>

#include "rasterizer/methods/polygon_methods.hpp"

namespace rasterdiff::rasterizer {

Result<PixelMask> drawPolygonScanlineFloat(const Polygon& polygon, FillRule rule, int32_t width, int32_t height) {
  if (auto ok = checkPolygon(polygon, width, height); !ok) return tl::unexpected(ok.error());
  PixelMask mask(width, height);
  constexpr float kUnit = 1.0f / kSubpixelOne;
  std::vector<std::pair<float, int32_t>> crossings;
  for (int32_t row = 0; row < height; ++row) {
    const float y = static_cast<float>(row) + 0.5f;
    crossings.clear();
    SubpixelPosition previous = polygon.vertices.back();
    for (const SubpixelPosition vertex : polygon.vertices) {
      const float ax = static_cast<float>(previous.x) * kUnit, ay = static_cast<float>(previous.y) * kUnit;
      const float bx = static_cast<float>(vertex.x) * kUnit, by = static_cast<float>(vertex.y) * kUnit;
      previous = vertex;
      if ((ay <= y && y < by) || (by <= y && y < ay)) {
        const float slope = (bx - ax) / (by - ay);
        crossings.emplace_back(ax + slope * (y - ay), ay < by ? -1 : 1);
      }
    }
    std::sort(crossings.begin(), crossings.end());
    int32_t winding = 0;
    size_t next = 0;
    for (int32_t column = 0; column < width; ++column) {
      while (next < crossings.size() && crossings[next].first <= static_cast<float>(column) + 0.5f) {
        winding += crossings[next++].second;
      }
      mask.at(column, row) = isInside(winding, rule) ? 1 : 0;
    }
  }
  return mask;
}

}  // namespace rasterdiff::rasterizer
