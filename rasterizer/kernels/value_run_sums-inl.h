// What a triangle's values are along a run of its pixels (value_runs-inl.h): set up once a run, a vector of runs at a time; for the
// instruction set being compiled. How pixels get their values from it: value_components-inl.h.
//
// The arithmetic. With bᵢ the edge function of the edge opposite to vertex i at a pixel's centre, a value is N / D,
//   N = Σ Pᵢ vᵢ,  D = Σ Pᵢ,  Pᵢ = bᵢ rᵢ (perspective, r = 1 / w) or bᵢ,
// and N and D are linear along a row: at the pixel `i` columns right of the run's first one
//   N = N' + i Σ Tᵢ vᵢ,  D = D' + i Σ Tᵢ,  Tᵢ = 256 sᵢ rᵢ or 256 sᵢ,  s = differences of the vertices' y,  ' at the first pixel.
// Within the fast range (|coordinates| <= 2^22) b', sums of two products below 2^48, s < 2^24 and Tᵢ (48 bits) are exact in
// doubles. Beyond it a run is one pixel, i = 0, and b' are 128-bit integers rounded once. Roundings, in units of u = 2^-53: Pᵢ' 1 (2
// beyond the fast range), Pᵢ' vᵢ and Tᵢ vᵢ one, sums two each, the product with i one, the sum with it one. Since i Tᵢ = Pᵢ - Pᵢ',
//   |error of N| <= u (8 Σ |Pᵢ' vᵢ| + 5 Σ |Pᵢ vᵢ|),  |error of D| <= u (6 Σ |Pᵢ'| + 4 Σ |Pᵢ|),
// and 1 / D and the product with it are one rounding each. A run's pixels are seen, so that their centres are inside of the
// triangle, or with several samples at most half a pixel outside of it: |bᵢ'| <= twice the area + 128 (|dx| + |dy|), d = the edge
// opposite to vertex i. All this is varyingBound; then the one rounding to float32. The shape of the triangle does not matter where
// centres are inside, how unlike the 1 / w of its vertices are does. No operation is fused but exact ones, so that every instruction set
// rounds alike.
#if defined(RASTERDIFF_VALUE_RUN_SUMS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RASTERDIFF_VALUE_RUN_SUMS_INL_H
#undef RASTERDIFF_VALUE_RUN_SUMS_INL_H
#else
#define RASTERDIFF_VALUE_RUN_SUMS_INL_H
#endif

#include <array>

