// From lines to runs: for each row of a triangle the chunks of eight pixels that it covers, as one flat list over a whole
// batch, so that no loop a triangle or a row mispredicts its end; and the loop over that list that writes the planes.
#if defined(RASTERDIFF_VALUE_ROWS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RASTERDIFF_VALUE_ROWS_INL_H
#undef RASTERDIFF_VALUE_ROWS_INL_H
#else
#define RASTERDIFF_VALUE_ROWS_INL_H
#endif

#include <algorithm>

#include "rasterizer/kernels/value_setup-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rasterdiff::rasterizer {
namespace HWY_NAMESPACE {

inline constexpr size_t kChunk = 8;  // pixels
inline constexpr double kTwo52 = 4503599627370496.0;

/// Chunks with a covered pixel, triangle by triangle: element of the planes | mask of pixels << 40 | place << 48.
/// Elements < 2^14 · 2^4 · (2^14 + 2^4) < 2^33.
struct Chunks {
  static constexpr size_t kSize = 1024, kRoom = kSize - 16, kAhead = 24;
  uint64_t codes[kSize + kAhead] = {};
  double depth[kSize];   // at the chunk's first pixel; through corners: gy (y - y0)
  double column[kSize];  // through corners: x of the first pixel's sample
  size_t size = 0;
};

/// Which planes are written, whether depth planes go through DepthCorners, with meetings counted, and whether of equally deep triangles
/// the first one is kept by its number, since they come in another order than theirs (value_order.hpp).
template <bool kPrimitiveV, bool kCountV, bool kDepthV, bool kCornersV = false, bool kNumbersDecideV = false>
struct Planes {
  static constexpr bool kPrimitive = kPrimitiveV, kCount = kCountV, kDepth = kDepthV, kCorners = kCornersV, kNumbersDecide = kNumbersDecideV;
  /// What is as deep as what is there has to be looked at, too.
  static constexpr bool kMeets = kCorners || kNumbersDecide;
  static_assert(!kNumbersDecide || (kPrimitive && kDepth && !kCount && !kCorners));
};

#if HWY_TARGET <= HWY_AVX3
using ChunkF = hn::CappedTag<float, 8>;
using ChunkU = hn::CappedTag<uint32_t, 8>;
#else
using ChunkF = hn::CappedTag<float, 4>;
using ChunkU = hn::CappedTag<uint32_t, 4>;
#endif
inline constexpr size_t kChunkLanes = hn::MaxLanes(ChunkF());

HWY_INLINE hn::Mask<ChunkF> ChunkMask(uint32_t bits) {
#if HWY_TARGET <= HWY_AVX3
  return hn::Mask<ChunkF>{static_cast<__mmask8>(bits)};
#else
  const auto byte = static_cast<uint8_t>(bits & ((1u << kChunkLanes) - 1));
  return hn::LoadMaskBits(ChunkF(), &byte);
#endif
}

/// Rounded once; too large a number becomes infinite, which in Highway's scalar form it does not.
HWY_INLINE hn::Vec<hn::Rebind<float, D>> RoundToFloat(V v) {
#if HWY_TARGET == HWY_SCALAR
  return hn::Vec1<float>(static_cast<float>(v.raw));
#else
  return hn::DemoteTo(hn::Rebind<float, D>(), v);
#endif
}

/// What the depths of a chunk come from. a0, x0 and column (x of the first pixel's sample): only through corners.
struct ChunkPlane {
  double chunk, gx, a0, x0, column;
};

/// Depth of pixels [first, first + kChunkLanes) of a chunk. Equal depths have the same bits, as long as they are not through corners: a zero is +0.
template <class P>
HWY_INLINE hn::Vec<ChunkF> ChunkDepth(const ChunkPlane& p, size_t first) {
  const D d;
  const auto at = [&](V i) {
    if (!P::kCorners) return hn::Set(d, p.chunk) + hn::Set(d, p.gx) * i;
    return (hn::Set(d, p.a0) + hn::Set(d, p.gx) * ((hn::Set(d, p.column) + i) - hn::Set(d, p.x0))) + hn::Set(d, p.chunk);
  };
#if HWY_TARGET <= HWY_AVX3
  (void)first;
  const auto depth = RoundToFloat(at(hn::Iota(d, 0)));
  return P::kCorners ? depth : depth + hn::Zero(ChunkF());
#else
  const hn::Rebind<float, D> part;
  alignas(16) float depth[4 + kLanes];
  for (size_t k = 0; k < kChunkLanes; k += kLanes)
    hn::Store(RoundToFloat(at(hn::Iota(d, static_cast<double>(first + k)))), part, depth + k);
  return P::kCorners ? hn::Load(ChunkF(), depth) : hn::Load(ChunkF(), depth) + hn::Zero(ChunkF());
#endif
}

/// One instruction, where there is one.
HWY_INLINE hn::Mask<ChunkF> AndNotAlike(hn::Mask<ChunkF> apart, hn::Vec<ChunkF> a, hn::Vec<ChunkF> b) {
#if HWY_TARGET <= HWY_AVX3
  return hn::Mask<ChunkF>{_mm256_mask_cmp_ps_mask(apart.raw, a.raw, b.raw, _CMP_NEQ_UQ)};
#else
  return hn::AndNot(hn::Eq(a, b), apart);
#endif
}

/// Writes pixels [i, i + kChunkLanes) of the planes where `mask` says so and depth passes. Whole vectors are stored: a load
/// that follows a masked store of the same place would wait for it. Numbers need not be loaded where a store can be masked. If numbers
/// decide, takes out of `apart` where a depth, covered or not, meets its like. Returns the depths that are there now.
template <class P>
HWY_INLINE hn::Vec<ChunkF> WriteChunk(const ValueView& view, size_t i, hn::Mask<ChunkF> mask, hn::Vec<ChunkF> depth, uint32_t number,
                                     hn::Mask<ChunkF>& apart) {
  const ChunkF df;
  const ChunkU du;
  if (P::kDepth) {
    const auto old = hn::LoadU(df, view.depth + i);
    if (P::kCorners) {
      const auto alike = hn::And(mask, hn::Eq(depth, old));
      if (HWY_UNLIKELY(!hn::AllFalse(df, alike))) {
        const auto drawn = hn::Ne(hn::LoadU(du, view.primitive + i), hn::Zero(du));
        *view.met += hn::CountTrue(du, hn::And(hn::RebindMask(du, alike), drawn));
      }
    }
    if (P::kNumbersDecide) apart = AndNotAlike(apart, depth, old);
#if HWY_TARGET <= HWY_AVX3
    if (!P::kPrimitive && !P::kCount) {
      // Which keeps `old` where either is not a number or both are zero.
      depth.raw = _mm256_mask_min_ps(old.raw, mask.raw, depth.raw, old.raw);
      hn::StoreU(depth, df, view.depth + i);
      return depth;
    }
    mask.raw = _mm256_mask_cmp_ps_mask(mask.raw, depth.raw, old.raw, _CMP_LT_OQ);
#else
    mask = hn::And(mask, hn::Lt(depth, old));
#endif
    depth = hn::IfThenElse(mask, depth, old);
    hn::StoreU(depth, df, view.depth + i);
  }
  const auto which = hn::RebindMask(du, mask);
#if HWY_TARGET <= HWY_AVX3
  if (P::kPrimitive) _mm256_mask_storeu_epi32(view.primitive + i, which.raw, _mm256_set1_epi32(static_cast<int>(number)));
#else
  if (P::kPrimitive) hn::StoreU(hn::IfThenElse(which, hn::Set(du, number), hn::LoadU(du, view.primitive + i)), du, view.primitive + i);
#endif
  if (P::kCount) {
    const auto old = hn::LoadU(du, view.count + i);
    hn::StoreU(hn::IfThenElse(which, old + hn::Set(du, 1), old), du, view.count + i);
  }
  return depth;
}

/// Of pixels [i, i + kChunkLanes) that were written where `mask` says so: gives those to triangle `number` that are as deep as it and
/// belong to one with a higher number.
inline HWY_NOINLINE void KeepFirst(const ValueView& view, size_t i, hn::Mask<ChunkF> mask, hn::Vec<ChunkF> depth, uint32_t number) {
  const ChunkU u;
  const auto there = hn::LoadU(u, view.primitive + i);
  const auto alike = hn::And(mask, hn::Eq(depth, hn::LoadU(ChunkF(), view.depth + i)));
  hn::StoreU(hn::IfThenElse(hn::RebindMask(u, alike), hn::Min(there, hn::Set(u, number)), there), u, view.primitive + i);
}

/// Fetches element `i` of the planes that are loaded. Always inlined: GCC finds that a function that only fetches does nothing, and drops calls of it.
template <class P>
HWY_INLINE void PrefetchPlanes(const ValueView& view, size_t i) {
  if (P::kDepth) __builtin_prefetch(view.depth + i, 1);
  if (P::kPrimitive && HWY_TARGET > HWY_AVX3) __builtin_prefetch(view.primitive + i, 1);
  if (P::kCount) __builtin_prefetch(view.count + i, 1);
}

/// kListed: as the batch is. Lines are fetched some chunks ahead: triangles come from all over the target.
template <class P, bool kListed>
HWY_INLINE void DrawChunksOf(const ValueView& target, const ValueBatch& b, Chunks& chunks) {
  if (chunks.size == 0) return;
  const ValueView view = target;  // which no store can change
  const uint32_t firstNumber = view.before + 1 + (kListed ? 0 : b.triangles[0]);
  const auto elementOf = [](uint64_t code) { return code & ((uint64_t{1} << 40) - 1); };
  std::fill_n(chunks.codes + chunks.size, Chunks::kAhead, chunks.codes[0]);
  for (size_t k = 0; P::kDepth && k < Chunks::kAhead; ++k) PrefetchPlanes<P>(view, elementOf(chunks.codes[k]));
  for (size_t k = 0, size = chunks.size; k < size; ++k) {
    const uint64_t code = chunks.codes[k];
    if (P::kDepth) PrefetchPlanes<P>(view, elementOf(chunks.codes[k + Chunks::kAhead]));
    const size_t element = elementOf(code), place = code >> 48;
    const auto bits = static_cast<uint32_t>(code >> 40 & 0xFF);
    for (size_t first = 0; first < kChunk; first += kChunkLanes) {
      hn::Vec<ChunkF> depth = hn::Zero(ChunkF());
      ChunkPlane plane{};
      if (P::kDepth) plane.chunk = chunks.depth[k], plane.gx = b.gx[place];
      if (P::kCorners) plane.a0 = b.a0[place], plane.x0 = b.x0[place], plane.column = chunks.column[k];
      if (P::kDepth) depth = ChunkDepth<P>(plane, first);
      const auto mask = ChunkMask(bits >> first);
      const uint32_t number = firstNumber + (kListed ? b.triangles[place] : static_cast<uint32_t>(place));
      hn::Mask<ChunkF> apart = ChunkMask(0xFF);
      WriteChunk<P>(view, element + first, mask, depth, number, apart);
      if (P::kNumbersDecide && HWY_UNLIKELY(!hn::AllTrue(ChunkF(), apart))) KeepFirst(view, element + first, mask, depth, number);
    }
  }
  chunks.size = 0;
}

template <class P>
HWY_NOINLINE void DrawChunks(const ValueView& view, const ValueBatch& b, Chunks& chunks) {
  if (HWY_UNLIKELY(b.listed)) {
    DrawChunksOf<P, true>(view, b, chunks);
  } else {
    DrawChunksOf<P, false>(view, b, chunks);
  }
}

/// What bounds a triangle's rows: slopes of its lines and the box; offsets of the lines at one sample.
struct RowLines {
  V slope[4], firstColumn, endColumn;
};
struct RowOffsets {
  V of[4];
};

HWY_INLINE RowLines LinesOf(const ValueBatch& b, size_t i) {
  const D d;
  return {{hn::Set(d, b.slope[0][i]), hn::Set(d, b.slope[1][i]), hn::Set(d, b.slope[2][i]), hn::Set(d, b.slope[3][i])},
          hn::Set(d, b.firstColumn[i]), hn::Set(d, b.endColumn[i])};
}

/// The same of the kLanes triangles from place `base` on, a lane each.
HWY_INLINE RowLines LinesFrom(const ValueBatch& b, size_t base) {
  const D d;
  const auto from = [&](const double* p) { return hn::Load(d, p + base); };
  return {{from(b.slope[0]), from(b.slope[1]), from(b.slope[2]), from(b.slope[3])}, from(b.firstColumn), from(b.endColumn)};
}
HWY_INLINE RowOffsets OffsetsFrom(const ValueBatch& b, size_t base, size_t s) {
  const D d;
  const auto from = [&](const double* p) { return hn::Load(d, p + base); };
  return {{from(b.offset[s][0]), from(b.offset[s][1]), from(b.offset[s][2]), from(b.offset[s][3])}};
}

HWY_INLINE RowOffsets OffsetsOf(const ValueBatch& b, size_t i, size_t s) {
  const D d;
  return {{hn::Set(d, b.offset[s][0][i]), hn::Set(d, b.offset[s][1][i]), hn::Set(d, b.offset[s][2][i]), hn::Set(d, b.offset[s][3][i])}};
}

/// Left and right bounds of rows `r`, cut by the box; whole numbers.
HWY_INLINE void RowBounds(const RowLines& lines, const RowOffsets& offsets, V r, V& begin, V& end) {
  const auto line = [&](size_t k) { return hn::MulAdd(lines.slope[k], r, offsets.of[k]); };
  begin = hn::Round(hn::Max(hn::Max(line(0), line(1)), lines.firstColumn));
  end = hn::Round(hn::Min(hn::Min(line(2), line(3)), lines.endColumn));
}

/// Bits [from, to) of eight; both are clamped to [0, 8].
HWY_INLINE hn::Vec<DU> BitsBetween(V from, V to) {
  const D d;
  const DU du;
  const V zero = hn::Zero(d);
#if HWY_TARGET <= HWY_AVX3
  // Where a shift is by 64 or more no bit is left.
  const auto bits = [&](V v) { return hn::Vec<DU>{_mm512_sllv_epi64(_mm512_set1_epi64(0xFF), _mm512_cvtpd_epi64(hn::Max(v, zero).raw))}; };
  return hn::And(hn::AndNot(bits(to), bits(from)), hn::Set(du, 0xFF));
#else
  const V eight = hn::Set(d, 8), two52 = hn::Set(d, kTwo52);
  const auto bound = [&](V v) { return hn::And(hn::BitCast(du, hn::Min(hn::Max(v, zero), eight) + two52), hn::Set(du, 15)); };
  const auto ones = hn::Set(du, 0xFF);
  return hn::And(hn::AndNot(hn::Shl(ones, bound(to)), hn::Shl(ones, bound(from))), ones);
#endif
}

/// What the chunks of a triangle have in common, of one in all lanes or of one a lane.
template <class P>
struct ChunkSource {
  hn::Vec<DU> place;
  V rowElements, gx, gy, a0, x0, y0;

