// Edge functions of the triangles that are seen: set up once a run of pixels (value_runs-inl.h), a vector of runs at a time, and
// spread to the pixels by permutations; for the instruction set being compiled. Why they are exact: value_weights-inl.h.
#if defined(RASTERDIFF_VALUE_RUN_EDGES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RASTERDIFF_VALUE_RUN_EDGES_INL_H
#undef RASTERDIFF_VALUE_RUN_EDGES_INL_H
#else
#define RASTERDIFF_VALUE_RUN_EDGES_INL_H
#endif

#include <array>

#include "rasterizer/kernels/value_runs-inl.h"
#include "rasterizer/kernels/value_weights-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rasterdiff::rasterizer {
namespace HWY_NAMESPACE {

/// Edge functions of a strip's runs in the tile's first column, how much they grow a pixel, 1 / w; by vertex.
struct RunEdges {
  static constexpr size_t kSize = Strip::kSize + Strip::kRoom;
  alignas(64) double b[3][kSize], step[3][kSize], r[3][kSize];
};

/// Vertices of kShadeLanes triangles relative to pixels' centres in 1/256 pixel, and 1 / w.
struct Corners3 {
  PerVertex x, y, r;
};

#if HWY_TARGET <= HWY_AVX3
/// Eight rows of up to eight dwords become eight columns; the first of them as the low and high halves of column k and k + 4.
HWY_INLINE void Transpose(const __m256i row[8], __m512i columns[4]) {
  __m512i pair[4], low[2], high[2];
  for (int i = 0; i < 4; ++i) pair[i] = _mm512_inserti64x4(_mm512_castsi256_si512(row[i]), row[i + 4], 1);
  for (int i = 0; i < 2; ++i) {
    low[i] = _mm512_unpacklo_epi32(pair[2 * i], pair[2 * i + 1]);
    high[i] = _mm512_unpackhi_epi32(pair[2 * i], pair[2 * i + 1]);
  }
  const auto gather = [](__m512i v) { return _mm512_shuffle_i64x2(v, v, 0xD8); };  // 128-bit parts 0, 2, 1, 3
  columns[0] = gather(_mm512_unpacklo_epi64(low[0], low[1]));
  columns[1] = gather(_mm512_unpackhi_epi64(low[0], low[1]));
  columns[2] = gather(_mm512_unpacklo_epi64(high[0], high[1]));
  columns[3] = gather(_mm512_unpackhi_epi64(high[0], high[1]));
}

HWY_INLINE __m256i LowHalf(__m512i v) { return _mm512_castsi512_si256(v); }
HWY_INLINE __m256i HighHalf(__m512i v) { return _mm512_extracti64x4_epi64(v, 1); }
#endif

/// Of the triangles numbered `numbers`, 0 for any.
HWY_INLINE Corners3 CornersOf(const ValueTriangles& triangles, const uint32_t* HWY_RESTRICT numbers, bool perspective, ShadeV px, ShadeV py) {
  Corners3 c;
  const ShadeU u;
  alignas(64) uint32_t t[kShadeLanes];
  hn::Store(hn::Max(hn::LoadU(u, numbers), hn::Set(u, 1)) - hn::Set(u, 1), u, t);
#if HWY_TARGET <= HWY_AVX3
  static_assert(sizeof(SnappedTriangle) == 24);
  __m256i row[8];
  __m512i columns[4];
  for (int lane = 0; lane < 8; ++lane) row[lane] = _mm256_maskz_loadu_epi32(0x3F, &triangles.positions[t[lane]]);
  Transpose(row, columns);  // x0 and x2, y0 and y2, x1, y1
  const auto number = [](__m256i v) { return ShadeV{_mm512_cvtepi32_pd(v)}; };
  c.x = {{number(LowHalf(columns[0])) - px, number(LowHalf(columns[2])) - px, number(HighHalf(columns[0])) - px}};
  c.y = {{number(LowHalf(columns[1])) - py, number(LowHalf(columns[3])) - py, number(HighHalf(columns[1])) - py}};
  const ShadeV one = hn::Set(ShadeD(), 1.0);
  c.r = {{one, one, one}};
  if (!perspective) return c;
  for (int lane = 0; lane < 8; ++lane)
    row[lane] = _mm256_castsi128_si256(_mm_castps_si128(_mm_maskz_loadu_ps(7, triangles.reciprocalW.data() + size_t{3} * t[lane])));
  Transpose(row, columns);
  for (int i = 0; i < 3; ++i) c.r.v[i] = ShadeV{_mm512_cvtps_pd(_mm256_castsi256_ps(LowHalf(columns[i])))};
#else
  const ShadeD d;
  alignas(64) double x[3][kShadeLanes], y[3][kShadeLanes], r[3][kShadeLanes];
  for (size_t lane = 0; lane < kShadeLanes; ++lane) {
    const auto& v = triangles.positions[t[lane]].v;
    for (size_t i = 0; i < 3; ++i) {
      x[i][lane] = v[i].x, y[i][lane] = v[i].y;
      r[i][lane] = perspective ? double{triangles.reciprocalW[size_t{3} * t[lane] + i]} : 1.0;
    }
  }
  for (size_t i = 0; i < 3; ++i)
    c.x.v[i] = hn::Load(d, x[i]) - px, c.y.v[i] = hn::Load(d, y[i]) - py, c.r.v[i] = hn::Load(d, r[i]);
#endif
  return c;
}

/// Sets up the runs of a strip; `left`: the centre of the tile's first column, 1/256 pixel.
HWY_NOINLINE void SetUpRuns(const ValueTriangles& triangles, bool perspective, double left, Strip& strip, RunEdges& runs) {
  const ShadeD d;
  const NumberTag u;
  for (size_t k = 0; k < kShadeLanes; k += kNumberLanes) hn::StoreU(hn::Zero(u), u, strip.numbers + strip.size + k);
  const ShadeV px = hn::Set(d, left);
  for (size_t k = 0; k < strip.size; k += kShadeLanes) {
    const Corners3 c = CornersOf(triangles, strip.numbers + k, perspective, px, hn::Load(d, strip.y + k));
    for (size_t i = 0; i < 3; ++i) {
      const size_t j = (i + 1) % 3, l = (i + 2) % 3;
      hn::Store(c.x.v[j] * c.y.v[l] - c.x.v[l] * c.y.v[j], d, runs.b[i] + k);
      hn::Store((c.y.v[j] - c.y.v[l]) * hn::Set(d, kSubpixelOne), d, runs.step[i] + k);
      hn::Store(c.r.v[i], d, runs.r[i] + k);
    }
  }
}

/// Which of eight neighbouring runs each of eight pixels is in, by the bits of pixels 1 to 7 that start one.
struct RunPlaces {
  alignas(64) uint8_t of[128][8] = {};

