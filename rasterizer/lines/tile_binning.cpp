#include "rasterizer/lines/tile_binning.hpp"

#include <algorithm>

namespace rasterdiff::rasterizer {
namespace {

constexpr int32_t kTile = 64;  // pixels

/// Pixels, inclusive.
struct Interval {
  int32_t first = 0, last = -1;
  [[nodiscard]] bool meets(Interval other) const {
    return first <= last && other.first <= other.last && first <= other.last && other.first <= last;
  }
};

Interval cornersBetween(int32_t low, int32_t high) {
  return {(low + kSubpixelOne - 1) >> kSubpixelBits, ((high + kSubpixelOne - 1) >> kSubpixelBits) - 1};
}

Interval tilesOf(Interval box, Interval region) {
  const int32_t first = std::max(box.first, region.first), last = std::min(box.last, region.last);
  return {first & ~(kTile - 1), last | (kTile - 1)};
}

}  // namespace

PixelBox cornersInside(const LineOutline& outline) {
  const auto [left, right] = std::minmax({outline[0].x, outline[1].x, outline[2].x, outline[3].x});
  const auto [top, bottom] = std::minmax({outline[0].y, outline[1].y, outline[2].y, outline[3].y});
  const Interval x = cornersBetween(left, right), y = cornersBetween(top, bottom);
  return {x.first, y.first, x.last, y.last};
}

PixelArea binnedArea(const LineOutline& outline, const PixelArea& region) {
  const PixelBox box = cornersInside(outline);
  const Interval x{box.left, box.right}, y{box.top, box.bottom};
  const Interval regionX{region.left, region.right - 1}, regionY{region.top, region.bottom - 1};
  if (!x.meets(regionX) || !y.meets(regionY)) return {};
  const Interval seenX = tilesOf(x, regionX), seenY = tilesOf(y, regionY);
  return {seenX.first, seenY.first, seenX.last + 1, seenY.last + 1};
}

}  // namespace rasterdiff::rasterizer
