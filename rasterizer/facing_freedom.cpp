#include "rasterizer/facing_freedom.hpp"

#include <algorithm>

namespace rasterdiff::rasterizer {
namespace {

// How far from its nominal place a corner may legally be, in x or y.
int64_t reach(const RasterVertex& v) {
  return std::max({std::llabs(int64_t{v.snapped.x} - v.lowest.x), std::llabs(int64_t{v.highest.x} - v.snapped.x),
                   std::llabs(int64_t{v.snapped.y} - v.lowest.y), std::llabs(int64_t{v.highest.y} - v.snapped.y)});
}

}  // namespace

AreaBand areaBand(const std::vector<RasterVertex>& polygon) {
  const size_t n = polygon.size();
  AreaBand band;
  int64_t perimeter = 0, farthest = 0;
  for (size_t i = 0; i < n; ++i) {
    const RasterVertex& a = polygon[i];
    const RasterVertex& b = polygon[(i + 1) % n];
    band.area += doubleArea(polygon[0].snapped, a.snapped, b.snapped);
    perimeter += std::llabs(int64_t{b.snapped.x} - a.snapped.x) + std::llabs(int64_t{b.snapped.y} - a.snapped.y);
    farthest = std::max(farthest, reach(a));
  }
  // Moving every corner by at most m changes twice the area by at most m · perimeter (L1) + 4 n m².
  band.margin = farthest * perimeter + 4 * static_cast<int64_t>(n) * farthest * farthest;
  return band;
}

bool sideIsFree(const Primitive& primitive) {
  const auto& [a, b, c] = primitive.clip;
  if (!primitive.cut && (a == b || b == c || c == a)) return false;
  return areaBand(primitive.polygon).sideIsFree();
}

}  // namespace rasterdiff::rasterizer
