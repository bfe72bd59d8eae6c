// From triangles to lines: a vector of triangles at a time, for the instruction set being compiled. Decides also which
// loop of span_blocks-inl.h draws a triangle; draws nothing itself.
//
// The lines. Sort the vertices by y. The long edge A (top to bottom vertex) bounds a triangle on one side, the edges B
// (top to middle) and C (middle to bottom) on the other. In row r (sample at y = 256 r + sy) the first pixel whose sample
// (x = 256 c + sx) is not left of a line through (xa, ya) with direction (dx, dy), dy > 0, is ceil(N / D) with integers
//   N = (xa - sx) dy + (256 r + sy - ya) dx,  D = 256 dy.
// As a left bound the line owns its ties, as a right bound it does not: [ceil(N/D), ceil(N'/D')) is the same ceiling on
// both sides, and the top-left rule has vanished. As N is an integer, ceil(N/D) = ceil((N - 1/2)/D), and (N - 1/2)/D is
// at least 1/(2D) away from every integer. [choice:tie-owner]
// The kernel evaluates t = slope·r + offset in doubles, slope = dx/dy, offset = (N(0) - 1/2)/D + 1/2; then ceil(N/D) is t
// rounded to nearest, and t is at least g = 1/(2D) = 2^-9/dy away from a tie of that rounding.
//
// The proof. Let all |coordinates| <= 2^22 (kFastRange: 16,384 px) and u = 2^-53. Rows r and pixels count from the corner of
// the first block that the triangle touches inside the target: 0 <= r < 2^14 + 16.
// Exact in doubles: differences of coordinates (<= 2^23 + 2^8), products (< 2^47), N(0) (< 2^48), N(0) - 1/2, scaling by 1/256.
// Roundings, each u times the size of its result: q = fl(1/dy) one; slope = dx q two in all, which reach t as 2|slope·r|;
// offset = (N(0) - 1/2)(q/256) + 1/2 three, together 3(|offset| + 1). Then t, in one of two ways:
//   at once: slope·r one (an instruction set with FMA skips it, which only helps), the sum one;
//   in steps (span_medium-inl.h), r = 8k + j, j < 8, from the left x of a window: slope·8k one, start = slope·8k + offset one,
//   start - x one, slope·j one, the sum one.
// With |slope·r| <= |t| + |offset|, |start| <= |t| + 7|slope| and 0 <= x < 2^15 the second way is the worse one:
//   error <= u (6|t| + 6|offset| + 28|slope| + 2^15 + 3), up to factors 1 + 2^-50.
//   |offset| <= (2^15 + 1)(1 + 2^23/dy), from |xa - 256 X0| <= 2^23 + 2^8 and |256 Y0 + sy - ya| <= 2^23 + 2^8, |dx| <= 2^23.
// Windows end before 2^14 + 64 px, and what lies outside a window is clamped to its side. So either |t| <= 2^14 + 128 and
//   dy·error <= 2^-53 (2^39.7 + 2^41.6 + 2^28 + 2^38.1) < 2^-11, less than g·dy = 2^-9 with dy <= 2^23: the rounding is right;
// or |t| is larger and the error is below 2^-10 (1 + |t|/2^40): it stays on its side. Where t itself is moved to a window, that
// is done after rounding (in integers), or exactly: t and x are multiples of the last bit of t where t - x > 0, else it is clamped.
// Beyond kFastRange a triangle goes to integer_spans.cpp. span_kernel_test.cpp looks for flips at these limits.
#if defined(RASTERDIFF_SPAN_SETUP_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RASTERDIFF_SPAN_SETUP_INL_H
#undef RASTERDIFF_SPAN_SETUP_INL_H
#else
#define RASTERDIFF_SPAN_SETUP_INL_H
#endif

#include <cstdint>

#include "hwy/highway.h"
#include "rasterizer/kernels/snapped_triangle.hpp"
#include "rasterizer/kernels/span_target.hpp"

