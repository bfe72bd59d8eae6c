#include "rasterizer/methods/polygon.hpp"

#include <fmt/format.h>

namespace rasterdiff::rasterizer {

Result<void> checkPolygon(const Polygon& polygon, int32_t width, int32_t height) {
  if (width < 1 || height < 1 || width > kMaxMaskExtent || height > kMaxMaskExtent) {
    return fail(ErrorCode::BadInput, "polygon", fmt::format("the mask has {} × {} pixels", width, height),
                fmt::format("give 1 to {} pixels a side", kMaxMaskExtent));
  }
  return rasterdiff::checkPolygon(polygon);
}

int32_t windingNumber(const Polygon& polygon, SubpixelPosition p) {
  int32_t winding = 0;
  SubpixelPosition a = polygon.vertices.back();
  for (const SubpixelPosition b : polygon.vertices) {
    // The row of p + (ε, ε²) meets an edge whose upper end is at or above p and whose lower end is below.
    const bool down = a.y <= p.y && p.y < b.y, up = b.y <= p.y && p.y < a.y;
    if (down || up) {
      // side > 0: p is to the left of a downward edge, to the right of an upward one.  // Q20.8 products ≤ 2^58
      const int64_t side = (int64_t{b.x} - a.x) * (int64_t{p.y} - a.y) - (int64_t{b.y} - a.y) * (int64_t{p.x} - a.x);
      if (down && side <= 0) --winding;  // the crossing is at or to the left of p
      if (up && side >= 0) ++winding;
    }
    a = b;
  }
  return winding;
}

PixelMask drawPolygonByWinding(const Polygon& polygon, FillRule rule, int32_t width, int32_t height) {
  PixelMask mask(width, height);
  for (int32_t y = 0; y < height; ++y) {
    for (int32_t x = 0; x < width; ++x) {
      const SubpixelPosition centre{x * kSubpixelOne + kSubpixelOne / 2, y * kSubpixelOne + kSubpixelOne / 2};
      mask.at(x, y) = isInside(windingNumber(polygon, centre), rule) ? 1 : 0;
    }
  }
  return mask;
}

}  // namespace rasterdiff::rasterizer