  /// Of place `i`.
  HWY_INLINE ChunkSource(const ValueView& view, const ValueBatch& b, size_t i) : ChunkSource(view) {
    const D d;
    place = hn::Set(DU(), (uint64_t{i} << 48) - kExponent);
    if (P::kDepth) gx = hn::Set(d, b.gx[i]), gy = hn::Set(d, b.gy[i]), a0 = hn::Set(d, b.a0[i]), x0 = hn::Set(d, b.x0[i]), y0 = hn::Set(d, b.y0[i]);
  }

  /// Of the kLanes places from `base` on.
  static HWY_INLINE ChunkSource From(const ValueView& view, const ValueBatch& b, size_t base) {
    ChunkSource source(view);
    source.place = hn::ShiftLeft<48>(hn::Iota(DU(), base)) - hn::Set(DU(), kExponent);
    const auto load = [&](const double* p) { return hn::Load(D(), p + base); };
    if (P::kDepth) source.gx = load(b.gx), source.gy = load(b.gy), source.a0 = load(b.a0), source.x0 = load(b.x0), source.y0 = load(b.y0);
    return source;
  }

 private:
  // A double from 2^52 on is its whole number in the low bits, and an exponent that goes where the place comes.
  static constexpr uint64_t kExponent = uint64_t{0x433} << 52;

