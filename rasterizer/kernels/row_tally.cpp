// Runs and ties of several rows of a triangle at a time, in doubles that hold every integer here.
//
// In a row an edge function is E(x) = n + step·x in pixels x: a left edge (step > 0) bounds the closed triangle at ceil(-n / step),
// a right one (step < 0) at floor(n / -step) + 1. With |coordinates| <= 2^22 (kFastRange) all of dx (py - ay) - dy (px - ax) is
// below 2^49 and |step| = 256 |dy| < 2^32, exact. q = fl(n / step) is within |q| 2^-53 of the quotient. If the quotient is an
// integer it is a double, and q is it. If not, it is at least 1 / |step| > 2^-32 away from all integers, which is more than the
// error wherever |q| < 2^21; farther out both are beyond the same end of any target. So ceil, floor and "is an integer" of q are right.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rasterizer/kernels/row_tally.cpp"
#include "hwy/foreach_target.h"
// After foreach_target.h:
#include <algorithm>

#include "hwy/highway.h"
#include "rasterizer/kernels/row_tally.hpp"
#include "rasterizer/kernels/span_setup-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rasterdiff::rasterizer {
namespace HWY_NAMESPACE {

struct TallyEdge {
  double dx, dy, ax, ay;
};

/// First and end pixels of the closed triangle, and without its edges, in kLanes rows.
struct RowBoundsBoth {
  V closedBegin, closedEnd, openBegin, openEnd;
  M none;  // rows that a level edge leaves out
};

HWY_INLINE void Bound(const TallyEdge& edge, V sampleY, double sampleX, RowBoundsBoth& rows, M& ownedNone, M& openNone) {
  const D d;
  const V zero = hn::Zero(d), one = hn::Set(d, 1);
  const V n = hn::Set(d, edge.dx) * (sampleY - hn::Set(d, edge.ay)) - hn::Set(d, edge.dy * (sampleX - edge.ax));
  if (edge.dy == 0) {
    rows.none = hn::Or(rows.none, hn::Lt(n, zero));
    openNone = hn::Or(openNone, hn::Le(n, zero));
    if (!(edge.dx > 0)) ownedNone = hn::Or(ownedNone, hn::Eq(n, zero));  // [choice:tie-owner] not a top edge
    return;
  }
  const V q = n / hn::Set(d, 256 * edge.dy);  // -n / step
  const V up = hn::Ceil(q), down = hn::Floor(q);
  if (edge.dy < 0) {
    rows.closedBegin = hn::Max(rows.closedBegin, up);
    rows.openBegin = hn::Max(rows.openBegin, down + one);
  } else {
    rows.closedEnd = hn::Min(rows.closedEnd, down + one);
    rows.openEnd = hn::Min(rows.openEnd, up);
  }
}

struct TallySums {
  V inside, ties, cutQuads, partly;
};

HWY_INLINE V Parity(V x) {
  const D d;
  const V half = x * hn::Set(d, 0.5);
  return hn::IfThenElse(hn::Eq(half, hn::Floor(half)), hn::Zero(d), hn::Set(d, 1));
}

HWY_INLINE void TallyOne(const SnappedTriangle& t, const TallyArea& area, int32_t first, int32_t end, TallySums& sums) {
  const D d;
  const V zero = hn::Zero(d), width = hn::Set(d, area.width);
  TallyEdge edges[3];
  for (size_t i = 0; i < 3; ++i) {
    const SubpixelPosition &a = t.v[i], &b = t.v[(i + 1) % 3];
    edges[i] = {static_cast<double>(b.x - a.x), static_cast<double>(b.y - a.y), static_cast<double>(a.x), static_cast<double>(a.y)};
  }
  for (int32_t y = first; y < end; y += static_cast<int32_t>(kLanes)) {
    const V row = NumbersFrom(d, static_cast<double>(y));
    const M live = hn::Lt(row, hn::Set(d, end));
    V firstBegin = zero, firstEnd = zero;
    M unequal = hn::Ne(zero, zero);
    for (size_t s = 0; s < area.pattern.size(); ++s) {
      const V sampleY = hn::MulAdd(row, hn::Set(d, 256), hn::Set(d, area.pattern[s].y));  // exact
      RowBoundsBoth rows{zero, width, zero, width, hn::Not(live)};
      M ownedNone = rows.none, openNone = rows.none;
      for (const TallyEdge& edge : edges) Bound(edge, sampleY, area.pattern[s].x, rows, ownedNone, openNone);
      const M someClosed = hn::AndNot(rows.none, hn::Lt(rows.closedBegin, rows.closedEnd));
      const V closed = hn::IfThenElseZero(someClosed, rows.closedEnd - rows.closedBegin);
      const V open = hn::IfThenElseZero(hn::AndNot(openNone, someClosed), hn::Max(rows.openEnd - rows.openBegin, zero));
      // Left edges own their samples, right ones do not.
      const M covered = hn::And(hn::AndNot(ownedNone, someClosed), hn::Lt(rows.closedBegin, rows.openEnd));
      const V begin = hn::IfThenElseZero(covered, rows.closedBegin), last = hn::IfThenElseZero(covered, rows.openEnd);
      sums.inside = sums.inside + (last - begin);
      sums.ties = sums.ties + (closed - open);
      sums.cutQuads = sums.cutQuads + (Parity(begin) + Parity(last));
      if (s == 0) {
        firstBegin = begin, firstEnd = last;
      } else {
        unequal = hn::Or(unequal, hn::Or(hn::Ne(begin, firstBegin), hn::Ne(last, firstEnd)));
      }
    }
    sums.partly = sums.partly + hn::IfThenElseZero(unequal, hn::Set(d, 1));
  }
}

RowTally TallyRows(std::span<const SnappedTriangle> triangles, const TallyArea& area) {
  const D d;
  RowTally far;
  TallySums sums{hn::Zero(d), hn::Zero(d), hn::Zero(d), hn::Zero(d)};
  constexpr auto kNear = static_cast<int32_t>(kFastRange);
  for (const SnappedTriangle& t : triangles) {
    const auto [low, high] = std::minmax({t.v[0].y, t.v[1].y, t.v[2].y});
    const auto [left, right] = std::minmax({t.v[0].x, t.v[1].x, t.v[2].x});
    const int32_t first = std::max(low >> kSubpixelBits, area.firstRow), end = std::min((high >> kSubpixelBits) + 1, area.endRow);
    if (first >= end) continue;
    if (std::min(low, left) < -kNear || std::max(high, right) > kNear) {
      far += tallyRowsExactly(t, area);
    } else {
      TallyOne(t, area, first, end, sums);
    }
  }
  // A sum of whole numbers, below 2^53 for less than 2^25 triangles on the largest target.
  const auto total = [&](V v) { return static_cast<uint64_t>(hn::GetLane(hn::SumOfLanes(d, v))); };
  far += {total(sums.inside), total(sums.ties), total(sums.cutQuads), total(sums.partly)};
  return far;
}

}  // namespace HWY_NAMESPACE
}  // namespace rasterdiff::rasterizer
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include <algorithm>

namespace rasterdiff::rasterizer {

HWY_EXPORT(TallyRows);

RowTally& RowTally::operator+=(const RowTally& other) {
  inside += other.inside, ties += other.ties, cutQuads += other.cutQuads, partlyCovered += other.partlyCovered;
  return *this;
}

RowTally tallyRows(std::span<const SnappedTriangle> triangles, const TallyArea& area) {
  return HWY_DYNAMIC_DISPATCH(TallyRows)(triangles, area);
}

}  // namespace rasterdiff::rasterizer
#endif