  constexpr RunPlaces() {
    for (size_t bits = 0; bits < 128; ++bits)
      for (size_t pixel = 1; pixel < 8; ++pixel) of[bits][pixel] = static_cast<uint8_t>(of[bits][pixel - 1] + (bits >> (pixel - 1) & 1));
  }
};
inline constexpr RunPlaces kRunPlaces;

/// From runs to pixels: lane k is the run of pixel k.
struct Spread {
  /// Of pixels whose starts are `bits`, `before` runs having started left of them.
  HWY_INLINE Spread(uint64_t bits, size_t before) : first(before + (bits & 1) - 1) {
    const uint8_t* HWY_RESTRICT places = kRunPlaces.of[bits >> 1 & ((1u << (kShadeLanes - 1)) - 1)];
#if HWY_TARGET <= HWY_AVX3
    // From two cache lines: loads of one vector from both of them would cost more.
    const __m512i offset = _mm512_set1_epi64(static_cast<int64_t>(first % kShadeLanes));
    lanes = _mm512_add_epi64(_mm512_cvtepu8_epi64(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(places))), offset);
    first -= first % kShadeLanes;
#else
    for (size_t k = 0; k < kShadeLanes; ++k) lanes[k] = places[k];
#endif
  }

  HWY_INLINE ShadeV Of(const double* HWY_RESTRICT runs) const {
#if HWY_TARGET <= HWY_AVX3
    return ShadeV{_mm512_permutex2var_pd(_mm512_load_pd(runs + first), lanes, _mm512_load_pd(runs + first + kShadeLanes))};
#else
    alignas(64) double pixels[kShadeLanes];
    for (size_t k = 0; k < kShadeLanes; ++k) pixels[k] = runs[first + lanes[k]];
    return hn::Load(ShadeD(), pixels);
#endif
  }

  size_t first;
#if HWY_TARGET <= HWY_AVX3
  __m512i lanes;
#else
  uint8_t lanes[kShadeLanes];
#endif
};

/// At pixels in columns `x` of the tile.
HWY_INLINE PerVertex EdgeFunctions(const RunEdges& runs, const Spread& spread, ShadeV x) {
  PerVertex b;
  for (size_t i = 0; i < 3; ++i) b.v[i] = hn::MulAdd(spread.Of(runs.step[i]), x, spread.Of(runs.b[i]));
  return b;
}

/// The same where doubles would round; the first pixel's centre is `p`.
HWY_NOINLINE PerVertex FarEdgeFunctions(const ValueTriangles& triangles, const uint32_t* HWY_RESTRICT numbers, SubpixelPosition p) {
  alignas(64) double lanes[3][kShadeLanes];
  for (size_t lane = 0; lane < kShadeLanes; ++lane, p.x += kSubpixelOne) {
    const std::array<double, 3> exact = edgeFunctions(triangles.positions[numbers[lane] - size_t{numbers[lane] != 0}], p);
    for (size_t i = 0; i < 3; ++i) lanes[i][lane] = exact[i];
  }
  const ShadeD d;
  return {{hn::Load(d, lanes[0]), hn::Load(d, lanes[1]), hn::Load(d, lanes[2])}};
}

}  // namespace HWY_NAMESPACE
}  // namespace rasterdiff::rasterizer
HWY_AFTER_NAMESPACE();
#endif
