// What the depth test may leave out: blocks of 8 × 8 pixels that hide a triangle as a whole, and how they are found, several at a
// time. Which of them are looked at: value_medium-inl.h, value_large-inl.h; how the others are drawn: value_seen-inl.h.
//
// For each block `Farthest` is at least as far as any depth stored in it: drawing a block finds the farthest that it leaves
// behind, and whatever others draw only comes nearer. A triangle is hidden in a block if neither its plane at the block's
// corners nor its nearest vertex is nearer than that. What decides is conservative, so that the planes are bit for bit those
// without blocks; rounding to float32 is monotone, so it is enough that no pixel's double is nearer than the float32 that is compared.
// * Doubles: pixels and corners are evaluated from the same a0, gx, gy, in any order with at most 16 u S between them and the real plane,
//   S = |a0| + |gx| (|x0| + width) + |gy| (|y0| + height), u = 2^-53; the margin is 2^-48 S = 32 u S.
// * Blocks beside one another are compared in float32: c, the least of the first one, rounded, and d i, i blocks on. With |d i| <= R the
//   roundings of c, d, d i and their sum are at most 2^-24 (2 |c| + 4 R) (1 + 2^-20), or 2^-149 each where they underflow; the margin is
//   2^-21 (|c| + R) + 2^-140. Nothing overflows: what has S >= 2^100 is never hidden.
// Depths that are not numbers hide nothing, are passed by nothing and count for nothing.
#if defined(RASTERDIFF_VALUE_BLOCKS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RASTERDIFF_VALUE_BLOCKS_INL_H
#undef RASTERDIFF_VALUE_BLOCKS_INL_H
#else
#define RASTERDIFF_VALUE_BLOCKS_INL_H
#endif

#include <algorithm>
#include <cmath>
#include <limits>

