// Edge functions of the triangles that are seen: set up once a run of pixels (value_runs-inl.h), a vector of runs at a time, and
// spread to the pixels by permutations; for the instruction set being compiled. Why they are exact: value_weights-inl.h.
#if defined(RASTERDIFF_VALUE_RUN_EDGES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RASTERDIFF_VALUE_RUN_EDGES_INL_H
#undef RASTERDIFF_VALUE_RUN_EDGES_INL_H
#else
#define RASTERDIFF_VALUE_RUN_EDGES_INL_H
#endif

#include <array>
#include <type_traits>

#include "rasterizer/kernels/value_runs-inl.h"
#include "rasterizer/kernels/value_weights-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rasterdiff::rasterizer {
namespace HWY_NAMESPACE {

/// By vertex: edge functions of a strip's runs in the tile's first column; how much they grow 1/256 pixel, a difference of y, of two
/// vertices (the three have sum 0); 1 / w.
struct RunEdges {
  static constexpr size_t kSize = Strip::kSize + Strip::kRoom;
  alignas(64) double b[3][kSize];
  alignas(64) int32_t step[2][kSize];
  alignas(64) float r[3][kSize];
};

/// Vertices of kShadeLanes triangles relative to pixels' centres in 1/256 pixel.
struct Corners3 {
  PerVertex x, y;
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

/// The triangles of kShadeLanes runs by place; nobody's are any.
struct alignas(64) RunTriangles {
  uint32_t of[kShadeLanes];

