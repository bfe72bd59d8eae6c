// The deliberately simple coverage methods, one a file, and the little that they share.
#pragma once

#include <algorithm>
#include <span>
#include <utility>

#include "rasterizer/kernels/coverage_mask.hpp"

namespace rasterdiff::rasterizer::methods {

using Triangles = std::span<const SnappedTriangle>;

void threeCrossProducts(Triangles triangles, CoverageMask& mask);
void edgeFunctionsFloat(Triangles triangles, CoverageMask& mask);
void edgeFunctionsDouble(Triangles triangles, CoverageMask& mask);
void incrementalFloat(Triangles triangles, CoverageMask& mask);
void incrementalDouble(Triangles triangles, CoverageMask& mask);
void incrementalFixed(Triangles triangles, CoverageMask& mask);
void edgeWalking(Triangles triangles, CoverageMask& mask);
void blockParallel(Triangles triangles, CoverageMask& mask);
void hierarchical(Triangles triangles, CoverageMask& mask);
void blockHierarchy(Triangles triangles, CoverageMask& mask);

/// Pixels [x0, x1) × [y0, y1) that a triangle may touch, inside the target.
struct Box {
  int32_t x0, y0, x1, y1;
};

inline Box boxOf(const SnappedTriangle& t, const CoverageMask& mask) {
  const auto [left, right] = std::minmax({t.v[0].x, t.v[1].x, t.v[2].x});
  const auto [top, bottom] = std::minmax({t.v[0].y, t.v[1].y, t.v[2].y});
  return {std::max(0, left >> kSubpixelBits), std::max(0, top >> kSubpixelBits),
          std::min(static_cast<int32_t>(mask.width()), (right >> kSubpixelBits) + 1),
          std::min(static_cast<int32_t>(mask.height()), (bottom >> kSubpixelBits) + 1)};
}

inline int64_t doubleArea(const SnappedTriangle& t) {
  return (int64_t{t.v[1].x} - t.v[0].x) * (int64_t{t.v[2].y} - t.v[0].y) -
         (int64_t{t.v[2].x} - t.v[0].x) * (int64_t{t.v[1].y} - t.v[0].y);
}

/// The same triangle, clockwise on a y-down screen.
inline SnappedTriangle clockwise(SnappedTriangle t) {
  if (doubleArea(t) < 0) std::swap(t.v[1], t.v[2]);
  return t;
}

/// Does the edge a → b of a clockwise triangle own its ties (top or left)?
inline bool ownsTies(SubpixelPosition a, SubpixelPosition b) { return b.y < a.y || (b.y == a.y && b.x > a.x); }

inline void setPixel(CoverageMask& mask, int32_t x, int32_t y, uint32_t s) {
  mask.set(static_cast<uint32_t>(x), static_cast<uint32_t>(y), s);
}

}  // namespace rasterdiff::rasterizer::methods
