// Narrow triangles that are high, slivers above all: most of their rows hold a pixel or none, so that what counts is the
// work a block. They are drawn between two lines instead of three, in fixed point: the steep ones into tall blocks of 32 pixels
// by 16 rows, others into blocks of 64 by 8.
//
// Between two vertices' rows only two lines matter, and in a block that begins where the triangle does both are inside. So
// a bound is the sum of two integers modulo the block's width: the line at the block's first row (from the doubles of
// span_setup-inl.h) and what it moves in j rows, each rounded to a grid once. What a line is in rows without the triangle does not
// matter: blocks with a vertex in them have a bit for each row that is drawn.
//
// The proof, with the terms of span_setup-inl.h (g = 2^-9/dy, u = 2^-53), h rows a block, and W the width of the widest row:
// Conditions (NarrowOnes) are |slope A| (h - 1) + W <= kNarrow, |coordinates| inside the target in x, dy <= kHeight for each line.
// Another line has |dx| <= |slope A| dy + 256 W, so |slope| < 2^14; doubles that are rounded to the grid stay below 2^16 (h - 1)
// pixels where their rows count: below 2^51 units, so that adding 1.5 · 2^52 is exact but for the rounding meant. A line
// without rows, such as a horizontal edge, gives any bits, of which none is drawn.
// Roundings: two to the grid, one unit together; t' in the block's first row, with |slope·r| <= |t'| + |offset| and
// |t'| <= |t| + (h-1)|slope|, and slope·j at most (h-1)|slope|:
//   error of doubles <= u (3|slope·r| + 3(|offset| + 1) + |t'| + 3(h-1)|slope|) <= u (4|t| + 6|offset| + 7(h-1)|slope| + 3).
// 64 by 8, unit 2^-32, dy <= 2^20: dy·unit <= 2^-12, and dy·error < 2^-11 as there: less than g·dy = 2^-9.
// 32 by 16, unit 2^-27, dy <= 2^18 - 2^12, |coordinates| <= 2^20: |dx| <= 2^18, |offset| dy <= (2^18.1 + 2^20.1) 2^18 / 2^8 + 2^18 < 2^30.5,
//   |t| <= 2^12.1, so dy·error < 2^-53 (2^32.1 + 2^33.1 + 2^24.8 + 2^20) < 2^-18, with the grid 2^-9 - 2^-15 + 2^-18 < g·dy.
// So floor(t + 1/2), the rounding of span_setup-inl.h, is right. Where a block begins: at a multiple x0 of half its width, the last
// one not right of k = (least of A's t in the block's rows) - (W where A is on the right) - 1. Bounds are >= x0, and
// < k + 1 + kNarrow + 3/2 <= x0 + width.
#if defined(RASTERDIFF_SPAN_NARROW_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RASTERDIFF_SPAN_NARROW_INL_H
#undef RASTERDIFF_SPAN_NARROW_INL_H
#else
#define RASTERDIFF_SPAN_NARROW_INL_H
#endif

