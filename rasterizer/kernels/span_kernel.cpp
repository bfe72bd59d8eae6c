// The exact coverage kernel: batches of triangles through set-up and blocks, once for each instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rasterizer/kernels/span_kernel.cpp"
#include "hwy/foreach_target.h"
// After foreach_target.h:
#include <algorithm>
#include <bit>
#include <span>
#include <vector>

#include "hwy/highway.h"
#include "rasterizer/kernels/integer_spans.hpp"
#include "rasterizer/kernels/span_large-inl.h"
#include "rasterizer/kernels/span_medium-inl.h"
#include "rasterizer/kernels/span_setup-inl.h"
#include "rasterizer/kernels/span_narrow-inl.h"
#include "rasterizer/kernels/span_target.hpp"

HWY_BEFORE_NAMESPACE();
namespace rasterdiff::rasterizer {
namespace HWY_NAMESPACE {

/// Draws the classes that SetUp sorted a batch into, in any order: OR does not mind.
template <size_t kSide, size_t kSamples>
HWY_INLINE void DrawSide(const Batch<kSamples>& b, const SpanTarget& target, Touched& touched, FirstBlocks& firstBlocks) {
  DrawSmall<kSide, 0, kSamples>(b, target);
  DrawSmall<kSide, 1, kSamples>(b, target);
  DrawSmall<kSide, 2, kSamples>(b, target);
  DrawSmall<kSide, 3, kSamples>(b, target);
  if (b.medium[kSide].size > 0) DrawMedium<kSide, kSamples>(b, b.medium[kSide], target, touched, firstBlocks);
  if (b.large[kSide].size > 0) DrawLarge<kSide, kSamples>(b, b.large[kSide], target, touched);
}

HWY_INLINE NarrowTarget NarrowTargetOf(uint64_t* blocks, size_t stride, const SpanTarget& target) {
  const auto added = std::bit_cast<uint64_t>(kIntegers) << 6;
  return {reinterpret_cast<uintptr_t>(blocks) - added, static_cast<double>(stride), target.samples};
}

template <size_t kSamples>
void DrawBatches(std::span<const SnappedTriangle> triangles, const SpanTarget& target, CoverageMask& mask) {
  using B = Batch<kSamples>;
  B b;
  Touched touched;
  FirstBlocks firstBlocks;
  NarrowOnes narrow;
  for (size_t first = 0; first < triangles.size(); first += B::kSize) {
    const size_t size = std::min(B::kSize, triangles.size() - first);
    const SnappedTriangle* HWY_RESTRICT t = triangles.data() + first;
    b.Clear();
    size_t i = 0;
    for (; i + kLanes <= size; i += kLanes) {
      PrefetchAhead(t + i);
      SetUp<kSamples>(t + i, i, target, b);
    }
    if (i < size) {
      SnappedTriangle rest[kLanes] = {};  // the others have no area
      std::copy(t + i, t + size, rest);
      SetUp<kSamples>(rest, i, target, b);
    }
    DrawSide<0, kSamples>(b, target, touched, firstBlocks);
    DrawSide<1, kSamples>(b, target, touched, firstBlocks);
    if (b.narrow[kTallShape][0].size + b.narrow[kTallShape][1].size > 0) {
      const NarrowTarget blocks = NarrowTargetOf(mask.tall(), mask.tallStride(), target);
      DrawNarrow<kTallShape, 0>(b, target, blocks, narrow);
      DrawNarrow<kTallShape, 1>(b, target, blocks, narrow);
    }
    if (b.narrow[kWideShape][0].size + b.narrow[kWideShape][1].size > 0) {
      const NarrowTarget blocks = NarrowTargetOf(target.words, mask.halfColumns(), target);
      DrawNarrow<kWideShape, 0>(b, target, blocks, narrow);
      DrawNarrow<kWideShape, 1>(b, target, blocks, narrow);
    }
    for (size_t k = 0; k < b.far.size; ++k) drawIntegerSpans(t[b.far.places[k]], mask);
  }
}

void DrawSpans(std::span<const SnappedTriangle> triangles, CoverageMask& mask) {
  const SpanTarget target = spanTarget(mask);
  if (target.samples == 1) return DrawBatches<1>(triangles, target, mask);
  if (target.samples == 4) return DrawBatches<4>(triangles, target, mask);
  DrawBatches<0>(triangles, target, mask);
}

}  // namespace HWY_NAMESPACE
}  // namespace rasterdiff::rasterizer
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include <thread>

namespace rasterdiff::rasterizer {

HWY_EXPORT(DrawSpans);

SpanTarget spanTarget(CoverageMask& mask) {
  SpanTarget t;
  t.words = mask.words();
  t.full = mask.full();
  t.fullStride = mask.fullStride();
  t.width = mask.width(), t.height = mask.height();
  t.samples = mask.samples();
  t.blockWords = static_cast<double>(mask.blockOffset(0, 1, 0));
  t.rowWords = static_cast<double>(mask.blockOffset(1, 0, 0));
  t.minX = t.minY = kSubpixelOne;
  for (size_t s = 0; s < t.samples; ++s) {
    t.x[s] = mask.locations()[s].x * kSampleUnit, t.y[s] = mask.locations()[s].y * kSampleUnit;
    t.minX = std::min(t.minX, t.x[s]), t.maxX = std::max(t.maxX, t.x[s]);
    t.minY = std::min(t.minY, t.y[s]), t.maxY = std::max(t.maxY, t.y[s]);
  }
  return t;
}

void drawCoverage(std::span<const SnappedTriangle> triangles, CoverageMask& mask, unsigned threads) {
  constexpr size_t kWorthAThread = 4096;  // triangles
  if (threads == 0) threads = std::max(1u, std::thread::hardware_concurrency());
  threads = static_cast<unsigned>(std::min<size_t>(threads, triangles.size() / kWorthAThread + 1));
  if (threads > 1) {
    // OR does not mind the order: each thread draws its share into a mask of its own.
    std::vector<CoverageMask> parts(threads - 1, mask);
    std::vector<std::thread> workers;
    const size_t share = triangles.size() / threads;
    for (unsigned k = 0; k + 1 < threads; ++k)
      workers.emplace_back([&, k] { HWY_DYNAMIC_DISPATCH(DrawSpans)(triangles.subspan(k * share, share), parts[k]); });
    HWY_DYNAMIC_DISPATCH(DrawSpans)(triangles.subspan((threads - 1) * share), mask);
    for (std::thread& worker : workers) worker.join();
    for (const CoverageMask& part : parts) mask.merge(part);
  } else {
    HWY_DYNAMIC_DISPATCH(DrawSpans)(triangles, mask);
  }
  mask.settle(triangles);
}

std::vector<std::string> coverageTargets() {
  std::vector<std::string> names;
  for (const int64_t target : hwy::SupportedAndGeneratedTargets()) names.emplace_back(hwy::TargetName(target));
  return names;
}

}  // namespace rasterdiff::rasterizer
#endif
