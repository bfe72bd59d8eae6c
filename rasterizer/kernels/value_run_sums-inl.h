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

#include "rasterizer/kernels/value_carried-inl.h"
#include "rasterizer/kernels/value_runs-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rasterdiff::rasterizer {
namespace HWY_NAMESPACE {

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
      plain.at.v[i] = hn::MulSub(c.x.v[j], c.y.v[l], c.x.v[l] * c.y.v[j]);  // exact
      plain.growth.v[i] = (c.y.v[j] - c.y.v[l]) * one;
    }
    if (HWY_UNLIKELY(far)) plain.at = FarEdgeFunctions(triangles, t, px, py);
    RunWeights perspective = plain;
    PerVertex group[kGroup];
    size_t first = 0;
    if (kAllPerspective || components.perspective) {
      PerVertex r;
      first = LoadReciprocalW<kAllPerspective>(triangles, components.count, t, r, group);
      for (size_t i = 0; i < 3; ++i) perspective.at.v[i] = plain.at.v[i] * r.v[i], perspective.growth.v[i] = plain.growth.v[i] * r.v[i];
      hn::Store(SumOf(perspective.at), d, sums.perspective[0] + k);
      hn::Store(SumOf(perspective.growth), d, sums.perspective[1] + k);
    }
    if (!kAllPerspective && components.noperspective) hn::Store(SumOf(plain.at), d, sums.noperspective + k);
    for (size_t i = 0; i < first; ++i) StoreComponent(perspective, group[i], i, k, sums);
#if HWY_TARGET <= HWY_AVX2
    if (kAllPerspective) {
      for (; first + kGroup <= components.count; first += kGroup) {
        LoadGroup(triangles, components.count, first, t, group);
        for (size_t i = 0; i < kGroup; ++i) StoreComponent(perspective, group[i], first + i, k, sums);
      }
    }
#endif
    for (; first < components.count; ++first) {
      const PerVertex values = LoadOne(triangles, components.count, first, t);
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
