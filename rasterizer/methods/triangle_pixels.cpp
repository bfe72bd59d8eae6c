#include "rasterizer/methods/triangle_pixels.hpp"

#include <algorithm>
#include <array>

#include "rasterizer/row_span.hpp"

namespace rasterdiff::rasterizer {

void addTrianglePixels(const SnappedTriangle& triangle, PixelMask& mask) {
  SubpixelPosition a = triangle.v[0], b = triangle.v[1], c = triangle.v[2];
  const int64_t area = doubleArea(a, b, c);
  if (area == 0) return;
  if (area < 0) std::swap(b, c);
  const std::array edges = {edgeFunction(a, b, TieOwner::TopLeft), edgeFunction(b, c, TieOwner::TopLeft),
                            edgeFunction(c, a, TieOwner::TopLeft)};
  const auto [top, bottom] = std::minmax({a.y, b.y, c.y});
  const int32_t begin = std::max(0, top >> kSubpixelBits);
  const int32_t end = std::min(mask.height, (bottom >> kSubpixelBits) + 1);
  constexpr int64_t kCentre = kSubpixelOne / 2;
  for (int32_t y = begin; y < end; ++y) {
    const RowSpan span = coverRow(edges, kCentre, int64_t{y} * kSubpixelOne + kCentre, {0, mask.width}).covered;
    for (int32_t x = span.begin; x < span.end; ++x) mask.at(x, y) = 1;
  }
}

}  // namespace rasterdiff::rasterizer