  HWY_INLINE explicit ChunkSource(const ValueView& view) {
    rowElements = hn::Set(D(), static_cast<double>(view.samples * view.stride));
    gx = gy = a0 = x0 = y0 = hn::Zero(D());
  }
};

/// As doubles from 2^52 on, the first elements of rows `r` at sample s.
template <class P>
HWY_INLINE V RowElements(const ValueView& view, const ChunkSource<P>& from, size_t s, V r) {
  const D d;
  return hn::MulAdd(r, from.rowElements, hn::Set(d, static_cast<double>(s * view.stride))) + hn::Set(d, kTwo52);
}

/// The part of their depths that does not depend on the column.
template <class P>
HWY_INLINE V RowDepths(const ValueView& view, const ChunkSource<P>& from, size_t s, V r) {
  const V y = hn::Set(D(), view.y[s] / 256);
  if (P::kCorners) return from.gy * ((r + y) - from.y0);
  return P::kDepth ? from.a0 + from.gy * (r + (y - from.y0)) : hn::Zero(D());
}

/// From the anchor, or through corners from nowhere, to the samples of column 0.
template <class P>
HWY_INLINE V FromAnchor(const ValueView& view, const ChunkSource<P>& from, size_t s) {
  const V x = hn::Set(D(), view.x[s] / 256);
  return P::kCorners ? x : P::kDepth ? x - from.x0 : hn::Zero(D());
}

/// Of the chunks from `column` on, of pixels before `end`; of lanes without any, anything.
template <class P>
HWY_INLINE hn::Vec<DU> ChunkCodes(const ChunkSource<P>& from, V rowElements, V column, V end) {
  const D d;
  const DU du;
  const auto eightBits = hn::Set(du, uint64_t{0xFF} << 40);
  const auto pixels = hn::And(hn::BitCast(du, hn::Min(end - column, hn::Set(d, 8)) + hn::Set(d, kTwo52)), hn::Set(du, 15));
  return hn::Or(hn::BitCast(du, rowElements + column) + from.place, hn::AndNot(hn::Shl(eightBits, pixels), eightBits));
}

/// Chunks::depth of them.
template <class P>
HWY_INLINE hn::Vec<DU> ChunkDepths(const ChunkSource<P>& from, V rowDepths, V fromAnchor, V column) {
  return hn::BitCast(DU(), P::kCorners ? rowDepths : rowDepths + from.gx * (fromAnchor + column));
}

/// Appends the chunks of pixels [begin, end) of rows `r`, those of `more`, at sample s; draws what does not fit.
template <class P>
HWY_INLINE void AppendChunks(const ValueView& view, const ValueBatch& b, const ChunkSource<P>& from, size_t s, V r, V begin, V end, M more,
                             Chunks& chunks, size_t& size) {
  const D d;
  const DU du;
  const V elements = RowElements(view, from, s, r), depths = RowDepths(view, from, s, r), fromAnchor = FromAnchor(view, from, s);
  V column = begin;
  do {
    size_t next = size;
    if (P::kCorners) {
      Append(hn::BitCast(du, fromAnchor + column), more, reinterpret_cast<uint64_t*>(chunks.column), next);
      next = size;
    }
    if (P::kDepth) Append(ChunkDepths(from, depths, fromAnchor, column), more, reinterpret_cast<uint64_t*>(chunks.depth), next);
    Append(ChunkCodes(from, elements, column, end), more, chunks.codes, size);
    if (HWY_UNLIKELY(size > Chunks::kRoom)) {
      chunks.size = size;
      DrawChunks<P>(view, b, chunks);
      size = 0;
    }
    column = column + hn::Set(d, kChunk);
    more = hn::And(more, hn::Lt(column, end));
  } while (!hn::AllFalse(d, more));
}

/// Appends the chunks of place `i`.
template <class P>
HWY_INLINE void FindChunks(const ValueView& view, const ValueBatch& b, size_t i, Chunks& chunks) {
  const D d;
  const RowLines lines = LinesOf(b, i);
  const ChunkSource<P> source(view, b, i);
  const double firstRow = b.firstRow[i], lastRow = b.endRow[i];
  const V endRow = hn::Set(d, lastRow);
  size_t size = chunks.size;
  for (double row = firstRow; row < lastRow; row += static_cast<double>(kLanes)) {
    const V r = NumbersFrom(d, row);
    for (size_t s = 0; s < view.samples; ++s) {
      V begin, end;
      RowBounds(lines, OffsetsOf(b, i, s), r, begin, end);
      AppendChunks<P>(view, b, source, s, r, begin, end, hn::And(hn::Lt(begin, end), hn::Lt(r, endRow)), chunks, size);
    }
  }
  chunks.size = size;
}

}  // namespace HWY_NAMESPACE
}  // namespace rasterdiff::rasterizer
HWY_AFTER_NAMESPACE();
#endif
