// Scanline filling with an edge table, in integers. What a point on an edge belongs to is defined in polygon.hpp.
#include <algorithm>

#include "rasterizer/methods/integer_division.hpp"
#include "rasterizer/methods/polygon_methods.hpp"

namespace rasterdiff::rasterizer {
namespace {

/// An edge while the scanline meets it. The first pixel whose centre is at or right of the crossing is
/// x = ⌈(crossing - 128) / 256⌉, kept as quotient and remainder: (crossing - 128) / 256 = x - rest / divisor.
struct ActiveEdge {
  int32_t firstRow = 0, endRow = 0;  ///< rows whose centre lies in [upper end, lower end)
  int32_t winding = 0;               ///< +1 for an edge that goes up, whose inside is to the right
  int64_t x = 0, rest = 0;           ///< rest in 0 .. divisor - 1
  int64_t stepX = 0, stepRest = 0;   ///< dx / dy pixels a row = stepX - stepRest / divisor
  int64_t divisor = 1;               ///< 256 dy  // ≤ 2^37

  void nextRow() {
    x += stepX;
    rest += stepRest;
    if (rest >= divisor) {
      rest -= divisor;
      --x;
    }
  }
};

/// First row whose centre is at or below y (1/256 pixel).
int32_t firstRowFrom(int32_t y) {
  return static_cast<int32_t>(ceilDivide(int64_t{y} - kSubpixelOne / 2, kSubpixelOne));
}

/// Edges that meet a row of the mask, by first row; horizontal ones and those between two rows meet none.
std::vector<ActiveEdge> edgeTable(const Polygon& polygon, int32_t height) {
  std::vector<ActiveEdge> table;
  SubpixelPosition previous = polygon.vertices.back();
  for (const SubpixelPosition vertex : polygon.vertices) {
    const bool down = previous.y < vertex.y;
    const SubpixelPosition upper = down ? previous : vertex, lower = down ? vertex : previous;
    previous = vertex;
    ActiveEdge edge;
    edge.firstRow = std::max(0, firstRowFrom(upper.y));
    edge.endRow = std::min(height, firstRowFrom(lower.y));
    if (edge.firstRow >= edge.endRow) continue;
    edge.winding = down ? -1 : 1;
    const int64_t dx = int64_t{lower.x} - upper.x, dy = int64_t{lower.y} - upper.y;
    edge.divisor = kSubpixelOne * dy;
    const int64_t toRow = int64_t{edge.firstRow} * kSubpixelOne + kSubpixelOne / 2 - upper.y;
    const int64_t numerator = (int64_t{upper.x} - kSubpixelOne / 2) * dy + dx * toRow;  // ≤ 2^57 + 2^58
    edge.x = ceilDivide(numerator, edge.divisor);
    edge.rest = edge.x * edge.divisor - numerator;
    edge.stepX = ceilDivide(kSubpixelOne * dx, edge.divisor);
    edge.stepRest = edge.stepX * edge.divisor - kSubpixelOne * dx;
    table.push_back(edge);
  }
  std::sort(table.begin(), table.end(),
            [](const ActiveEdge& l, const ActiveEdge& r) { return l.firstRow < r.firstRow; });
  return table;
}

void fillRow(std::span<const ActiveEdge> active, FillRule rule, PixelMask& mask, int32_t y) {
  int32_t winding = 0;
  int64_t from = 0;
  for (const ActiveEdge& edge : active) {
    if (isInside(winding, rule)) {
      const int64_t end = std::min<int64_t>(edge.x, mask.width);
      for (int64_t x = std::max<int64_t>(from, 0); x < end; ++x) mask.at(static_cast<int32_t>(x), y) = 1;
    }
    winding += edge.winding;
    from = edge.x;
  }
}

}  // namespace

Result<PixelMask> drawPolygonScanline(const Polygon& polygon, FillRule rule, int32_t width, int32_t height) {
  if (auto ok = checkPolygon(polygon, width, height); !ok) return tl::unexpected(ok.error());
  PixelMask mask(width, height);
  const std::vector<ActiveEdge> table = edgeTable(polygon, height);
  std::vector<ActiveEdge> active;
  size_t next = 0;
  for (int32_t y = 0; y < height && (next < table.size() || !active.empty()); ++y) {
    std::erase_if(active, [y](const ActiveEdge& edge) { return edge.endRow <= y; });
    for (ActiveEdge& edge : active) edge.nextRow();
    while (next < table.size() && table[next].firstRow == y) active.push_back(table[next++]);
    // Nearly sorted from the row before; equal crossings may stand in any order, the span between them is empty.
    for (size_t i = 1; i < active.size(); ++i) {
      for (size_t k = i; k > 0 && active[k].x < active[k - 1].x; --k) std::swap(active[k], active[k - 1]);
    }
    fillRow(active, rule, mask, y);
  }
  return mask;
}

}  // namespace rasterdiff::rasterizer