#include "rasterizer/kernels/value_seen-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rasterdiff::rasterizer {
namespace HWY_NAMESPACE {

using BlockF = hn::CappedTag<float, kBlocksOfLong>;
inline constexpr size_t kBlockLanes = hn::MaxLanes(BlockF());

/// Sets up the kLanes triangles from place `base` on, which have their planes, for tests of blocks if not all are small.
HWY_INLINE void SetUpTests(const ValueView& view, size_t base, ValueBatch& b) {
  const D d;
  const auto way = hn::Load(DU(), b.way + base);
  if (HWY_LIKELY(hn::AllTrue(DU(), hn::Lt(way, hn::Set(DU(), kMedium))))) return;
  const hn::Rebind<float, D> f;
  const V gx = hn::Load(d, b.gx + base), gy = hn::Load(d, b.gy + base), zero = hn::Zero(d), length = hn::Set(d, kBlock - 1);
  const V x = hn::Abs(hn::Load(d, b.x0 + base)) + hn::Set(d, view.width + kBlock * kBlocksOfLong);
  const V y = hn::Abs(hn::Load(d, b.y0 + base)) + hn::Set(d, view.endRow + kBlock);
  const V sum = hn::Abs(hn::Load(d, b.a0 + base)) + hn::Abs(gx) * x + hn::Abs(gy) * y;
  const V margin = hn::IfThenElse(hn::Lt(sum, hn::Set(d, 0x1p100)), sum * hn::Set(d, 0x1p-48), hn::Set(d, std::numeric_limits<double>::infinity()));
  const V columns = hn::Load(d, b.endColumn + base) - hn::Load(d, b.firstColumn + base);
  hn::Store((hn::Min(gx * length, zero) + hn::Min(gy * length, zero)) - margin, d, b.low + base);
  hn::Store(hn::Abs(gx) * (columns + hn::Set(d, kBlock * kBlocksOfLong)), d, b.reach + base);
  hn::Store(RoundToFloat(gx * hn::Set(d, kBlock)), f, b.step + base);
  hn::Store(RoundToFloat(hn::Load(d, b.nearest + base) - margin), f, b.nearestSeen + base);
}

/// What tests of blocks of `width` pixels ask of one triangle at one sample.
struct BlockPlane {
  double a0, gx, gy, fromX, fromY;  // value = (a0 + gy (y + fromY)) + gx (x + fromX)
  double width, low;                // `low` is added to the value at the first pixel of a block: no pixel is nearer
  double reach;                     // R: |gx| times the width of all blocks that the triangle touches, or more
  float step, nearest;              // what gx adds from block to block; no pixel is nearer
};

HWY_INLINE BlockPlane PlaneOf(const ValueView& view, const ValueBatch& b, size_t i, size_t s) {
  return {b.a0[i], b.gx[i], b.gy[i], view.x[s] / 256 - b.x0[i], view.y[s] / 256 - b.y0[i], kBlock, b.low[i], b.reach[i], b.step[i], b.nearestSeen[i]};
}

HWY_INLINE BlockPlane LongPlaneOf(BlockPlane plane) {
  plane.width *= kBlocksOfLong, plane.step *= kBlocksOfLong;
  plane.low += std::min(plane.gx * (kBlock * (kBlocksOfLong - 1)), 0.0);
  return plane;
}

/// The blocks that a triangle touches in each of kLanes block rows: the first one, how many, and what no pixel of the first is nearer than.
struct TouchedBlocks {
  V first, size;
  hn::Vec<hn::Rebind<float, D>> least;
};

/// Those of the block rows that begin at pixel rows `y`. A line is monotone in the row as it is computed, too: where it is farthest out, the row is
/// the first or the last one of a block.
HWY_INLINE TouchedBlocks FindTouched(const RowLines& lines, const RowOffsets& offsets, double firstRow, double endRow, V y, const BlockPlane& plane) {
  const D d;
  const V firstPixels = hn::Max(y, hn::Set(d, firstRow)), lastPixels = hn::Min(y + hn::Set(d, kBlock - 1), hn::Set(d, endRow - 1));
  const auto at = [&](size_t k, V r) { return hn::MulAdd(lines.slope[k], r, offsets.of[k]); };
  const auto least = [&](size_t k) { return hn::Min(at(k, firstPixels), at(k, lastPixels)); };
  const auto most = [&](size_t k) { return hn::Max(at(k, firstPixels), at(k, lastPixels)); };
  const V from = hn::Min(hn::Round(hn::Max(hn::Max(least(0), least(1)), lines.firstColumn)), lines.endColumn);
  const V to = hn::Round(hn::Min(hn::Min(most(2), most(3)), lines.endColumn));
  const V perPixel = hn::Set(d, 1 / plane.width), first = hn::Floor(from * perPixel), size = hn::Ceil(to * perPixel) - first;
  const V x = first * hn::Set(d, plane.width);
  const V row = hn::Set(d, plane.a0) + hn::Set(d, plane.gy) * (y + hn::Set(d, plane.fromY));
  const V corner = row + hn::Set(d, plane.gx) * (x + hn::Set(d, plane.fromX));
  const V low = corner + hn::Set(d, plane.low), margin = hn::Set(d, 0x1p-21) * (hn::Abs(low) + hn::Set(d, plane.reach)) + hn::Set(d, 0x1p-140);
  return {first, hn::IfThenElseZero(hn::Lt(from, to), size), RoundToFloat(low - margin)};
}

/// The nearest depths of kBlockLanes blocks from the n-th on, if `least` is that of the first.
HWY_INLINE hn::Vec<BlockF> NearestOf(float step, float nearest, float least, float n) {
  const BlockF f;
  return hn::Max(hn::MulAdd(hn::Set(f, step), hn::Iota(f, 0) + hn::Set(f, n), hn::Set(f, least)), hn::Set(f, nearest));
}

/// Which of kBlockLanes blocks may be seen, of those before `size`.
template <class P>
HWY_INLINE hn::Mask<BlockF> Seen(hn::Vec<BlockF> nearest, float size, const float* HWY_RESTRICT far) {
  const BlockF f;
  const auto there = hn::LoadU(f, far);
  const auto hidden = P::kMeets ? hn::Gt(nearest, there) : hn::Ge(nearest, there);
  return hn::AndNot(hidden, hn::Lt(hn::Iota(f, 0), hn::Set(f, size)));
}

/// Appends the blocks of `which` to a list; `code`: the first one's, without the depth.
HWY_INLINE void AppendBlocks(hn::Vec<BlockF> nearest, hn::Mask<BlockF> which, uint64_t code, uint64_t* HWY_RESTRICT codes, size_t& size) {
#if HWY_TARGET <= HWY_AVX3
  const DU du;
  const auto depth = hn::ShiftLeft<32>(hn::PromoteTo(du, hn::BitCast(hn::Rebind<uint32_t, DU>(), nearest)));
  Append(hn::Or(NumbersFrom(du, code), depth), M{which.raw}, codes, size);
#else
  const BlockF f;
  alignas(32) uint32_t depth[kBlockLanes];
  uint8_t bits[8] = {};
  hn::Store(hn::BitCast(hn::RebindToUnsigned<BlockF>(), nearest), hn::RebindToUnsigned<BlockF>(), depth);
  hn::StoreMaskBits(f, which, bits);
  for (size_t lane = 0; lane < kBlockLanes; ++lane) {
    codes[size] = (code + lane) | uint64_t{depth[lane]} << 32;
    size += bits[0] >> lane & 1;
  }
#endif
}

}  // namespace HWY_NAMESPACE
}  // namespace rasterdiff::rasterizer
HWY_AFTER_NAMESPACE();
#endif
