// Weights of a triangle's vertices in a vector of neighbouring pixels, each with a triangle of its own or all with one; for the
// instruction set being compiled. What is made of them is value_shading.cpp's.
//
// The arithmetic. With bᵢ the edge function of the edge opposite to vertex i at the pixel's centre, a value is
//   Σ wᵢ vᵢ,  wᵢ = Pᵢ / (P0 + P1 + P2),  Pᵢ = bᵢ rᵢ (perspective, r = 1 / w) or bᵢ.
// Within the fast range (|coordinates| <= 2^22) the bᵢ are integers below 2^48 and exact in doubles; beyond it they are 128-bit
// integers rounded once. Roundings, in units of u = 2^-53: Pᵢ 1 (2 beyond the fast range); the sum D of them 4 κ in all with
// κ = Σ |Pᵢ| / |D|, which is 1 where the centre is inside; q = 1 / D one; wᵢ = Pᵢ q one; wᵢ vᵢ one; two sums two. So
//   |error| <= u (7 + 5 κ) Σ |wᵢ vᵢ|: varyingBound; then the one rounding to float32.
// The shape of the triangle does not matter: no differences of values, no gradients, nothing cancels but what lies outside.
// No operation is fused but exact ones, so that every instruction set rounds alike.
#if defined(RASTERDIFF_VALUE_WEIGHTS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RASTERDIFF_VALUE_WEIGHTS_INL_H
#undef RASTERDIFF_VALUE_WEIGHTS_INL_H
#else
#define RASTERDIFF_VALUE_WEIGHTS_INL_H
#endif

#include <algorithm>
#include <array>

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

/// Vertices relative to the pixels' centres in 1/256 pixel, and 1 / w.
struct Corners3 {
  PerVertex x, y, r;
};

/// The pixels' triangles by place.
struct alignas(32) Places {
  uint32_t of[kShadeLanes];
};

/// One triangle for all pixels.
HWY_INLINE Corners3 CornersOfOne(const ValueTriangles& triangles, size_t t, bool perspective, ShadeV px, ShadeV py) {
  const ShadeD d;
  const auto& v = triangles.positions[t].v;
  Corners3 c;
  for (size_t i = 0; i < 3; ++i) {
    c.x.v[i] = hn::Set(d, static_cast<double>(v[i].x)) - px, c.y.v[i] = hn::Set(d, static_cast<double>(v[i].y)) - py;
    c.r.v[i] = hn::Set(d, perspective ? double{triangles.reciprocalW[3 * t + i]} : 1.0);
  }
  return c;
}

#if HWY_TARGET <= HWY_AVX3
/// Eight rows of up to eight dwords become eight columns; the first kColumns of them as the low and high halves of
/// column k and k + 4.
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

/// A triangle for each pixel.
HWY_INLINE Corners3 CornersOfMany(const ValueTriangles& triangles, const Places& places, bool perspective, ShadeV px, ShadeV py) {
  Corners3 c;
#if HWY_TARGET <= HWY_AVX3
  static_assert(sizeof(SnappedTriangle) == 24);
  __m256i row[8];
  __m512i columns[4];
  for (int lane = 0; lane < 8; ++lane) row[lane] = _mm256_maskz_loadu_epi32(0x3F, &triangles.positions[places.of[lane]]);
  Transpose(row, columns);  // x0 and x2, y0 and y2, x1, y1
  const auto number = [](__m256i v) { return ShadeV{_mm512_cvtepi32_pd(v)}; };
  c.x = {{number(LowHalf(columns[0])) - px, number(LowHalf(columns[2])) - px, number(HighHalf(columns[0])) - px}};
  c.y = {{number(LowHalf(columns[1])) - py, number(LowHalf(columns[3])) - py, number(HighHalf(columns[1])) - py}};
  const ShadeV one = hn::Set(ShadeD(), 1.0);
  c.r = {{one, one, one}};
  if (!perspective) return c;
  for (int lane = 0; lane < 8; ++lane)
    row[lane] = _mm256_castsi128_si256(_mm_castps_si128(_mm_maskz_loadu_ps(7, triangles.reciprocalW.data() + size_t{3} * places.of[lane])));
  Transpose(row, columns);
  for (int i = 0; i < 3; ++i) c.r.v[i] = ShadeV{_mm512_cvtps_pd(_mm256_castsi256_ps(LowHalf(columns[i])))};
#else
  const ShadeD d;
  alignas(64) double x[3][kShadeLanes], y[3][kShadeLanes], r[3][kShadeLanes];
  for (size_t lane = 0; lane < kShadeLanes; ++lane) {
    const size_t t = places.of[lane];
    const auto& v = triangles.positions[t].v;
    for (size_t i = 0; i < 3; ++i) {
      x[i][lane] = v[i].x, y[i][lane] = v[i].y;
      r[i][lane] = perspective ? double{triangles.reciprocalW[3 * t + i]} : 1.0;
    }
  }
  for (size_t i = 0; i < 3; ++i)
    c.x.v[i] = hn::Load(d, x[i]) - px, c.y.v[i] = hn::Load(d, y[i]) - py, c.r.v[i] = hn::Load(d, r[i]);
#endif
  return c;
}

HWY_INLINE PerVertex EdgeFunctions(const Corners3& c) {
  PerVertex b;
  for (size_t i = 0; i < 3; ++i) {
    const size_t j = (i + 1) % 3, k = (i + 2) % 3;
    b.v[i] = c.x.v[j] * c.y.v[k] - c.x.v[k] * c.y.v[j];
  }
  return b;
}

/// The same where doubles would round; the first pixel's centre is `p`.
HWY_NOINLINE PerVertex FarEdgeFunctions(const ValueTriangles& triangles, const Places& places, SubpixelPosition p) {
  alignas(64) double lanes[3][kShadeLanes];
  for (size_t lane = 0; lane < kShadeLanes; ++lane, p.x += kSubpixelOne) {
    const std::array<double, 3> exact = edgeFunctions(triangles.positions[places.of[lane]], p);
    for (size_t i = 0; i < 3; ++i) lanes[i][lane] = exact[i];
  }
  const ShadeD d;
  return {{hn::Load(d, lanes[0]), hn::Load(d, lanes[1]), hn::Load(d, lanes[2])}};
}

HWY_INLINE PerVertex WeightsOf(ShadeV p0, ShadeV p1, ShadeV p2) {
  const ShadeV q = hn::Set(ShadeD(), 1.0) / (p0 + p1 + p2);
  return {{p0 * q, p1 * q, p2 * q}};
}

}  // namespace HWY_NAMESPACE
}  // namespace rasterdiff::rasterizer
HWY_AFTER_NAMESPACE();
#endif
