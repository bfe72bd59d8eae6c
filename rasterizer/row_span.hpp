// The samples of one pixel row that a convex polygon covers, as an exact interval: one integer division an edge.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

#include "rasterizer/edge_function.hpp"

namespace rasterdiff::rasterizer {

/// Pixels begin <= x < end.
struct RowSpan {
  int32_t begin = 0, end = 0;
  [[nodiscard]] bool empty() const { return begin >= end; }
  [[nodiscard]] int32_t length() const { return std::max(0, end - begin); }
};

/// Covered pixels of a row, and the number of its samples that lie exactly on an edge (of the closed polygon).
struct RowCoverage {
  RowSpan covered;
  int32_t ties = 0;
};

/// Keeps of `open`, `closed` and `owned` the pixels x whose sample (x·256 + sampleX, sampleY) is on the inner side.
/// E is linear in x: E(x) = constant + step · x, so a row's part is x >= ⌈-constant / step⌉ or x <= ⌊constant / -step⌋;
/// a remainder of zero is a tie.  // step: Q39.16 ≤ 2^38, constant ≤ 2^62
inline void clipRow(const EdgeFunction& edge, int64_t sampleX, int64_t sampleY, RowSpan& open, RowSpan& closed,
                    RowSpan& owned) {
  const int64_t constant = edge.at(sampleX, sampleY);
  const int64_t step = -edge.dy * kSubpixelOne;
  const auto intersect = [](RowSpan& span, bool fromBelow, int64_t bound) {
    const auto clamped = static_cast<int32_t>(std::clamp<int64_t>(bound, span.begin, std::max(span.begin, span.end)));
    (fromBelow ? span.begin : span.end) = clamped;
  };
  if (step == 0) {
    if (constant < 0) closed.end = closed.begin;
    if (constant <= 0) open.end = open.begin;
    if (constant < 0 || (constant == 0 && !edge.ownsTies)) owned.end = owned.begin;
    return;
  }
  if (step > 0) {
    int64_t first = -constant / step;  // truncation toward zero is the ceiling of a negative quotient
    if (-constant % step > 0) ++first;
    const int64_t tie = constant % step == 0 ? 1 : 0;
    intersect(closed, true, first);
    intersect(open, true, first + tie);
    intersect(owned, true, edge.ownsTies ? first : first + tie);
    return;
  }
  int64_t last = constant / -step;
  if (constant % -step < 0) --last;
  const int64_t tie = constant % -step == 0 ? 1 : 0;
  intersect(closed, false, last + 1);
  intersect(open, false, last + 1 - tie);
  intersect(owned, false, edge.ownsTies ? last + 1 : last + 1 - tie);
}

[[nodiscard]] inline RowCoverage coverRow(std::span<const EdgeFunction> edges, int64_t sampleX, int64_t sampleY,
                                          RowSpan limits) {
  RowSpan open = limits, closed = limits, owned = limits;
  for (const EdgeFunction& edge : edges) {
    clipRow(edge, sampleX, sampleY, open, closed, owned);
    if (closed.empty()) return {};
  }
  return {owned, closed.length() - open.length()};
}

}  // namespace rasterdiff::rasterizer
