// The definition of RowTally, and what is beyond the range of doubles: one triangle in 64-bit integers.
#include <algorithm>

#include "rasterizer/kernels/row_tally.hpp"

namespace rasterdiff::rasterizer {
namespace {

int64_t floorDiv(int64_t n, int64_t d) { return n / d - (n % d != 0 && (n < 0) != (d < 0) ? 1 : 0); }

struct Run {
  int64_t begin = 0, end = 0;
  [[nodiscard]] int64_t length() const { return std::max<int64_t>(0, end - begin); }
};

/// The runs of one row: of the closed triangle, of what is left without its edges, and of what it owns.
struct Runs {
  Run closed, open, owned;

  // E = n + step·x  // Q23.8 × Q23.8: |n| <= 2^61, |step| <= 2^38
  void cut(SubpixelPosition a, SubpixelPosition b, int64_t px, int64_t py) {
    const int64_t dx = int64_t{b.x} - a.x, dy = int64_t{b.y} - a.y;
    const int64_t n = dx * (py - a.y) - dy * (px - a.x), step = -dy * kSubpixelOne;
    if (step == 0) {
      if (n < 0) closed = {};
      if (n <= 0) open = {};
      if (n < 0 || (n == 0 && dx <= 0)) owned = {};
      return;
    }
    const int64_t down = floorDiv(-n, step), up = -floorDiv(n, step);
    if (step > 0) {
      closed.begin = std::max(closed.begin, up);
      owned.begin = std::max(owned.begin, up);
      open.begin = std::max(open.begin, down + 1);
    } else {
      closed.end = std::min(closed.end, down + 1);
      owned.end = std::min(owned.end, up);
      open.end = std::min(open.end, up);
    }
  }
};

}  // namespace

RowTally tallyRowsExactly(const SnappedTriangle& t, const TallyArea& area) {
  RowTally tally;
  const auto [low, high] = std::minmax({t.v[0].y, t.v[1].y, t.v[2].y});
  const int32_t first = std::max(low >> kSubpixelBits, area.firstRow), last = std::min(high >> kSubpixelBits, area.endRow - 1);
  for (int32_t y = first; y <= last; ++y) {
    Run before;
    bool unequal = false;
    for (size_t s = 0; s < area.pattern.size(); ++s) {
      const Run whole{0, area.width};
      Runs runs{whole, whole, whole};
      for (size_t i = 0; i < 3; ++i) {
        runs.cut(t.v[i], t.v[(i + 1) % 3], area.pattern[s].x, int64_t{y} * kSubpixelOne + area.pattern[s].y);
      }
      if (runs.closed.length() == 0) runs = {};
      if (runs.owned.length() == 0) runs.owned = {};
      tally.inside += static_cast<uint64_t>(runs.owned.length());
      tally.ties += static_cast<uint64_t>(runs.closed.length() - runs.open.length());
      tally.cutQuads += static_cast<uint64_t>((runs.owned.begin & 1) + (runs.owned.end & 1));
      unequal = unequal || (s > 0 && (runs.owned.begin != before.begin || runs.owned.end != before.end));
      if (s == 0) before = runs.owned;
    }
    tally.partlyCovered += unequal ? 1 : 0;
  }
  return tally;
}

}  // namespace rasterdiff::rasterizer
