// Spans as ceilings of exact fractions. A left bound includes its tie and a right bound excludes it, so both are the
// same ceiling; a horizontal edge only limits the rows.
#include "rasterizer/kernels/integer_spans.hpp"

#include <algorithm>
#include <utility>

namespace rasterdiff::rasterizer {
namespace {

__extension__ using Wide = __int128;  // coordinates < 2^31, differences < 2^33, products < 2^66

Wide ceilDiv(Wide n, Wide d) { return n >= 0 ? (n + d - 1) / d : -((-n) / d); }

int64_t clampTo(Wide v, int64_t width) { return static_cast<int64_t>(std::clamp<Wide>(v, 0, width)); }

}  // namespace

IntegerSpan integerSpan(const SnappedTriangle& triangle, int64_t y, SampleLocation at, int64_t width) {
  auto v = triangle.v;
  std::sort(v.begin(), v.end(), [](SubpixelPosition a, SubpixelPosition b) { return a.y < b.y; });
  const Wide py = Wide{y} * kSubpixelOne + at.y * kSampleUnit;
  if (py < v[0].y || py >= v[2].y) return {};
  const Wide area = (Wide{v[1].x} - v[0].x) * (Wide{v[2].y} - v[0].y) - (Wide{v[2].x} - v[0].x) * (Wide{v[1].y} - v[0].y);
  if (area == 0) return {};
  // First pixel whose sample is not left of the edge a → b, b below a.
  const auto bound = [&](SubpixelPosition a, SubpixelPosition b) {
    const Wide dy = Wide{b.y} - a.y, dx = Wide{b.x} - a.x;
    const Wide numerator = (Wide{a.x} - at.x * kSampleUnit) * dy + (py - a.y) * dx;
    return clampTo(ceilDiv(numerator, dy * kSubpixelOne), width);
  };
  const int64_t across = bound(v[0], v[2]);
  const int64_t bent = py < v[1].y ? bound(v[0], v[1]) : bound(v[1], v[2]);
  return area > 0 ? IntegerSpan{across, bent} : IntegerSpan{bent, across};
}

void drawIntegerSpans(const SnappedTriangle& triangle, CoverageMask& mask) {
  const auto [top, bottom] = std::minmax({triangle.v[0].y, triangle.v[1].y, triangle.v[2].y});
  const int64_t first = std::max<int64_t>(0, top >> kSubpixelBits);
  const int64_t last = std::min<int64_t>(int64_t{mask.height()} - 1, bottom >> kSubpixelBits);
  for (int64_t y = first; y <= last; ++y)
    for (uint32_t s = 0; s < mask.samples(); ++s) {
      const IntegerSpan span = integerSpan(triangle, y, mask.locations()[s], mask.width());
      for (int64_t x = span.begin; x < span.end; ++x) mask.set(static_cast<uint32_t>(x), static_cast<uint32_t>(y), s);
    }
}

}  // namespace rasterdiff::rasterizer