#include "rasterizer/kernels/value_runs-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rasterdiff::rasterizer {
namespace HWY_NAMESPACE {

using ShadeD = hn::CappedTag<double, 8>;
using ShadeF = hn::Rebind<float, ShadeD>;
using ShadeU = hn::Rebind<uint32_t, ShadeD>;
using ShadeV = hn::Vec<ShadeD>;
inline constexpr size_t kShadeLanes = hn::MaxLanes(ShadeD());

/// Three vectors, one a vertex.
struct PerVertex {
  ShadeV v[3];
};

HWY_INLINE ShadeV SumOf(const PerVertex& p) { return p.v[0] + p.v[1] + p.v[2]; }
HWY_INLINE ShadeV SumOf(const PerVertex& p, const PerVertex& values) {
  return p.v[0] * values.v[0] + p.v[1] * values.v[1] + p.v[2] * values.v[2];
}

/// The components' kinds, and what follows from them.
struct Components {
  size_t count = 0;
  const ValueKind* kinds = nullptr;
  bool noperspective = false, perspective = false, allPerspective = true;
};

HWY_INLINE Components ComponentsOf(const ValueTriangles& triangles) {
  Components c{triangles.kinds.size(), triangles.kinds.data()};
  for (size_t i = 0; i < c.count; ++i) {
    c.noperspective |= c.kinds[i] == ValueKind::Noperspective;
    c.perspective |= c.kinds[i] == ValueKind::Perspective;
    c.allPerspective &= c.kinds[i] == ValueKind::Perspective;
  }
  return c;
}

/// By run: D at the first pixel and its growth a pixel (without perspective none), and N of each component. Flat: N is the value.
struct RunSums {
  static constexpr size_t kSize = Strip::kSize + Strip::kRoom;
  alignas(64) double perspective[2][kSize], noperspective[kSize];
  alignas(64) double at[kMaxValueComponents][kSize], growth[kMaxValueComponents][kSize];
};

/// Weights that are not normed: P at a run's first pixel, T a pixel.
struct RunWeights {
  PerVertex at, growth;
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

HWY_INLINE PerVertex ReciprocalWOf(const ValueTriangles& triangles, const uint32_t* HWY_RESTRICT t) {
  const float* HWY_RESTRICT r = triangles.reciprocalW.data();
#if HWY_TARGET <= HWY_AVX3
  __m256i row[8];
  __m512i columns[4];
  for (int lane = 0; lane < 8; ++lane) {
    const float* HWY_RESTRICT v = r + size_t{3} * t[lane];
    const __m128i two = _mm_loadl_epi64(reinterpret_cast<const __m128i*>(v));
    row[lane] = _mm256_castsi128_si256(_mm_castps_si128(_mm_mask_broadcastss_ps(_mm_castsi128_ps(two), 4, _mm_load_ss(v + 2))));
  }
  Transpose(row, columns);
  const auto number = [](__m256i v) { return ShadeV{_mm512_cvtps_pd(_mm256_castsi256_ps(v))}; };
  return {{number(LowHalf(columns[0])), number(LowHalf(columns[1])), number(LowHalf(columns[2]))}};
#else
  const ShadeD d;
  alignas(64) double lanes[3][kShadeLanes];
  for (size_t lane = 0; lane < kShadeLanes; ++lane)
    for (size_t i = 0; i < 3; ++i) lanes[i][lane] = r[size_t{3} * t[lane] + i];
  return {{hn::Load(d, lanes[0]), hn::Load(d, lanes[1]), hn::Load(d, lanes[2])}};
#endif
}

/// Edge functions where doubles would round.
HWY_NOINLINE PerVertex FarEdgeFunctions(const ValueTriangles& triangles, const uint32_t* HWY_RESTRICT t, ShadeV px, ShadeV py) {
  const ShadeD d;
  alignas(64) double x[kShadeLanes], y[kShadeLanes], lanes[3][kShadeLanes];
  hn::Store(px, d, x), hn::Store(py, d, y);
  for (size_t lane = 0; lane < kShadeLanes; ++lane) {
    const std::array<double, 3> exact = edgeFunctions(triangles.positions[t[lane]], {static_cast<int32_t>(x[lane]), static_cast<int32_t>(y[lane])});
    for (size_t i = 0; i < 3; ++i) lanes[i][lane] = exact[i];
  }
  return {{hn::Load(d, lanes[0]), hn::Load(d, lanes[1]), hn::Load(d, lanes[2])}};
}

inline constexpr size_t kGroup = 4;  // components side by side

#if HWY_TARGET <= HWY_AVX3
/// Of components [first, first + kGroup): the triangles' values by vertex.
HWY_INLINE void LoadGroup(const float* HWY_RESTRICT values, size_t count, size_t first, const uint32_t* HWY_RESTRICT t, PerVertex group[kGroup]) {
  __m512 row[8];  // of a triangle: four components of each vertex
  for (int lane = 0; lane < 8; ++lane) {
    const float* HWY_RESTRICT v = values + 3 * count * t[lane] + first;
    if (count == kGroup) {
      row[lane] = _mm512_castps256_ps512(_mm256_loadu_ps(v));
    } else {
      row[lane] = _mm512_insertf32x4(_mm512_castps128_ps512(_mm_loadu_ps(v)), _mm_loadu_ps(v + count), 1);
    }
    row[lane] = _mm512_insertf32x4(row[lane], _mm_loadu_ps(v + 2 * count), 2);
  }
  __m512d half[2][kGroup];  // a component of four triangles, vertex by vertex
  for (int h = 0; h < 2; ++h) {
    const __m512* r = row + 4 * h;
    const auto pairs = [](__m512 v) { return _mm512_castps_pd(v); };
    const __m512d low01 = pairs(_mm512_unpacklo_ps(r[0], r[1])), low23 = pairs(_mm512_unpacklo_ps(r[2], r[3]));
    const __m512d high01 = pairs(_mm512_unpackhi_ps(r[0], r[1])), high23 = pairs(_mm512_unpackhi_ps(r[2], r[3]));
    half[h][0] = _mm512_unpacklo_pd(low01, low23), half[h][1] = _mm512_unpackhi_pd(low01, low23);
    half[h][2] = _mm512_unpacklo_pd(high01, high23), half[h][3] = _mm512_unpackhi_pd(high01, high23);
  }
  const __m512i vertices01 = _mm512_setr_epi64(0, 1, 8, 9, 2, 3, 10, 11), vertex2 = _mm512_setr_epi64(4, 5, 12, 13, 4, 5, 12, 13);
  const auto number = [](__m256d v) { return ShadeV{_mm512_cvtps_pd(_mm256_castpd_ps(v))}; };
  for (size_t k = 0; k < kGroup; ++k) {
    const __m512d both = _mm512_permutex2var_pd(half[0][k], vertices01, half[1][k]);
    const __m512d last = _mm512_permutex2var_pd(half[0][k], vertex2, half[1][k]);
    group[k] = {{number(_mm512_castpd512_pd256(both)), number(_mm512_extractf64x4_pd(both, 1)), number(_mm512_castpd512_pd256(last))}};
  }
}
#elif HWY_TARGET <= HWY_AVX2
HWY_INLINE void LoadGroup(const float* HWY_RESTRICT values, size_t count, size_t first, const uint32_t* HWY_RESTRICT t, PerVertex group[kGroup]) {
  const ShadeF f;
  const ShadeD d;
  const hn::Repartition<double, ShadeF> pairs;
  for (size_t vertex = 0; vertex < 3; ++vertex) {
    const auto row = [&](size_t lane) { return hn::LoadU(f, values + (size_t{3} * t[lane] + vertex) * count + first); };
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

/// Of one component: the triangles' values by vertex.
HWY_INLINE PerVertex LoadOne(const float* HWY_RESTRICT values, size_t count, size_t component, const uint32_t* HWY_RESTRICT t) {
  const ShadeD d;
  alignas(64) double lanes[3][kShadeLanes];
  for (size_t lane = 0; lane < kShadeLanes; ++lane)
    for (size_t i = 0; i < 3; ++i) lanes[i][lane] = values[(size_t{3} * t[lane] + i) * count + component];
  return {{hn::Load(d, lanes[0]), hn::Load(d, lanes[1]), hn::Load(d, lanes[2])}};
}

HWY_INLINE void StoreComponent(const RunWeights& weights, const PerVertex& values, size_t c, size_t k, RunSums& sums) {
  hn::Store(SumOf(weights.at, values), ShadeD(), sums.at[c] + k);
  hn::Store(SumOf(weights.growth, values), ShadeD(), sums.growth[c] + k);
}

/// Sets up the runs of a strip; `left`: the centre of its first column, 1/256 pixel; `far`: beyond the fast range.
template <bool kAllPerspective>
HWY_NOINLINE void SetUpRunsOf(const ValueTriangles& triangles, const Components& components, double left, bool far, Strip& strip, RunSums& sums) {
  const ShadeD d;
  const hn::Rebind<int32_t, ShadeD> whole;
  const NumberTag u;
  for (size_t k = 0; k < kShadeLanes; k += kNumberLanes) hn::StoreU(hn::Zero(u), u, strip.places + strip.size + k);
  const ShadeV one = hn::Set(d, kSubpixelOne);
  for (size_t k = 0; k < strip.size; k += kShadeLanes) {
    const uint32_t* HWY_RESTRICT t = strip.places + k;
    const ShadeV px = hn::MulAdd(hn::PromoteTo(d, hn::LoadU(whole, strip.columns + k)), one, hn::Set(d, left)), py = hn::Load(d, strip.y + k);
    const Corners3 c = CornersOf(triangles, t, px, py);
    RunWeights plain;
    for (size_t i = 0; i < 3; ++i) {
      const size_t j = (i + 1) % 3, l = (i + 2) % 3;
      plain.at.v[i] = c.x.v[j] * c.y.v[l] - c.x.v[l] * c.y.v[j];
      plain.growth.v[i] = (c.y.v[j] - c.y.v[l]) * one;
    }
    if (HWY_UNLIKELY(far)) plain.at = FarEdgeFunctions(triangles, t, px, py);
    RunWeights perspective = plain;
    if (kAllPerspective || components.perspective) {
      const PerVertex r = ReciprocalWOf(triangles, t);
      for (size_t i = 0; i < 3; ++i) perspective.at.v[i] = plain.at.v[i] * r.v[i], perspective.growth.v[i] = plain.growth.v[i] * r.v[i];
      hn::Store(SumOf(perspective.at), d, sums.perspective[0] + k);
      hn::Store(SumOf(perspective.growth), d, sums.perspective[1] + k);
    }
    if (!kAllPerspective && components.noperspective) hn::Store(SumOf(plain.at), d, sums.noperspective + k);
    size_t first = 0;
#if HWY_TARGET <= HWY_AVX2
    if (kAllPerspective) {
      for (; first + kGroup <= components.count; first += kGroup) {
        PerVertex group[kGroup];
        LoadGroup(triangles.values.data(), components.count, first, t, group);
        for (size_t i = 0; i < kGroup; ++i) StoreComponent(perspective, group[i], first + i, k, sums);
      }
    }
#endif
    for (; first < components.count; ++first) {
      const PerVertex values = LoadOne(triangles.values.data(), components.count, first, t);
      switch (components.kinds[first]) {
        case ValueKind::Flat: hn::Store(values.v[0], d, sums.at[first] + k); break;
        case ValueKind::Noperspective: StoreComponent(plain, values, first, k, sums); break;
        case ValueKind::Perspective: StoreComponent(perspective, values, first, k, sums); break;
      }
    }
  }
}

HWY_INLINE void SetUpRuns(const ValueTriangles& triangles, const Components& components, double left, bool far, Strip& strip, RunSums& sums) {
  if (components.allPerspective) {
    SetUpRunsOf<true>(triangles, components, left, far, strip, sums);
  } else {
    SetUpRunsOf<false>(triangles, components, left, far, strip, sums);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace rasterdiff::rasterizer
HWY_AFTER_NAMESPACE();
#endif
