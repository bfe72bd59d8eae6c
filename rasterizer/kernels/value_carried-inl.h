// What vertices have, of a vector of triangles from anywhere: positions, 1 / w and values become a vector each, by transposition.
#if defined(RASTERDIFF_VALUE_CARRIED_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RASTERDIFF_VALUE_CARRIED_INL_H
#undef RASTERDIFF_VALUE_CARRIED_INL_H
#else
#define RASTERDIFF_VALUE_CARRIED_INL_H
#endif

#include "hwy/highway.h"
#include "rasterizer/kernels/value_view.hpp"

HWY_BEFORE_NAMESPACE();
namespace rasterdiff::rasterizer {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using ShadeD = hn::CappedTag<double, 8>;
using ShadeF = hn::Rebind<float, ShadeD>;
using ShadeU = hn::Rebind<uint32_t, ShadeD>;
using ShadeV = hn::Vec<ShadeD>;
inline constexpr size_t kShadeLanes = hn::MaxLanes(ShadeD());

/// Three vectors, one a vertex.
struct PerVertex {
  ShadeV v[3];
};

#if HWY_TARGET <= HWY_AVX3
/// Eight rows of up to eight dwords become eight columns: columns k and k + 4 as the halves of vector k.
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

/// Vertices of kShadeLanes triangles relative to pixels' centres in 1/256 pixel.
struct Corners3 {
  PerVertex x, y;
};

HWY_INLINE Corners3 CornersOf(const ValueTriangles& triangles, const uint32_t* HWY_RESTRICT t, ShadeV px, ShadeV py) {
  Corners3 c;
#if HWY_TARGET <= HWY_AVX3
  static_assert(sizeof(SnappedTriangle) == 24);
  __m256i row[8];
  __m512i columns[4];
  // In two parts: a masked load would wait for the cache line behind the triangle, too.
  for (int lane = 0; lane < 8; ++lane) {
    const SubpixelPosition* HWY_RESTRICT v = triangles.positions[t[lane]].v.data();
    const __m256i two = _mm256_castsi128_si256(_mm_loadu_si128(reinterpret_cast<const __m128i*>(v)));
    row[lane] = _mm256_mask_broadcastq_epi64(two, 4, _mm_loadl_epi64(reinterpret_cast<const __m128i*>(v + 2)));
  }
  Transpose(row, columns);  // x0 and x2, y0 and y2, x1, y1
  const auto number = [](__m256i v) { return ShadeV{_mm512_cvtepi32_pd(v)}; };
  c.x = {{number(LowHalf(columns[0])) - px, number(LowHalf(columns[2])) - px, number(HighHalf(columns[0])) - px}};
  c.y = {{number(LowHalf(columns[1])) - py, number(LowHalf(columns[3])) - py, number(HighHalf(columns[1])) - py}};
#else
  const ShadeD d;
  alignas(64) double x[3][kShadeLanes], y[3][kShadeLanes];
  for (size_t lane = 0; lane < kShadeLanes; ++lane) {
    const auto& v = triangles.positions[t[lane]].v;
    for (size_t i = 0; i < 3; ++i) x[i][lane] = v[i].x, y[i][lane] = v[i].y;
  }
  for (size_t i = 0; i < 3; ++i) c.x.v[i] = hn::Load(d, x[i]) - px, c.y.v[i] = hn::Load(d, y[i]) - py;
#endif
  return c;
}

/// Where the numbers of `count` components that a triangle's vertices carry begin.
HWY_INLINE const float* CarriedBy(const ValueTriangles& triangles, size_t count, uint32_t t) {
  return triangles.carried.data() + carriedSize(count) * t;
}

HWY_INLINE PerVertex ReciprocalWOf(const ValueTriangles& triangles, size_t count, const uint32_t* HWY_RESTRICT t) {
#if HWY_TARGET <= HWY_AVX3
  __m256i row[8];
  __m512i columns[4];
  for (int lane = 0; lane < 8; ++lane) row[lane] = _mm256_castsi128_si256(_mm_castps_si128(_mm_loadu_ps(CarriedBy(triangles, count, t[lane]))));
  Transpose(row, columns);
  const auto number = [](__m512i v) { return ShadeV{_mm512_cvtps_pd(_mm256_castsi256_ps(LowHalf(v)))}; };
  return {{number(columns[0]), number(columns[1]), number(columns[2])}};
#else
  const ShadeD d;
  alignas(64) double lanes[3][kShadeLanes];
  for (size_t lane = 0; lane < kShadeLanes; ++lane)
    for (size_t i = 0; i < 3; ++i) lanes[i][lane] = CarriedBy(triangles, count, t[lane])[i];
  return {{hn::Load(d, lanes[0]), hn::Load(d, lanes[1]), hn::Load(d, lanes[2])}};
#endif
}

inline constexpr size_t kGroup = 4;  // components side by side

#if HWY_TARGET <= HWY_AVX3
/// Four floats of each of four places of eight triangles, row by row, become columns: element k of places 0 to 3.
struct FourColumns {
  ShadeV of[4];
};
HWY_INLINE void ColumnsOf(const __m512 row[8], FourColumns columns[4]) {
  const __m512i first = _mm512_setr_epi64(0, 1, 8, 9, 2, 3, 10, 11), last = _mm512_setr_epi64(4, 5, 12, 13, 6, 7, 14, 15);
  const auto pairs = [](__m512 v) { return _mm512_castps_pd(v); };
  const auto number = [](__m256d v) { return ShadeV{_mm512_cvtps_pd(_mm256_castpd_ps(v))}; };
  __m512d half[2][4];  // an element of four triangles, place by place
  for (int h = 0; h < 2; ++h) {
    const __m512* r = row + 4 * h;
    const __m512d low01 = pairs(_mm512_unpacklo_ps(r[0], r[1])), low23 = pairs(_mm512_unpacklo_ps(r[2], r[3]));
    const __m512d high01 = pairs(_mm512_unpackhi_ps(r[0], r[1])), high23 = pairs(_mm512_unpackhi_ps(r[2], r[3]));
    half[h][0] = _mm512_unpacklo_pd(low01, low23), half[h][1] = _mm512_unpackhi_pd(low01, low23);
    half[h][2] = _mm512_unpacklo_pd(high01, high23), half[h][3] = _mm512_unpackhi_pd(high01, high23);
  }
  for (size_t k = 0; k < 4; ++k) {
    const __m512d places01 = _mm512_permutex2var_pd(half[0][k], first, half[1][k]), places23 = _mm512_permutex2var_pd(half[0][k], last, half[1][k]);
    columns[k] = {{number(_mm512_castpd512_pd256(places01)), number(_mm512_extractf64x4_pd(places01, 1)),
                   number(_mm512_castpd512_pd256(places23)), number(_mm512_extractf64x4_pd(places23, 1))}};
  }
}

/// Of triangles with kGroup components: 1 / w and the values, a cache line each.
HWY_INLINE void LoadLines(const ValueTriangles& triangles, const uint32_t* HWY_RESTRICT t, PerVertex& reciprocalW, PerVertex group[kGroup]) {
  static_assert(carriedSize(kGroup) == 16);
  __m512 row[8];
  for (int lane = 0; lane < 8; ++lane) row[lane] = _mm512_loadu_ps(CarriedBy(triangles, kGroup, t[lane]));
  FourColumns columns[4];  // of each: 1 / w of a vertex, a component of the vertices
  ColumnsOf(row, columns);
  for (size_t k = 0; k < 3; ++k) reciprocalW.v[k] = columns[k].of[0];
  for (size_t k = 0; k < kGroup; ++k) group[k] = {{columns[k].of[1], columns[k].of[2], columns[k].of[3]}};
}

/// Of components [first, first + kGroup): the triangles' values by vertex.
HWY_INLINE void LoadGroup(const ValueTriangles& triangles, size_t count, size_t first, const uint32_t* HWY_RESTRICT t, PerVertex group[kGroup]) {
  __m512 row[8];
  for (int lane = 0; lane < 8; ++lane) {
    const float* HWY_RESTRICT v = CarriedBy(triangles, count, t[lane]) + kBeforeValues + first;
    row[lane] = _mm512_insertf32x4(_mm512_castps128_ps512(_mm_loadu_ps(v)), _mm_loadu_ps(v + count), 1);
    row[lane] = _mm512_insertf32x4(row[lane], _mm_loadu_ps(v + 2 * count), 2);
  }
  FourColumns columns[4];
  ColumnsOf(row, columns);
  for (size_t k = 0; k < kGroup; ++k) group[k] = {{columns[k].of[0], columns[k].of[1], columns[k].of[2]}};
}
#elif HWY_TARGET <= HWY_AVX2
HWY_INLINE void LoadGroup(const ValueTriangles& triangles, size_t count, size_t first, const uint32_t* HWY_RESTRICT t, PerVertex group[kGroup]) {
  const ShadeF f;
  const ShadeD d;
  const hn::Repartition<double, ShadeF> pairs;
  for (size_t vertex = 0; vertex < 3; ++vertex) {
    const auto row = [&](size_t lane) { return hn::LoadU(f, CarriedBy(triangles, count, t[lane]) + kBeforeValues + vertex * count + first); };
    const auto two = [&](auto v) { return hn::BitCast(pairs, v); };
    const auto row0 = row(0), row1 = row(1), row2 = row(2), row3 = row(3);
    const auto low01 = two(hn::InterleaveLower(f, row0, row1)), low23 = two(hn::InterleaveLower(f, row2, row3));
    const auto high01 = two(hn::InterleaveUpper(f, row0, row1)), high23 = two(hn::InterleaveUpper(f, row2, row3));
    const auto put = [&](size_t k, auto v) { group[k].v[vertex] = hn::PromoteTo(d, hn::BitCast(f, v)); };
    put(0, hn::InterleaveLower(pairs, low01, low23)), put(1, hn::InterleaveUpper(pairs, low01, low23));
    put(2, hn::InterleaveLower(pairs, high01, high23)), put(3, hn::InterleaveUpper(pairs, high01, high23));
  }
}
#endif

/// 1 / w, and with them, where all components are in perspective and lie in one line with them, their values; returns how many.
template <bool kAllPerspective>
HWY_INLINE size_t LoadReciprocalW(const ValueTriangles& triangles, size_t count, const uint32_t* HWY_RESTRICT t, PerVertex& reciprocalW,
                                  PerVertex group[kGroup]) {
#if HWY_TARGET <= HWY_AVX3
  if (kAllPerspective && count == kGroup) {
    LoadLines(triangles, t, reciprocalW, group);
    return kGroup;
  }
#endif
  (void)group;
  reciprocalW = ReciprocalWOf(triangles, count, t);
  return 0;
}

/// Of one component: the triangles' values by vertex.
HWY_INLINE PerVertex LoadOne(const ValueTriangles& triangles, size_t count, size_t component, const uint32_t* HWY_RESTRICT t) {
  const ShadeD d;
  alignas(64) double lanes[3][kShadeLanes];
  for (size_t lane = 0; lane < kShadeLanes; ++lane) {
    const float* HWY_RESTRICT v = CarriedBy(triangles, count, t[lane]) + kBeforeValues + component;
    for (size_t i = 0; i < 3; ++i) lanes[i][lane] = v[i * count];
  }
  return {{hn::Load(d, lanes[0]), hn::Load(d, lanes[1]), hn::Load(d, lanes[2])}};
}

}  // namespace HWY_NAMESPACE
}  // namespace rasterdiff::rasterizer
HWY_AFTER_NAMESPACE();
#endif