HWY_BEFORE_NAMESPACE();
namespace rasterdiff::rasterizer {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using D = hn::CappedTag<double, 8>;
using DI = hn::Rebind<int32_t, D>;
using DU = hn::RebindToUnsigned<D>;
using V = hn::Vec<D>;
using M = hn::Mask<D>;
inline constexpr size_t kLanes = hn::MaxLanes(D());

/// Consecutive numbers from `first` on. Highway's Iota with a number that no compiler knows is stored in parts and loaded as a
/// whole, and waits for that.
template <class T>
HWY_INLINE hn::Vec<T> NumbersFrom(T d, hn::TFromD<T> first) {
  return hn::Iota(d, 0) + hn::Set(d, first);
}

inline constexpr double kFastRange = 4194304;  // 2^22, in 1/256 pixel
inline constexpr double kSteep = 1048576;      // slope of the line that stands for a horizontal edge: ±kSteep/2 is off every target

inline constexpr double kMediumWidth = 256.0 * 192;          // subpixels; beyond, filling whole windows pays
inline constexpr size_t kGroups = 16;                         // of kLanes block rows, for a medium triangle
inline constexpr double kGroupRows = 8.0 * double{kLanes};   // pixels

/// Shapes of blocks for narrow triangles, see span_narrow-inl.h: 32 pixels by 16 rows, 64 by 8.
inline constexpr size_t kTallShape = 0, kWideShape = 1;
inline constexpr double kNarrowRows = 160;                      // or more, otherwise what one costs is more than it saves
inline constexpr double kNarrow[2] = {14, 30};                  // pixels in a block's rows
inline constexpr double kHeight[2] = {256.0 * 1008, 1048576};   // subpixels
inline constexpr double kReach[2] = {1048576, kFastRange};

/// Lines and classes of up to kSize triangles; index = place in the batch.
template <size_t kSamples>
struct Batch {
  static constexpr size_t kCapacity = kSamples == 0 ? 16 : kSamples;  // samples
  static constexpr size_t kSize = kCapacity == 1 ? 256 : 64;          // triangles
  struct List {
    size_t size = 0;
    uint64_t places[kSize + 8];
  };
  alignas(64) double slope[3][kSize];              // A, B, C in pixels a row
  alignas(64) double offset[kCapacity][3][kSize];  // pixels from the first block's corner, + 1/2
  alignas(64) int32_t block[kSize];                // words from the mask's start to the first block
  alignas(64) int32_t firstRow[kSize], endRow[kSize];  // clipped box, pixels
  alignas(64) double columns[kSize], rows[kSize];      // pixels from the first block's corner to the box's end
  struct Long {
    size_t size = 0;
    uint64_t places[kSize * kGroups + 8];
  };
  // Places in the batch by class and side (0: A is the left bound, 1: the right bound).
  List small[4][2];  // in one block column; which reach the first, second, third, fourth block row
  Long medium[2];  // nowhere wider than kMediumWidth: group of kLanes block rows << 16 | place
  List large[2];
  List narrow[2][2];  // by shape of their blocks and side, see span_narrow-inl.h
  List far;           // beyond the fast range
  // Of narrow ones: the vertices' y in subpixels, sorted; half columns from the first block to the target's left (<= 0); from line
  // A's t in the first row of a block to where the block begins, in halves of its width.
  alignas(64) double y[3][kSize], leastColumn[kSize], reach[kSize];