  HWY_INLINE explicit RunTriangles(const uint32_t* HWY_RESTRICT numbers) {
    const ShadeU u;
    hn::Store(hn::Max(hn::LoadU(u, numbers), hn::Set(u, 1)) - hn::Set(u, 1), u, of);
  }
};

HWY_INLINE Corners3 CornersOf(const ValueTriangles& triangles, const RunTriangles& t, ShadeV px, ShadeV py) {
  Corners3 c;
#if HWY_TARGET <= HWY_AVX3
  static_assert(sizeof(SnappedTriangle) == 24);
  __m256i row[8];
  __m512i columns[4];
  for (int lane = 0; lane < 8; ++lane) row[lane] = _mm256_maskz_loadu_epi32(0x3F, &triangles.positions[t.of[lane]]);
  Transpose(row, columns);  // x0 and x2, y0 and y2, x1, y1
  const auto number = [](__m256i v) { return ShadeV{_mm512_cvtepi32_pd(v)}; };
  c.x = {{number(LowHalf(columns[0])) - px, number(LowHalf(columns[2])) - px, number(HighHalf(columns[0])) - px}};
  c.y = {{number(LowHalf(columns[1])) - py, number(LowHalf(columns[3])) - py, number(HighHalf(columns[1])) - py}};
#else
  const ShadeD d;
  alignas(64) double x[3][kShadeLanes], y[3][kShadeLanes];
  for (size_t lane = 0; lane < kShadeLanes; ++lane) {
    const auto& v = triangles.positions[t.of[lane]].v;
    for (size_t i = 0; i < 3; ++i) x[i][lane] = v[i].x, y[i][lane] = v[i].y;
  }
  for (size_t i = 0; i < 3; ++i) c.x.v[i] = hn::Load(d, x[i]) - px, c.y.v[i] = hn::Load(d, y[i]) - py;
#endif
  return c;
}

HWY_INLINE void StoreReciprocalW(const ValueTriangles& triangles, const RunTriangles& t, size_t k, RunEdges& runs) {
  const float* HWY_RESTRICT r = triangles.reciprocalW.data();
#if HWY_TARGET <= HWY_AVX3
  __m256i row[8];
  __m512i columns[4];
  for (int lane = 0; lane < 8; ++lane) row[lane] = _mm256_castsi128_si256(_mm_castps_si128(_mm_maskz_loadu_ps(7, r + size_t{3} * t.of[lane])));
  Transpose(row, columns);
  for (int i = 0; i < 3; ++i) _mm256_store_si256(reinterpret_cast<__m256i*>(runs.r[i] + k), LowHalf(columns[i]));
#else
  for (size_t lane = 0; lane < kShadeLanes; ++lane)
    for (size_t i = 0; i < 3; ++i) runs.r[i][k + lane] = r[size_t{3} * t.of[lane] + i];
#endif
}

/// Sets up the runs of a strip; `left`: the centre of the tile's first column, 1/256 pixel.
HWY_NOINLINE void SetUpRuns(const ValueTriangles& triangles, bool perspective, double left, Strip& strip, RunEdges& runs) {
  const ShadeD d;
  const hn::Rebind<int32_t, ShadeD> whole;
  const NumberTag u;
  for (size_t k = 0; k < kShadeLanes; k += kNumberLanes) hn::StoreU(hn::Zero(u), u, strip.numbers + strip.size + k);
  const ShadeV px = hn::Set(d, left);
  for (size_t k = 0; k < strip.size; k += kShadeLanes) {
    const RunTriangles t(strip.numbers + k);
    const Corners3 c = CornersOf(triangles, t, px, hn::Load(d, strip.y + k));
    for (size_t i = 0; i < 3; ++i) {
      const size_t j = (i + 1) % 3, l = (i + 2) % 3;
      hn::Store(c.x.v[j] * c.y.v[l] - c.x.v[l] * c.y.v[j], d, runs.b[i] + k);
      if (i < 2) hn::Store(hn::DemoteTo(whole, c.y.v[j] - c.y.v[l]), whole, runs.step[i] + k);
    }
    if (perspective) StoreReciprocalW(triangles, t, k, runs);
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

/// From runs to pixels: lane k is the run of pixel k. Loads of whole vectors of doubles that begin anywhere are slow, so that what can be
/// is kept in half the size.
struct Spread {
  /// Of pixels whose starts are `bits`, `before` runs having started left of them.
  HWY_INLINE Spread(uint64_t bits, size_t before) : first(before + (bits & 1) - 1) {
    const uint8_t* HWY_RESTRICT places = kRunPlaces.of[bits >> 1 & ((1u << (kShadeLanes - 1)) - 1)];
#if HWY_TARGET <= HWY_AVX3
    const __m128i bytes = _mm_loadl_epi64(reinterpret_cast<const __m128i*>(places));
    wide = _mm512_cvtepu8_epi64(bytes), narrow = _mm256_cvtepu8_epi32(bytes);
#else
    for (size_t k = 0; k < kShadeLanes; ++k) lanes[k] = places[k];
#endif
  }

#if HWY_TARGET <= HWY_AVX3
  HWY_INLINE ShadeV Of(const double* HWY_RESTRICT runs) const { return ShadeV{_mm512_permutexvar_pd(wide, _mm512_loadu_pd(runs + first))}; }
  HWY_INLINE ShadeV Of(const float* HWY_RESTRICT runs) const {
    return ShadeV{_mm512_cvtps_pd(_mm256_permutevar8x32_ps(_mm256_loadu_ps(runs + first), narrow))};
  }
  HWY_INLINE ShadeV Of(const int32_t* HWY_RESTRICT runs) const {
    return ShadeV{_mm512_cvtepi32_pd(_mm256_permutevar8x32_epi32(_mm256_loadu_si256(reinterpret_cast<const __m256i*>(runs + first)), narrow))};
  }
#else
  template <class T>
  HWY_INLINE ShadeV Of(const T* HWY_RESTRICT runs) const {
    const hn::Rebind<T, ShadeD> narrow;
    alignas(64) T pixels[kShadeLanes];
    for (size_t k = 0; k < kShadeLanes; ++k) pixels[k] = runs[first + lanes[k]];
    if constexpr (std::is_same_v<T, double>) {
      return hn::Load(narrow, pixels);
    } else {
      return hn::PromoteTo(ShadeD(), hn::Load(narrow, pixels));
    }
  }
#endif

  size_t first;
#if HWY_TARGET <= HWY_AVX3
  __m512i wide;
  __m256i narrow;
#else
  uint8_t lanes[kShadeLanes];
#endif
};

/// At pixels whose centres are `x`, 1/256 pixel, right of that of the tile's first column.
HWY_INLINE PerVertex EdgeFunctions(const RunEdges& runs, const Spread& spread, ShadeV x) {
  const ShadeV step0 = spread.Of(runs.step[0]), step1 = spread.Of(runs.step[1]), step2 = hn::Neg(step0 + step1);
  return {{hn::MulAdd(step0, x, spread.Of(runs.b[0])), hn::MulAdd(step1, x, spread.Of(runs.b[1])), hn::MulAdd(step2, x, spread.Of(runs.b[2]))}};
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
