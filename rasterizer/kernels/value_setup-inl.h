// From triangles to lines and depth planes: a vector of triangles at a time, for the instruction set being compiled. Lines, their
// exactness and its proof are those of span_setup-inl.h, with rows and pixels counted from the target's corner.
//
// The planes. A depth, linear on the screen, is a0 + gx (x - x0) + gy (y - y0), anchored at vertex 0, with
//   gx = (d1 e2y - d2 e1y) / det, gy = (d2 e1x - d1 e2x) / det, d = differences of values, e = differences of positions.
// Within the fast range (|coordinates| <= 2^22) the e (< 2^24) and det = e1x e2y - e1y e2x (< 2^49) are exact in doubles, and
// so are all distances from the anchor, multiples of 1/256 pixel. With u = 2^-53, Gx = (|d1 e2y| + |d2 e1y|) / |det| per
// pixel and Gy likewise, roundings are: difference, product, sum, 256 / det, product: |error of gx| <= 5u Gx, up to 1 + 2^-50.
// The value at pixel X + i of row y (X: first pixel of a chunk of eight, i < 8) is
//   row = a0 + gy (y - y0);  chunk = row + gx (X - x0);  value = chunk + gx i
// with a product and a sum each: 6u of each product, and u of each of three sums. All that is summed is at most
//   M = |a0| + Gx (|x - x0| + 14) + Gy |y - y0|,   so |error| <= 6u M + 3u M < 2^-49 M: linearValueBound.
// The float32 is that double rounded once: half a unit in the last place more. No operation is fused, so that every
// instruction set rounds alike; a pixel's value depends on nothing but its triangle.
//
// Planes through DepthCorners are those of the reference, operation by operation, so that both have the same bits: gradients are
// divided by det, and the value at a sample is (a0 + gx (x - x0)) + gy (y - y0).
#if defined(RASTERDIFF_VALUE_SETUP_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RASTERDIFF_VALUE_SETUP_INL_H
#undef RASTERDIFF_VALUE_SETUP_INL_H
#else
#define RASTERDIFF_VALUE_SETUP_INL_H
#endif

#include <algorithm>
#include <limits>

#include "hwy/highway.h"
#include "rasterizer/kernels/span_setup-inl.h"
#include "rasterizer/kernels/value_view.hpp"

HWY_BEFORE_NAMESPACE();
namespace rasterdiff::rasterizer {
namespace HWY_NAMESPACE {

inline constexpr double kWidePixels = 128, kMediumPixels = 16;  // lengths of the longest row
inline constexpr double kMediumArea = 256;                     // pixels
inline constexpr double kTinyRows = 4, kTinyPixels = 7.5;      // rows, and the length of the longest one, which covers no more than 8 centres
inline constexpr double kHighRows = 48;                        // rows of a small one, for a function of its own

/// Which way a triangle is drawn: without a depth test all are small or tiny; tiny are all of a vector or none.
inline constexpr uint64_t kSmall = 0, kTiny = 1, kMedium = 2, kWide = 3;

/// Lines and depth planes of up to kSize triangles; index = place in the batch.
struct ValueBatch {
  static constexpr size_t kSize = 64, kSamples = 16;
  alignas(64) double slope[4][kSize];             // left, left, right, right bound, in pixels a row
  alignas(64) double offset[kSamples][4][kSize];  // pixels, + 1/2
  // Depth: the plane's anchor (pixels) and gradients (a pixel), the nearest vertex.
  alignas(64) double a0[kSize], x0[kSize], y0[kSize], gx[kSize], gy[kSize], nearest[kSize];
  alignas(64) double firstColumn[kSize], endColumn[kSize], firstRow[kSize], endRow[kSize];  // clipped box
  bool listed = false;         // triangles are those of a list, otherwise neighbours
  uint32_t triangles[kSize];  // places in ValueTriangles; of neighbours the first one only
  size_t size = 0;
  uint64_t places[kSize + 8];  // of what is to be drawn, in order
  alignas(64) uint64_t far[kSize];   // ~0: beyond the fast range
  alignas(64) uint64_t way[kSize];  // kSmall, kTiny, kMedium or kWide
  uint8_t drawn[kSize / kLanes];    // of a vector of tiny triangles: bits of those to be drawn
  // Of triangles that are not small, see value_blocks-inl.h.
  alignas(64) double low[kSize], reach[kSize];
  alignas(64) float step[kSize], nearestSeen[kSize];
  // What all that was set up so far may draw, a vector of boxes.
  alignas(64) double left[kLanes], top[kLanes], right[kLanes], bottom[kLanes];
  alignas(64) uint64_t anyFar[kLanes];

