// Weights of a triangle's vertices at pixels' centres: edge functions are set up once a run of pixels (value_runs-inl.h), a vector
// of runs at a time, and spread to the pixels by permutations; for the instruction set being compiled. What is made of the
// weights is value_shading.cpp's.
//
// The arithmetic. With bᵢ the edge function of the edge opposite to vertex i at the pixel's centre, a value is
//   Σ wᵢ vᵢ,  wᵢ = Pᵢ / (P0 + P1 + P2),  Pᵢ = bᵢ rᵢ (perspective, r = 1 / w) or bᵢ.
// Within the fast range (|coordinates| <= 2^22) the bᵢ are integers: at the centre in the tile's first column, which is less than 64
// pixels away, sums of two exact products, below 2^48; in column i that and step · 256 i, step = a difference of y < 2^24.
// All of it is exact in doubles, so that it does not matter from where a pixel is reached. Beyond the fast range bᵢ are 128-bit
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

#include "hwy/highway.h"

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

HWY_INLINE PerVertex WeightsOf(ShadeV p0, ShadeV p1, ShadeV p2) {
  const ShadeV q = hn::Set(ShadeD(), 1.0) / (p0 + p1 + p2);
  return {{p0 * q, p1 * q, p2 * q}};
}

}  // namespace HWY_NAMESPACE
}  // namespace rasterdiff::rasterizer
HWY_AFTER_NAMESPACE();
#endif
