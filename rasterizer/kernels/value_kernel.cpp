// The exact value kernel: batches of triangles through set-up, rows and planes, once for each instruction set; bands for
// threads. Varyings are value_shading.cpp's.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rasterizer/kernels/value_kernel.cpp"
#include "hwy/foreach_target.h"
// After foreach_target.h:
#include <algorithm>
#include <bit>

#include "hwy/highway.h"
#include "rasterizer/kernels/value_kernel.hpp"
#include "rasterizer/kernels/value_high-inl.h"
#include "rasterizer/kernels/value_large-inl.h"
#include "rasterizer/kernels/value_medium-inl.h"
#include "rasterizer/kernels/value_rows-inl.h"
#include "rasterizer/kernels/value_tiny-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rasterdiff::rasterizer {
namespace HWY_NAMESPACE {

/// Copies of triangles `places` [0, size) with what they carry, and fetches those that come next.
struct GatheredBatch {
  SnappedTriangle positions[ValueBatch::kSize];
  float depth[3 * ValueBatch::kSize];

  HWY_INLINE void Gather(const ValueTriangles& triangles, const uint32_t* HWY_RESTRICT places, size_t size, size_t left) {
    for (size_t k = 0; k < size; ++k) {
      const size_t t = places[k], next = places[std::min(k + ValueBatch::kSize, left - 1)];
      __builtin_prefetch(&triangles.positions[next]);
      positions[k] = triangles.positions[t];
      if (triangles.depth.empty()) continue;
      __builtin_prefetch(triangles.depth.data() + 3 * next);
      std::copy_n(triangles.depth.data() + 3 * t, 3, depth + 3 * k);
    }
  }
};

template <class P>
void SetUpBatch(const SnappedTriangle* HWY_RESTRICT t, const float* HWY_RESTRICT z, const DepthCorners* HWY_RESTRICT corners, size_t size,
                const ValueView& view, ValueBatch& b) {
  constexpr bool kOwn = P::kDepth && !P::kCorners;
  b.size = 0;
  size_t i = 0;
  for (; i + kLanes <= size; i += kLanes) {
    if (!b.listed) {
      PrefetchAhead(t + i);
      if (kOwn) PrefetchAhead(z + 3 * i, 3);
    }
    SetUpValues<P::kDepth, P::kCorners>(t + i, kOwn ? z + 3 * i : nullptr, P::kCorners ? corners + i : nullptr, i, view, b);
    if (P::kDepth) SetUpTests(view, i, b);
  }
  if (i == size) return;
  SnappedTriangle rest[kLanes] = {};  // the others have no area
  float restDepth[3 * kLanes] = {};
  std::copy(t + i, t + size, rest);
  if (kOwn) std::copy(z + 3 * i, z + 3 * size, restDepth);
  DepthCorners restCorners[P::kCorners ? kLanes : 1] = {};
  if (P::kCorners) std::copy(corners + i, corners + size, restCorners);
  SetUpValues<P::kDepth, P::kCorners>(rest, restDepth, restCorners, i, view, b);
  if (P::kDepth) SetUpTests(view, i, b);
}

/// Sets up triangles [first, first + size) of the list.
template <class P>
HWY_NOINLINE void SetUpListed(const ValueTriangles& triangles, const DrawnList& list, size_t first, size_t size, const ValueView& view, GatheredBatch& gathered,
                 ValueBatch& b) {
  constexpr bool kOwn = P::kDepth && !P::kCorners;
  b.listed = list.places != nullptr;
  if (b.listed) {
    gathered.Gather(triangles, list.places + first, size, list.size - first);
    for (size_t k = 0; k < size; ++k) b.triangles[k] = list.places[first + k];
    SetUpBatch<P>(gathered.positions, kOwn ? gathered.depth : nullptr, nullptr, size, view, b);
    return;
  }
  b.triangles[0] = static_cast<uint32_t>(first);
  SetUpBatch<P>(triangles.positions.data() + first, kOwn ? triangles.depth.data() + 3 * first : nullptr,
                P::kCorners ? triangles.corners.data() + first : nullptr, size, view, b);
}

/// Draws the k-th of b.places, which is not small or beyond the fast range, and if it is of hundreds of pixels those that follow and are
/// so, too; returns how many. A function of its own, for the sake of the loop that calls it.
template <class P>
HWY_NOINLINE size_t DrawOthers(const ValueTriangles& triangles, const ValueView& view, const ValueBatch& b, size_t k, Farthest& farthest,
                               SeenBlocks& blocks) {
  const size_t i = b.places[k];
  if (b.far[i] != 0) {
    drawFarTriangle(triangles, b.listed ? b.triangles[i] : b.triangles[0] + i, view);
    return 1;
  }
  if constexpr (P::kDepth) {
    if (b.way[i] == kWide) {
      DrawLarge<P>(view, b, i, farthest, blocks);
      return 1;
    }
    size_t end = k + 1;
    while (end < b.size && b.far[b.places[end]] == 0 && b.way[b.places[end]] == kMedium) ++end;
    DrawMedium<P>(view, b, k, end, farthest, blocks);
    return end - k;
  }
  return 1;
}

template <class P>
DrawnArea DrawAll(const ValueTriangles& triangles, const DrawnList& list, const ValueView& view) {
  ValueBatch b;
  GatheredBatch gathered;
  Chunks chunks;
  SeenBlocks blocks;
  Farthest farthest(view);
  for (size_t first = 0; first < list.size; first += ValueBatch::kSize) {
    SetUpListed<P>(triangles, list, first, std::min(ValueBatch::kSize, list.size - first), view, gathered, b);
    for (size_t k = 0; k < b.size;) {
      const size_t i = b.places[k];
      if (HWY_LIKELY(b.far[i] == 0 && b.way[i] == kSmall)) {
        if (HWY_LIKELY(b.endRow[i] - b.firstRow[i] < kHighRows)) {
          FindChunks<P>(view, b, i, chunks);
        } else {
          FindChunksOfHigh<P>(view, b, i, chunks);
        }
        ++k;
        continue;
      }
#if HWY_TARGET <= HWY_AVX3
      if (b.way[i] == kTiny) {
        FindChunksOfTiny<P>(view, b, i, chunks);
        k += static_cast<size_t>(std::popcount(b.drawn[i / kLanes]));
        continue;
      }
#endif
      DrawChunks<P>(view, b, chunks);
      k += DrawOthers<P>(triangles, view, b, k, farthest, blocks);
    }
    DrawChunks<P>(view, b, chunks);
  }
  return AreaOf(b);
}

DrawnArea DrawPlanes(const ValueTriangles& triangles, const DrawnList& list, const ValueView& view) {
  if (!triangles.corners.empty()) return DrawAll<Planes<true, true, true, true>>(triangles, list, view);
  const unsigned which = (view.primitive != nullptr ? 1 : 0) | (view.count != nullptr ? 2 : 0) | (view.depth != nullptr ? 4 : 0);
  switch (which) {
    case 1: return DrawAll<Planes<true, false, false>>(triangles, list, view);
    case 2: return DrawAll<Planes<false, true, false>>(triangles, list, view);
    case 3: return DrawAll<Planes<true, true, false>>(triangles, list, view);
    case 4: return DrawAll<Planes<false, false, true>>(triangles, list, view);  // in any order: the least depth is what it is
    case 5: return view.reordered ? DrawAll<Planes<true, false, true, false, true>>(triangles, list, view) : DrawAll<Planes<true, false, true>>(triangles, list, view);
    case 6: return DrawAll<Planes<false, true, true>>(triangles, list, view);
    case 7: return DrawAll<Planes<true, true, true>>(triangles, list, view);
    default: return {};
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace rasterdiff::rasterizer
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include <thread>
#include <vector>

#include "rasterizer/kernels/value_bins.hpp"
#include "rasterizer/kernels/value_order.hpp"
#include "rasterizer/kernels/value_shading.hpp"

namespace rasterdiff::rasterizer {

HWY_EXPORT(DrawPlanes);

ValueView valueView(ValueTarget& target, uint32_t firstRow, uint32_t endRow) {
  ValueView v;
  if (target.needs().primitive) v.primitive = target.primitive.data();
  if (target.needs().count) v.count = target.count.data();
  if (target.needs().depth) v.depth = target.depth.data();
  v.width = target.width(), v.firstRow = firstRow, v.endRow = endRow;
  v.samples = target.samples(), v.stride = target.stride();
  v.minX = v.minY = kSubpixelOne;
  for (size_t s = 0; s < v.samples; ++s) {
    v.x[s] = target.locations()[s].x * kSampleUnit, v.y[s] = target.locations()[s].y * kSampleUnit;
    v.minX = std::min(v.minX, v.x[s]), v.maxX = std::max(v.maxX, v.x[s]);
    v.minY = std::min(v.minY, v.y[s]), v.maxY = std::max(v.maxY, v.y[s]);
  }
  return v;
}

uint64_t drawBand(const ValueTriangles& triangles, ValueTarget& target, uint32_t firstRow, uint32_t endRow, uint32_t before) {
  ValueView view = valueView(target, 0, target.height());
  view.firstRow = firstRow, view.endRow = endRow;
  view.before = before;
  const size_t above = size_t{firstRow} * view.samples * view.stride;  // rows are addressed from the frame's first on
  if (view.primitive != nullptr) view.primitive -= above;
  if (view.count != nullptr) view.count -= above;
  if (view.depth != nullptr) view.depth -= above;
  uint64_t met = 0;
  view.met = &met;
  (void)HWY_DYNAMIC_DISPATCH(DrawPlanes)(triangles, {nullptr, triangles.positions.size()}, view);
  return met;
}

namespace {

/// Draws and shades rows [firstRow, endRow).
void drawListed(const ValueTriangles& triangles, const DrawnList& list, bool reordered, ValueTarget& target, uint32_t firstRow, uint32_t endRow) {
  ValueView view = valueView(target, firstRow, endRow);
  view.shaded = !target.varyings.empty(), view.reordered = reordered;
  const DrawnArea area = HWY_DYNAMIC_DISPATCH(DrawPlanes)(triangles, list, view);
  if (!target.varyings.empty()) shadeArea(triangles, target, area);
}

/// The same of all triangles, in `order` if there is one, `rows` rows at a time.
void drawInBands(const ValueTriangles& triangles, std::span<const uint32_t> order, ValueTarget& target, uint32_t firstRow, uint32_t endRow,
                 uint32_t rows) {
  const bool reordered = !order.empty();
  if (rows >= endRow - firstRow)
    return drawListed(triangles, {reordered ? order.data() : nullptr, triangles.positions.size()}, reordered, target, firstRow, endRow);
  const ValueBins bins(triangles.positions, order, firstRow, endRow, rows);
  for (size_t k = 0; k < bins.size(); ++k) {
    const uint32_t top = firstRow + static_cast<uint32_t>(k) * rows;
    drawListed(triangles, bins.of(k), reordered, target, top, std::min(top + rows, endRow));
  }
}

}  // namespace

void drawValues(const ValueTriangles& triangles, ValueTarget& target, unsigned threads) {
  constexpr uint32_t kLeastRows = 16;  // of a band
  const uint32_t rows = nearRows(triangles, target);
  const std::vector<uint32_t> order = nearestFirst(triangles, target);
  if (threads == 0) threads = std::max(1u, std::thread::hardware_concurrency());
  threads = std::min(threads, std::max(1u, target.height() / kLeastRows));
  const auto start = [&](unsigned k) { return k == threads ? target.height() : static_cast<uint32_t>(uint64_t{target.height()} * k / threads) / 8 * 8; };
  std::vector<std::thread> workers;
  for (unsigned k = 1; k < threads; ++k)
    workers.emplace_back([&, k] { drawInBands(triangles, order, target, start(k), start(k + 1), rows); });
  drawInBands(triangles, order, target, 0, start(1), rows);
  for (std::thread& worker : workers) worker.join();
}

}  // namespace rasterdiff::rasterizer
#endif