  ValueBatch() {
    std::fill_n(left, kLanes, kFastRange), std::fill_n(top, kLanes, kFastRange);
    std::fill_n(right, kLanes, 0.0), std::fill_n(bottom, kLanes, 0.0);
    std::fill_n(anyFar, kLanes, uint64_t{0});
  }
};

HWY_INLINE DrawnArea AreaOf(const ValueBatch& b) {
  const auto pixel = [](double v) { return static_cast<uint32_t>(v); };
  return {pixel(*std::min_element(b.left, b.left + kLanes)), pixel(*std::min_element(b.top, b.top + kLanes)),
          pixel(*std::max_element(b.right, b.right + kLanes)), pixel(*std::max_element(b.bottom, b.bottom + kLanes)),
          std::any_of(b.anyFar, b.anyFar + kLanes, [](uint64_t far) { return far != 0; })};
}

HWY_INLINE void SetUpCornerPlanes(const DepthCorners* HWY_RESTRICT corners, size_t base, ValueBatch& b) {
  const D d;
  alignas(64) double x[3][kLanes], y[3][kLanes], z[3][kLanes];
  for (size_t lane = 0; lane < kLanes; ++lane)
    for (size_t i = 0; i < 3; ++i) x[i][lane] = corners[lane].x[i], y[i][lane] = corners[lane].y[i], z[i][lane] = corners[lane].z[i];
  const V x0 = hn::Load(d, x[0]), y0 = hn::Load(d, y[0]), a0 = hn::Load(d, z[0]);
  const V e1x = hn::Load(d, x[1]) - x0, e1y = hn::Load(d, y[1]) - y0, e2x = hn::Load(d, x[2]) - x0, e2y = hn::Load(d, y[2]) - y0;
  const V d1 = hn::Load(d, z[1]) - a0, d2 = hn::Load(d, z[2]) - a0, determinant = e1x * e2y - e1y * e2x;
  const M inLine = hn::Eq(determinant, hn::Zero(d));
  hn::Store(a0, d, b.a0 + base);
  hn::Store(hn::IfThenZeroElse(inLine, (d1 * e2y - d2 * e1y) / determinant), d, b.gx + base);
  hn::Store(hn::IfThenZeroElse(inLine, (d2 * e1x - d1 * e2x) / determinant), d, b.gy + base);
  hn::Store(x0, d, b.x0 + base);
  hn::Store(y0, d, b.y0 + base);
  // Samples of the triangle may lie outside of the corners.
  hn::Store(hn::Set(d, -std::numeric_limits<double>::infinity()), d, b.nearest + base);
}

/// Sets up the kLanes triangles from `t` as places `base` and following; `depth` (three a triangle) only if kDepth, `corners`
/// instead of it if kCorners.
template <bool kDepth, bool kCorners>
HWY_INLINE void SetUpValues(const SnappedTriangle* HWY_RESTRICT t, const float* HWY_RESTRICT depth, const DepthCorners* HWY_RESTRICT corners,
                            size_t base, const ValueView& view, ValueBatch& b) {
  const D d;
  const Corners given = LoadCorners(t);
  Corners c = given;
  const V minX = hn::Min(hn::Min(c.x[0], c.x[1]), c.x[2]), maxX = hn::Max(hn::Max(c.x[0], c.x[1]), c.x[2]);
  SortByY(c, 0, 1);
  SortByY(c, 1, 2);
  SortByY(c, 0, 1);
  const V zero = hn::Zero(d), half = hn::Set(d, 0.5), pixel = hn::Set(d, 1.0 / 256);
  const V firstRow = hn::Max(hn::Ceil((c.y[0] - hn::Set(d, view.maxY)) * pixel), hn::Set(d, view.firstRow));
  const V endRow = hn::Min(hn::Ceil((c.y[2] - hn::Set(d, view.minY)) * pixel), hn::Set(d, view.endRow));
  const V firstColumn = hn::Max(hn::Ceil((minX - hn::Set(d, view.maxX)) * pixel), zero);
  const V endColumn = hn::Min(hn::Ceil((maxX - hn::Set(d, view.minX)) * pixel), hn::Set(d, view.width));
  hn::Store(firstRow, d, b.firstRow + base);
  hn::Store(endRow, d, b.endRow + base);
  hn::Store(firstColumn, d, b.firstColumn + base);
  hn::Store(endColumn, d, b.endColumn + base);

  const V dxA = c.x[2] - c.x[0], dyA = c.y[2] - c.y[0];
  const V dxB = c.x[1] - c.x[0], dyB = c.y[1] - c.y[0];
  const V dxC = c.x[2] - c.x[1], dyC = c.y[2] - c.y[1];
  const V area = dxB * dyA - dxA * dyB;  // > 0 where A is on the left
  const V reach = hn::Max(hn::Max(hn::Neg(minX), maxX), hn::Max(hn::Neg(c.y[0]), c.y[2]));
  const M inBox = hn::And(hn::Lt(firstRow, endRow), hn::Lt(firstColumn, endColumn));
  const M near = hn::Le(reach, hn::Set(d, kFastRange));
  const M left = hn::Gt(area, zero);

  const V one = hn::Set(d, 1.0);
  const V qA = one / dyA, qB = one / dyB, qC = one / dyC;
  const M flatTop = hn::Eq(dyB, zero), flatBottom = hn::Eq(dyC, zero);
  const V steep = hn::CopySign(hn::Set(d, kSteep), area);
  const auto store = [&](double(*to)[ValueBatch::kSize], V lineA, V lineB, V lineC) {
    hn::Store(hn::IfThenElse(left, lineA, lineB), d, to[0] + base);
    hn::Store(hn::IfThenElse(left, lineA, lineC), d, to[1] + base);
    hn::Store(hn::IfThenElse(left, lineB, lineA), d, to[2] + base);
    hn::Store(hn::IfThenElse(left, lineC, lineA), d, to[3] + base);
  };
  store(b.slope, dxA * qA, hn::IfThenElse(flatTop, steep, dxB * qB), hn::IfThenElse(flatBottom, hn::Neg(steep), dxC * qC));

  if (kCorners) SetUpCornerPlanes(corners, base, b);
  if (kDepth && !kCorners) {
    const V e1x = given.x[1] - given.x[0], e1y = given.y[1] - given.y[0];
    const V e2x = given.x[2] - given.x[0], e2y = given.y[2] - given.y[0];
    const V q = hn::Set(d, 256.0) / (e1x * e2y - e1y * e2x);
    const hn::Rebind<float, D> df;
    hn::Vec<decltype(df)> z[3];
    hn::LoadInterleaved3(df, depth, z[0], z[1], z[2]);
    hn::Store(hn::PromoteTo(d, hn::Min(hn::Min(z[0], z[1]), z[2])), d, b.nearest + base);
    const V a0 = hn::PromoteTo(d, z[0]), d1 = hn::PromoteTo(d, z[1]) - a0, d2 = hn::PromoteTo(d, z[2]) - a0;
    hn::Store(a0, d, b.a0 + base);
    hn::Store((d1 * e2y - d2 * e1y) * q, d, b.gx + base);
    hn::Store((d2 * e1x - d1 * e2x) * q, d, b.gy + base);
    hn::Store(given.x[0] * pixel, d, b.x0 + base);
    hn::Store(given.y[0] * pixel, d, b.y0 + base);
  }
  const V pA = qA * pixel, pB = qB * pixel, pC = qC * pixel;
  for (size_t s = 0; s < view.samples; ++s) {
    const V sx = hn::Set(d, view.x[s]), sy = hn::Set(d, view.y[s]);
    // A and B pass through the top vertex, C through the bottom one.
    const V ax = c.x[0] - sx, ay = sy - c.y[0], bx = c.x[2] - sx, by = sy - c.y[2];
    const V nA = hn::MulAdd(ax, dyA, ay * dxA), nB = hn::MulAdd(ax, dyB, ay * dxB), nC = hn::MulAdd(bx, dyC, by * dxC);
    const V top = hn::Ceil(hn::Neg(ay) * pixel), bottom = hn::Ceil(hn::Neg(by) * pixel);  // rows of both
    store(b.offset[s], hn::MulAdd(nA - half, pA, half),
          hn::IfThenElse(flatTop, steep * (half - top), hn::MulAdd(nB - half, pB, half)),
          hn::IfThenElse(flatBottom, steep * (bottom - half), hn::MulAdd(nC - half, pC, half)));
  }
  hn::Store(hn::BitCast(DU(), hn::VecFromMask(d, hn::Not(near))), DU(), b.far + base);
  const M drawn = hn::And(inBox, hn::Or(hn::Not(near), hn::Ne(area, zero)));
  // The longest row is that of the middle vertex: |area| / dyA subpixels.
  const V size = hn::Abs(area);
  const auto codeOf = [](M mask, uint64_t value) { return hn::And(hn::BitCast(DU(), hn::VecFromMask(D(), mask)), hn::Set(DU(), value)); };
  auto way = hn::Zero(DU());
  if (kDepth) {
    const M wide = hn::Ge(size, hn::Set(d, 256 * kWidePixels) * dyA);
    const M medium = hn::And(hn::Ge(size, hn::Set(d, 256 * kMediumPixels) * dyA), hn::Ge(size, hn::Set(d, 2 * 65536 * kMediumArea)));
    way = hn::Or(codeOf(wide, kWide), codeOf(hn::AndNot(wide, medium), kMedium));
  }
#if HWY_TARGET <= HWY_AVX3
  const M low = hn::And(near, hn::Le(endRow - firstRow, hn::Set(d, kTinyRows)));
  const M tiny = hn::And(low, hn::Lt(size, hn::Set(d, 256 * kTinyPixels) * dyA));
  if (hn::AllFalse(d, hn::AndNot(tiny, drawn))) way = hn::Set(DU(), kTiny), b.drawn[base / kLanes] = drawn.raw;
#endif
  hn::Store(way, DU(), b.way + base);
  Append(hn::Iota(DU(), 0) + hn::Set(DU(), base), drawn, b.places, b.size);
  if (!view.shaded) return;
  const auto put = [&](double* to, V v) { hn::Store(hn::IfThenElse(drawn, v, hn::Load(d, to)), d, to); };
  put(b.left, hn::Min(firstColumn, hn::Load(d, b.left))), put(b.right, hn::Max(endColumn, hn::Load(d, b.right)));
  put(b.top, hn::Min(firstRow, hn::Load(d, b.top))), put(b.bottom, hn::Max(endRow, hn::Load(d, b.bottom)));
  hn::Store(hn::Or(hn::Load(DU(), b.anyFar), hn::BitCast(DU(), hn::VecFromMask(d, hn::AndNot(near, drawn)))), DU(), b.anyFar);
}

}  // namespace HWY_NAMESPACE
}  // namespace rasterdiff::rasterizer
HWY_AFTER_NAMESPACE();
#endif