  void Clear() {
    for (size_t side = 0; side < 2; ++side)
      for (List* list : {&small[0][side], &small[1][side], &small[2][side], &small[3][side], &large[side]}) list->size = 0;
    medium[0].size = medium[1].size = 0;
    narrow[0][0].size = narrow[0][1].size = narrow[1][0].size = narrow[1][1].size = 0;
    far.size = 0;
  }
};

struct Corners {
  V x[3], y[3];
};

HWY_INLINE Corners LoadCorners(const SnappedTriangle* HWY_RESTRICT t) {
  const D d;
  Corners c;
#if HWY_TARGET <= HWY_AVX3
  const hn::RebindToSigned<D> di;
  hn::Vec<decltype(di)> v[3];
  hn::LoadInterleaved3(di, reinterpret_cast<const int64_t*>(t), v[0], v[1], v[2]);
  for (int i = 0; i < 3; ++i) {
    c.x[i] = hn::ConvertTo(d, hn::ShiftRight<32>(hn::ShiftLeft<32>(v[i])));
    c.y[i] = hn::ConvertTo(d, hn::ShiftRight<32>(v[i]));
  }
#else
  const DI di;
  alignas(64) int32_t x[3][kLanes], y[3][kLanes];
  for (size_t lane = 0; lane < kLanes; ++lane)
    for (size_t i = 0; i < 3; ++i) x[i][lane] = t[lane].v[i].x, y[i][lane] = t[lane].v[i].y;
  for (size_t i = 0; i < 3; ++i) {
    c.x[i] = hn::PromoteTo(d, hn::Load(di, x[i]));
    c.y[i] = hn::PromoteTo(d, hn::Load(di, y[i]));
  }
#endif
  return c;
}

HWY_INLINE void SortByY(Corners& c, int i, int j) {
  const M swap = hn::Lt(c.y[j], c.y[i]);
  const V low = hn::Min(c.y[i], c.y[j]), high = hn::Max(c.y[i], c.y[j]);
  const V xi = hn::IfThenElse(swap, c.x[j], c.x[i]), xj = hn::IfThenElse(swap, c.x[i], c.x[j]);
  c.y[i] = low, c.y[j] = high, c.x[i] = xi, c.x[j] = xj;
}

/// Fetches what a later turn of a loop over kLanes triangles will load. A processor does not: the loop pauses for each batch that
/// is drawn. Behind the last triangle it does nothing.
template <class T>
HWY_INLINE void PrefetchAhead(const T* from, size_t each = 1) {
  constexpr size_t kAhead = 128, kLine = 64;  // triangles, bytes
  const auto* at = reinterpret_cast<const char*>(from + kAhead * each);
  for (size_t byte = 0; byte < kLanes * each * sizeof(T); byte += kLine) __builtin_prefetch(at + byte);
}

HWY_INLINE void StoreInt(V v, int32_t* HWY_RESTRICT to) { hn::Store(hn::DemoteTo(DI(), v), DI(), to); }

/// Appends the lanes of `mask`, without a branch; `list` has room for kLanes more than it holds.
HWY_INLINE void Append(hn::Vec<DU> values, M mask, uint64_t* HWY_RESTRICT list, size_t& size) {
#if HWY_TARGET <= HWY_AVX3
  _mm512_storeu_si512(list + size, _mm512_maskz_compress_epi64(mask.raw, values.raw));
  size += static_cast<size_t>(__builtin_popcount(mask.raw));
#else
  alignas(64) uint64_t value[kLanes], bits[kLanes];
  hn::Store(values, DU(), value);
  hn::Store(hn::BitCast(DU(), hn::VecFromMask(D(), mask)), DU(), bits);
  for (size_t lane = 0; lane < kLanes; ++lane) {
    list[size] = value[lane];
    size += bits[lane] & 1;
  }
#endif
}

/// Those of the lanes `which`, set up otherwise, that span_narrow-inl.h can draw: appends them to its lists. A function of its
/// own, for most triangles need nothing of it.
template <size_t kSamples>
HWY_NOINLINE M SetUpNarrow(const SnappedTriangle* HWY_RESTRICT t, size_t base, M which, const SpanTarget& target, Batch<kSamples>& b) {
  const D d;
  Corners c = LoadCorners(t);
  const V zero = hn::Zero(d), one = hn::Set(d, 1), pixel = hn::Set(d, 1.0 / 256);
  const V minX = hn::Min(hn::Min(c.x[0], c.x[1]), c.x[2]), maxX = hn::Max(hn::Max(c.x[0], c.x[1]), c.x[2]);
  SortByY(c, 0, 1);
  SortByY(c, 1, 2);
  SortByY(c, 0, 1);
  const V dyA = c.y[2] - c.y[0], area = (c.x[1] - c.x[0]) * dyA - (c.x[2] - c.x[0]) * (c.y[1] - c.y[0]);
  const V slopeA = hn::Load(d, b.slope[0] + base), widest = hn::Abs(area) * pixel / dyA;
  const V reach = hn::Max(hn::Max(hn::Neg(minX), maxX), hn::Max(hn::Neg(c.y[0]), c.y[2]));
  const auto fits = [&](size_t shape, double rows) {
    const M narrow = hn::Le(hn::MulAdd(hn::Abs(slopeA), hn::Set(d, rows - 1), widest), hn::Set(d, kNarrow[shape]));
    return hn::And(narrow, hn::And(hn::Le(reach, hn::Set(d, kReach[shape])), hn::Le(dyA, hn::Set(d, kHeight[shape]))));
  };
  const M inside = hn::And(hn::Ge(minX, zero), hn::Le(maxX, hn::Set(d, 256 * target.width)));
  const M narrow = hn::And(hn::And(which, hn::Ne(area, zero)), hn::And(inside, fits(kWideShape, 8)));
  const M tall = hn::And(narrow, fits(kTallShape, 16));
  const M side0 = hn::Gt(area, zero);
  for (size_t k = 0; k < 3; ++k) hn::Store(c.y[k], d, b.y[k] + base);
  const V endColumn = hn::Min(hn::Ceil((maxX - hn::Set(d, target.minX)) * pixel), hn::Set(d, target.width));
  hn::Store((hn::Load(d, b.columns + base) - endColumn) * hn::Set(d, 1.0 / 32), d, b.leastColumn + base);
  const V least = hn::Min(slopeA * hn::IfThenElse(tall, hn::Set(d, 15), hn::Set(d, 7)), zero) - hn::IfThenZeroElse(side0, widest);
  hn::Store((least - one) * hn::IfThenElse(tall, hn::Set(d, 1.0 / 16), hn::Set(d, 1.0 / 32)), d, b.reach + base);
  const auto places = hn::Iota(DU(), 0) + hn::Set(DU(), base);
  for (size_t shape = 0; shape < 2; ++shape) {
    const M those = shape == kTallShape ? tall : hn::AndNot(tall, narrow);
    Append(places, hn::And(those, side0), b.narrow[shape][0].places, b.narrow[shape][0].size);
    Append(places, hn::AndNot(side0, those), b.narrow[shape][1].places, b.narrow[shape][1].size);
  }
  return narrow;
}

/// Sets up the kLanes triangles from `t` as places `base` and following.
template <size_t kSamples>
HWY_INLINE void SetUp(const SnappedTriangle* HWY_RESTRICT t, size_t base, const SpanTarget& target, Batch<kSamples>& b) {
  const D d;
  Corners c = LoadCorners(t);
  const V minX = hn::Min(hn::Min(c.x[0], c.x[1]), c.x[2]), maxX = hn::Max(hn::Max(c.x[0], c.x[1]), c.x[2]);
  SortByY(c, 0, 1);
  SortByY(c, 1, 2);
  SortByY(c, 0, 1);
  const V zero = hn::Zero(d), half = hn::Set(d, 0.5), pixel = hn::Set(d, 1.0 / 256);

  // The box of samples, clipped.
  const V firstRow = hn::Max(hn::Ceil((c.y[0] - hn::Set(d, target.maxY)) * pixel), zero);
  const V endRow = hn::Min(hn::Ceil((c.y[2] - hn::Set(d, target.minY)) * pixel), hn::Set(d, target.height));
  const V firstColumn = hn::Max(hn::Ceil((minX - hn::Set(d, target.maxX)) * pixel), zero);
  const V endColumn = hn::Min(hn::Ceil((maxX - hn::Set(d, target.minX)) * pixel), hn::Set(d, target.width));
  const V blockRow = hn::Floor(firstRow * hn::Set(d, 1.0 / 8));
  const V cornerY = blockRow * hn::Set(d, 8), down = endRow - cornerY;  // rows from the first block
  const V dxA = c.x[2] - c.x[0], dyA = c.y[2] - c.y[0];
  const V dxB = c.x[1] - c.x[0], dyB = c.y[1] - c.y[0];
  const V dxC = c.x[2] - c.x[1], dyC = c.y[2] - c.y[1];
  const V area = dxB * dyA - dxA * dyB;  // exact: < 2^47 within the fast range; > 0 where A is on the left

  // The widest row is that of the middle vertex: |area| / dyA subpixels.
  const M large = hn::Or(hn::Gt(hn::Abs(area), dyA * hn::Set(d, kMediumWidth)), hn::Gt(down, hn::Set(d, kGroups * kGroupRows)));
  // Those need whole windows, where the full bits are; others begin at any half column.
  const V evenColumn = hn::Floor(firstColumn * hn::Set(d, 1.0 / 64)) * hn::Set(d, 2);
  const V halfColumn = hn::IfThenElse(large, evenColumn, hn::Floor(firstColumn * hn::Set(d, 1.0 / 32)));
  const V cornerX = halfColumn * hn::Set(d, 32);

  const V reach = hn::Max(hn::Max(hn::Neg(minX), maxX), hn::Max(hn::Neg(c.y[0]), c.y[2]));
  const M inBox = hn::And(hn::Lt(firstRow, endRow), hn::Lt(firstColumn, endColumn));
  const M near = hn::Le(reach, hn::Set(d, kFastRange));
  const M alive = hn::And(hn::And(inBox, near), hn::Ne(area, zero));

  const V qA = hn::Set(d, 1.0) / dyA, qB = hn::Set(d, 1.0) / dyB, qC = hn::Set(d, 1.0) / dyC;
  const M flatTop = hn::Eq(dyB, zero), flatBottom = hn::Eq(dyC, zero);
  const V steep = hn::CopySign(hn::Set(d, kSteep), area);
  hn::Store(dxA * qA, d, b.slope[0] + base);
  hn::Store(hn::IfThenElse(flatTop, steep, dxB * qB), d, b.slope[1] + base);
  hn::Store(hn::IfThenElse(flatBottom, hn::Neg(steep), dxC * qC), d, b.slope[2] + base);

  // Vertices relative to the corner of the first block: A and B pass through v0, C through v2.
  const V k256 = hn::Set(d, 256);
  const V x0 = c.x[0] - cornerX * k256, y0 = cornerY * k256 - c.y[0];
  const V x2 = c.x[2] - cornerX * k256, y2 = cornerY * k256 - c.y[2];
  const V pA = qA * pixel, pB = qB * pixel, pC = qC * pixel;
  const size_t samples = kSamples == 0 ? target.samples : kSamples;
  for (size_t s = 0; s < samples; ++s) {
    const V sx = hn::Set(d, target.x[s]), sy = hn::Set(d, target.y[s]);
    const V ax = x0 - sx, ay = y0 + sy, bx = x2 - sx, by = y2 + sy;
    const V nA = hn::MulAdd(ax, dyA, ay * dxA), nB = hn::MulAdd(ax, dyB, ay * dxB), nC = hn::MulAdd(bx, dyC, by * dxC);
    const V top = hn::Ceil(hn::Neg(ay) * pixel), bottom = hn::Ceil(hn::Neg(by) * pixel);  // rows of v0 and v2
    const V offsetA = hn::MulAdd(nA - half, pA, half);
    const V offsetB = hn::IfThenElse(flatTop, steep * (half - top), hn::MulAdd(nB - half, pB, half));
    const V offsetC = hn::IfThenElse(flatBottom, steep * (bottom - half), hn::MulAdd(nC - half, pC, half));
    hn::Store(offsetA, d, b.offset[s][0] + base);
    hn::Store(offsetB, d, b.offset[s][1] + base);
    hn::Store(offsetC, d, b.offset[s][2] + base);
  }
  StoreInt(hn::MulAdd(blockRow, hn::Set(d, target.rowWords), halfColumn * hn::Set(d, target.blockWords)), b.block + base);
  StoreInt(firstRow, b.firstRow + base);
  StoreInt(endRow, b.endRow + base);
  const V across = endColumn - cornerX;  // columns from the first block
  hn::Store(across, d, b.columns + base);
  hn::Store(down, d, b.rows + base);

  const M small = hn::And(hn::Le(across, hn::Set(d, 64)), hn::Le(down, hn::Set(d, 32)));
  const M side0 = hn::And(alive, hn::Gt(area, zero)), side1 = hn::And(alive, hn::Lt(area, zero));
  const auto places = hn::Iota(DU(), 0) + hn::Set(DU(), base);
  const auto appendSmall = [&](size_t reached, M which) {
    Append(places, hn::And(side0, which), b.small[reached][0].places, b.small[reached][0].size);
    Append(places, hn::And(side1, which), b.small[reached][1].places, b.small[reached][1].size);
  };
  appendSmall(0, small);
  appendSmall(1, hn::And(small, hn::Gt(down, hn::Set(d, 8))));
  const M third = hn::And(small, hn::Gt(down, hn::Set(d, 16)));
  if (HWY_UNLIKELY(!hn::AllFalse(d, third))) {
    appendSmall(2, third);
    appendSmall(3, hn::And(small, hn::Gt(down, hn::Set(d, 24))));
  }
  M rest = hn::AndNot(hn::And(small, near), inBox);
  if (HWY_LIKELY(hn::AllFalse(d, rest))) return;
  const V moved = hn::MulAdd(hn::Abs(dxA), hn::Set(d, 7), hn::Abs(area) * pixel);  // in a block's rows, times dyA
  const M narrow = hn::And(hn::And(rest, hn::Ge(down, hn::Set(d, kNarrowRows))), hn::Le(moved, dyA * hn::Set(d, kNarrow[kWideShape])));
  if (HWY_UNLIKELY(!hn::AllFalse(d, narrow))) rest = hn::AndNot(SetUpNarrow(t, base, hn::And(narrow, alive), target, b), rest);
  for (size_t side = 0; side < 2; ++side) {
    const M moderate = hn::AndNot(large, hn::And(rest, side == 0 ? side0 : side1));
    V group = hn::Set(d, kGroupRows);
    auto code = places;
    M more = moderate;
    // Two groups without asking: whether there is a second one changes too often to be predicted.
    for (size_t k = 0; k < 2 || HWY_UNLIKELY(!hn::AllFalse(d, more)); ++k) {
      Append(code, more, b.medium[side].places, b.medium[side].size);
      code = code + hn::Set(DU(), uint64_t{1} << 16);
      more = hn::And(moderate, hn::Gt(down, group));
      group = group + hn::Set(d, kGroupRows);
    }
  }
  if (HWY_UNLIKELY(!hn::AllFalse(d, hn::And(rest, large)))) {
    Append(places, hn::And(hn::And(rest, large), side0), b.large[0].places, b.large[0].size);
    Append(places, hn::And(hn::And(rest, large), side1), b.large[1].places, b.large[1].size);
  }
  if (HWY_UNLIKELY(!hn::AllTrue(d, near))) Append(places, hn::AndNot(near, inBox), b.far.places, b.far.size);
}

}  // namespace HWY_NAMESPACE
}  // namespace rasterdiff::rasterizer
HWY_AFTER_NAMESPACE();
#endif
