// Coverage by definition; nothing here is tuned, everything faster is compared with it.
#include "rasterizer/kernels/coverage_oracle.hpp"

#include <algorithm>
#include <utility>

namespace rasterdiff::rasterizer {
namespace {

/// > 0 where p lies to the right of a → b as seen on a y-down screen (the interior of a clockwise triangle).
int64_t edgeFunction(SubpixelPosition a, SubpixelPosition b, SubpixelPosition p) {
  return (int64_t{b.x} - a.x) * (int64_t{p.y} - a.y) - (int64_t{b.y} - a.y) * (int64_t{p.x} - a.x);
}

/// Of a clockwise triangle: left edges go up, top edges go right.
bool ownsTies(SubpixelPosition a, SubpixelPosition b) { return b.y < a.y || (b.y == a.y && b.x > a.x); }

}  // namespace

bool covers(const SnappedTriangle& triangle, SubpixelPosition p) {
  SubpixelPosition a = triangle.v[0], b = triangle.v[1], c = triangle.v[2];
  const int64_t area = edgeFunction(a, b, c);
  if (area == 0) return false;
  if (area < 0) std::swap(b, c);
  const auto inside = [&](SubpixelPosition from, SubpixelPosition to) {
    const int64_t e = edgeFunction(from, to, p);
    return e > 0 || (e == 0 && ownsTies(from, to));
  };
  return inside(a, b) && inside(b, c) && inside(c, a);
}

void drawCoverageOracle(std::span<const SnappedTriangle> triangles, CoverageMask& mask) {
  for (const SnappedTriangle& t : triangles) {
    const auto [x0, x1] = std::minmax({t.v[0].x, t.v[1].x, t.v[2].x});
    const auto [y0, y1] = std::minmax({t.v[0].y, t.v[1].y, t.v[2].y});
    const int32_t firstX = std::max(0, (x0 >> kSubpixelBits)), firstY = std::max(0, (y0 >> kSubpixelBits));
    const int32_t lastX = std::min(static_cast<int32_t>(mask.width()) - 1, x1 >> kSubpixelBits);
    const int32_t lastY = std::min(static_cast<int32_t>(mask.height()) - 1, y1 >> kSubpixelBits);
    for (int32_t y = firstY; y <= lastY; ++y)
      for (int32_t x = firstX; x <= lastX; ++x)
        for (uint32_t s = 0; s < mask.samples(); ++s) {
          const SampleLocation at = mask.locations()[s];
          if (covers(t, {x * kSubpixelOne + at.x * kSampleUnit, y * kSubpixelOne + at.y * kSampleUnit}))
            mask.set(static_cast<uint32_t>(x), static_cast<uint32_t>(y), s);
        }
  }
}

}  // namespace rasterdiff::rasterizer