#include "rasterizer/kernels/span_setup-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rasterdiff::rasterizer {
namespace HWY_NAMESPACE {

using Words = hn::Vec<DU>;

/// A block's word a row, its size, and how its numbers are kept: units a pixel, and the shift that makes a pixel's lowest
/// bits the word's highest.
template <size_t kShape>
struct Shape;
template <>
struct Shape<kTallShape> {
  using Word = uint32_t;
  static constexpr size_t kRows = 16, kWidth = 32;
  static constexpr double kUnits = 134217728;  // 2^27
  static constexpr int kShift = 0;             // the low 32 bits count
};
template <>
struct Shape<kWideShape> {
  using Word = uint64_t;
  static constexpr size_t kRows = 8, kWidth = 64;
  static constexpr double kUnits = 4294967296;  // 2^32
  static constexpr int kShift = 26;
};

inline constexpr double kIntegers = 6755399441055744.0;  // 1.5 · 2^52: an integer below 2^51 added to it is in the low bits
HWY_INLINE Words Integer(V v) { return hn::BitCast(DU(), v + hn::Set(D(), kIntegers)); }

/// kLanes narrow triangles at work, rows counted from the first block that SetUp found. What is between two vertices, line A
/// and another one, is a run: numbers below kLanes are those above the middle vertex, the others are those below.
struct NarrowOnes {
  static constexpr size_t kRuns = 2 * kLanes, kBlocks = 514;  // of a triangle, one under another
  static constexpr size_t kParts = kLanes * kBlocks + kRuns * kLanes;
  // Whole blocks, run after run: their addresses, and the places of the lines in the first row.
  uint64_t block[kParts], a[kParts], x[kParts];
  alignas(64) uint64_t begin[kRuns], size[kRuns];  ///< of each run
  // Some rows of blocks.
  struct Ends {
    static constexpr size_t kSize = 5 * kLanes;
    size_t size = 0;
    uint64_t block[kSize], a[kSize], x[kSize], rows[kSize], run[kSize];  ///< a bit for each row that is drawn
  } ends;
  alignas(64) uint64_t steps[kRuns][2][8];  ///< what A and the other line move in j rows
  alignas(64) double slope[3][kLanes], offset[3][kLanes], y[3][kLanes];
  alignas(64) double start[kRuns];          ///< first row of the first block of a run
  alignas(64) double corner[kLanes];        ///< number of the block at row 0 and column 0, as if there were one
  alignas(64) double leastColumn[kLanes], reach[kLanes];  ///< half widths; k = t + reach, in them
  uint64_t groups[kParts / kLanes + kLanes];              ///< of kLanes whole blocks: run | block of it << 8
};

/// The lines of one block a lane: in its first row, and its triangle's figures.
struct NarrowLines {
  V row, a, x, corner, leastColumn, reach;
};

struct NarrowPart {
  Words block, a, x;
};

/// The blocks of a sample: how many to the next row of pixels, and the address of the first.
struct NarrowBlocks {
  V stride, samples;
  Words start;
};

template <size_t kShape, size_t kSamples>
HWY_INLINE NarrowPart PartOf(const NarrowLines& t, const NarrowBlocks& blocks) {
  using S = Shape<kShape>;
  const D d;
  const DU du;
  const V column = hn::Max(hn::Floor(hn::MulAdd(t.a, hn::Set(d, 2.0 / S::kWidth), t.reach)), t.leastColumn);
  V block = hn::MulAdd(t.row, blocks.stride, t.corner) + column;  // < 2^23
  if (kSamples != 1) block = block * blocks.samples;
  NarrowPart part;
  // Shifting leaves some bits of kIntegers, which the start takes away again.
  part.block = hn::ShiftLeft<6>(Integer(block)) + blocks.start;
  // Less column · width / 2 pixels, modulo the width. The half in the constant makes the floor of t + 1/2 of what is shifted right.
  const V units = hn::Set(d, S::kUnits), half = hn::Set(d, kIntegers + S::kUnits / 2);
  const Words odd = hn::ShiftLeft<8 * sizeof(typename S::Word) - 1>(Integer(column));
  part.a = hn::Xor(hn::ShiftLeft<S::kShift>(hn::BitCast(du, hn::MulAdd(t.a, units, half))), odd);
  part.x = hn::Xor(hn::ShiftLeft<S::kShift>(hn::BitCast(du, hn::MulAdd(t.x, units, half))), odd);
  return part;
}

/// Adds what lies between the lines A and X; `a`, `x` are the lines' places, one row a lane. `rows` has a bit for each row
/// that counts, or is null where all do.
template <size_t kShape, size_t kSide, class DW, class VW>
HWY_INLINE void AddRows(DW d, VW a, VW x, const uint64_t* HWY_RESTRICT rows, size_t row, typename Shape<kShape>::Word* HWY_RESTRICT to) {
  using S = Shape<kShape>;
  using Word = typename S::Word;
  constexpr int kPlace = S::kWidth == 32 ? 27 : 58;
  const auto all = hn::Set(d, static_cast<Word>(~Word{0}));
  const auto left = hn::ShiftRight<kPlace>(kSide == 0 ? a : x), right = hn::ShiftRight<kPlace>(kSide == 0 ? x : a);
#if HWY_TARGET <= HWY_AVX3
  (void)row;
  __m512i bits;  // (left & ~right) | old
  if constexpr (S::kWidth == 32) {
    const __m512i l = rows == nullptr ? _mm512_sllv_epi32(all.raw, left.raw)
                                      : _mm512_maskz_sllv_epi32(static_cast<uint16_t>(*rows), all.raw, left.raw);
    bits = _mm512_ternarylogic_epi32(l, _mm512_sllv_epi32(all.raw, right.raw), hn::Load(d, to).raw, 0xBA);
  } else {
    const __m512i l = rows == nullptr ? _mm512_sllv_epi64(all.raw, left.raw)
                                      : _mm512_maskz_sllv_epi64(static_cast<uint8_t>(*rows), all.raw, left.raw);
    bits = _mm512_ternarylogic_epi64(l, _mm512_sllv_epi64(all.raw, right.raw), hn::Load(d, to).raw, 0xBA);
  }
  _mm512_store_si512(to, bits);
#else
  auto between = hn::AndNot(hn::Shl(all, right), hn::Shl(all, left));
  if (rows != nullptr) {
    const auto bit = hn::Shl(hn::Set(d, Word{1}), hn::Iota(d, static_cast<Word>(row)));
    between = hn::IfThenElseZero(hn::TestBit(hn::Set(d, static_cast<Word>(*rows)), bit), between);
  }
  hn::Store(hn::Or(hn::Load(d, to + row), between), d, to + row);
#endif
}

template <size_t kShape, size_t kSide>
HWY_NOINLINE void DrawRuns(NarrowOnes& ones) {
  using S = Shape<kShape>;
  using Word = typename S::Word;
  const hn::CappedTag<Word, S::kRows> d;
  constexpr size_t kStep = hn::MaxLanes(d);
  const auto place = [&](uint64_t first) { return hn::Set(d, static_cast<Word>(first)); };
  for (size_t row = 0; row < S::kRows; row += kStep) {
    for (size_t run = 0; run < NarrowOnes::kRuns; ++run) {
      const auto* HWY_RESTRICT steps = reinterpret_cast<const Word*>(ones.steps[run]);
      const auto stepA = hn::Load(d, steps + row), stepX = hn::Load(d, steps + S::kRows + row);
      const size_t end = ones.begin[run] + ones.size[run];
      for (size_t k = ones.begin[run]; k < end; ++k)
        AddRows<kShape, kSide>(d, place(ones.a[k]) + stepA, place(ones.x[k]) + stepX, nullptr, row, reinterpret_cast<Word*>(ones.block[k]));
    }
    const NarrowOnes::Ends& ends = ones.ends;
    for (size_t k = 0; k < ends.size; ++k) {
      const auto* HWY_RESTRICT steps = reinterpret_cast<const Word*>(ones.steps[ends.run[k]]);
      AddRows<kShape, kSide>(d, place(ends.a[k]) + hn::Load(d, steps + row), place(ends.x[k]) + hn::Load(d, steps + S::kRows + row),
                             &ends.rows[k], row, reinterpret_cast<Word*>(ends.block[k]));
    }
  }
}

/// What a line moves in j rows, j < kRows, on the grid.
template <size_t kShape>
HWY_INLINE void Steps(double slope, uint64_t* HWY_RESTRICT to) {
  using S = Shape<kShape>;
  const D d;
  const DU du;
  const V units = hn::Set(d, slope * S::kUnits), integers = hn::Set(d, kIntegers);
  for (size_t j = 0; j < S::kRows; j += kLanes) {
    const Words moved = hn::ShiftLeft<S::kShift>(hn::BitCast(du, hn::MulAdd(hn::Iota(d, static_cast<double>(j)), units, integers)));
    if constexpr (S::kWidth == 64) {
      hn::Store(moved, du, to + j);
    } else {
      const hn::Rebind<uint32_t, D> d32;
      const Words low = hn::And(moved, hn::Set(du, 0xFFFFFFFF));  // where truncation would saturate
      hn::Store(hn::TruncateTo(d32, low), d32, reinterpret_cast<uint32_t*>(to) + j);
    }
  }
}

/// Parts of the blocks with a vertex in them: of the first vertex, the middle one (above it and below), the last one.
template <size_t kShape, size_t kSamples>
HWY_INLINE void AddEnds(NarrowOnes& ones, V start, V top, V middle, V bottom, M present, const NarrowBlocks& blocks) {
  using S = Shape<kShape>;
  const D d;
  const DU du;
  NarrowOnes::Ends& ends = ones.ends;
  ends.size = 0;
  const V height = hn::Set(d, S::kRows), zero = hn::Zero(d);
  for (size_t end = 0; end < 4; ++end) {
    const bool above = end < 2;
    const V vertex = end == 0 ? top : end == 3 ? bottom : middle;
    const V row = hn::MulAdd(hn::Floor((vertex - start) * hn::Set(d, 1.0 / S::kRows)), height, start);
    const auto at = [&](size_t line) { return hn::MulAdd(hn::Load(d, ones.slope[line]), row, hn::Load(d, ones.offset[line])); };
    const NarrowPart part = PartOf<kShape, kSamples>({row, at(0), at(above ? 1 : 2), hn::Load(d, ones.corner), hn::Load(d, ones.leastColumn),
                                                      hn::Load(d, ones.reach)}, blocks);
    const V last = hn::Max(hn::Min((above ? middle : bottom) - row, height), zero);
    const V first = hn::Min(hn::Max((above ? top : middle) - row, zero), last);
    const Words one = hn::Set(du, 1), k31 = hn::Set(du, 31);
    const Words rows = hn::Shl(one, hn::And(Integer(last), k31)) - hn::Shl(one, hn::And(Integer(first), k31));
    const M any = hn::And(present, hn::Lt(first, last));
    const auto add = [&](Words what, uint64_t* to) {
      size_t size = ends.size;
      Append(what, any, to, size);
      return size;
    };
    add(part.block, ends.block), add(part.a, ends.a), add(part.x, ends.x), add(rows, ends.rows);
    ends.size = add(NumbersFrom(du, above ? 0 : kLanes), ends.run);
  }
}

/// Whole blocks between vertices, all runs.
template <size_t kShape, size_t kSamples>
HWY_INLINE void AddRuns(NarrowOnes& ones, V start, V top, V middle, V bottom, M present, const NarrowBlocks& blocks) {
  using S = Shape<kShape>;
  const D d;
  const DU du;
  const V height = hn::Set(d, S::kRows), perRow = hn::Set(d, 1.0 / S::kRows), zero = hn::Zero(d);
  size_t groups = 0;
  for (size_t below = 0; below < 2; ++below) {
    const V first = hn::Ceil(((below ? middle : top) - start) * perRow), end = hn::Floor(((below ? bottom : middle) - start) * perRow);
    const V size = hn::IfThenElseZero(present, hn::Max(end - first, zero));
    hn::Store(hn::MulAdd(first, height, start), d, ones.start + below * kLanes);
    hn::Store(hn::And(Integer(size), hn::Set(du, 0xFFFF)), du, ones.size + below * kLanes);
    Words code = NumbersFrom(du, below * kLanes);
    V done = zero;
    for (M more = hn::Lt(done, size); !hn::AllFalse(d, more); more = hn::Lt(done, size)) {
      Append(code, more, ones.groups, groups);
      done = done + hn::Set(d, kLanes);
      code = code + hn::Set(du, kLanes << 8);
    }
  }
  size_t begin = 0;
  for (size_t run = 0; run < NarrowOnes::kRuns; ++run) {
    ones.begin[run] = begin;
    begin += (ones.size[run] + kLanes - 1) / kLanes * kLanes;
  }
  const V blockRows = hn::Iota(d, 0) * height;
  for (size_t k = 0; k < groups; ++k) {
    const size_t run = ones.groups[k] & 0xFF, block = ones.groups[k] >> 8, lane = run % kLanes, other = 1 + run / kLanes;
    const V row = hn::MulAdd(hn::Set(d, kEights[block]), hn::Set(d, S::kRows / 8), blockRows) + hn::Set(d, ones.start[run]);
    const auto at = [&](size_t i) { return hn::MulAdd(hn::Set(d, ones.slope[i][lane]), row, hn::Set(d, ones.offset[i][lane])); };
    const NarrowPart part = PartOf<kShape, kSamples>({row, at(0), at(other), hn::Set(d, ones.corner[lane]),
                                                      hn::Set(d, ones.leastColumn[lane]), hn::Set(d, ones.reach[lane])}, blocks);
    const size_t to = ones.begin[run] + block;
    hn::StoreU(part.block, du, ones.block + to);
    hn::StoreU(part.a, du, ones.a + to);
    hn::StoreU(part.x, du, ones.x + to);
  }
}

template <size_t kShape, size_t kSide, size_t kSamples>
HWY_NOINLINE void DrawNarrow(const Batch<kSamples>& b, const SpanTarget& whole, const NarrowTarget& target, NarrowOnes& ones) {
  using S = Shape<kShape>;
  const D d;
  const auto& list = b.narrow[kShape][kSide];
  const V height = hn::Set(d, S::kRows), stride = hn::Set(d, target.stride / S::kRows);
  const V samples = hn::Set(d, static_cast<double>(target.samples));
  for (size_t from = 0; from < list.size; from += kLanes) {
    const size_t count = HWY_MIN(kLanes, list.size - from);
    const M present = hn::FirstN(d, count);
    alignas(64) double cornerY[kLanes];
    size_t places[kLanes];
    for (size_t lane = 0; lane < kLanes; ++lane) {
      const size_t i = places[lane] = list.places[from + HWY_MIN(lane, count - 1)];
      for (size_t k = 0; k < 3; ++k) ones.slope[k][lane] = b.slope[k][i], ones.y[k][lane] = b.y[k][i];
      cornerY[lane] = b.firstRow[i] & ~7;
      ones.leastColumn[lane] = b.leastColumn[i] * (S::kWidth == 32 ? 2 : 1), ones.reach[lane] = b.reach[i];
      for (size_t below = 0; below < 2; ++below) {
        Steps<kShape>(b.slope[0][i], ones.steps[lane + below * kLanes][0]);
        Steps<kShape>(b.slope[1 + below][i], ones.steps[lane + below * kLanes][1]);
      }
    }
    const V row0 = hn::Load(d, cornerY), start = hn::Floor(row0 * hn::Set(d, 1.0 / S::kRows)) * height - row0;
    hn::Store(hn::MulAdd(row0, stride, hn::Neg(hn::Load(d, ones.leastColumn))), d, ones.corner);
    for (size_t s = 0; s < (kSamples == 0 ? target.samples : kSamples); ++s) {
      for (size_t lane = 0; lane < kLanes; ++lane)
        for (size_t k = 0; k < 3; ++k) ones.offset[k][lane] = b.offset[s][k][places[lane]];
      const auto rowOf = [&](size_t vertex) {
        const V row = hn::Ceil((hn::Load(d, ones.y[vertex]) - hn::Set(d, whole.y[s])) * hn::Set(d, 1.0 / 256));
        return hn::Min(hn::Max(row, hn::Zero(d)), hn::Set(d, whole.height)) - row0;
      };
      const V top = rowOf(0), middle = rowOf(1), bottom = rowOf(2);
      const NarrowBlocks blocks{stride, samples, hn::Set(DU(), target.start + s * 64)};
      AddEnds<kShape, kSamples>(ones, start, top, middle, bottom, present, blocks);
      AddRuns<kShape, kSamples>(ones, start, top, middle, bottom, present, blocks);
      DrawRuns<kShape, kSide>(ones);
    }
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace rasterdiff::rasterizer
HWY_AFTER_NAMESPACE();
#endif
