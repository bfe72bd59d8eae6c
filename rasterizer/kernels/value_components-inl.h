// Varyings of some neighbouring pixels from weights: all with one triangle, or each with its own; for the instruction set being compiled.
#if defined(RASTERDIFF_VALUE_COMPONENTS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RASTERDIFF_VALUE_COMPONENTS_INL_H
#undef RASTERDIFF_VALUE_COMPONENTS_INL_H
#else
#define RASTERDIFF_VALUE_COMPONENTS_INL_H
#endif

#include <algorithm>
#include <cstdint>
#include <utility>

#include "hwy/cache_control.h"
#include "hwy/highway.h"
#include "rasterizer/kernels/value_view.hpp"
#include "rasterizer/kernels/value_weights-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rasterdiff::rasterizer {
namespace HWY_NAMESPACE {

inline constexpr size_t kGroup = 4;  // components side by side

/// The components' kinds, and what follows from them.
struct Components {
  size_t count = 0;
  const ValueKind* kinds = nullptr;
  bool noperspective = false, perspective = false;        // some component is
  bool all[kMaxValueComponents / kGroup] = {};            // a group's components all have perspective
  alignas(32) double perspectives[kMaxValueComponents] = {}, flats[kMaxValueComponents] = {};  // 1 for those
};

HWY_INLINE Components ComponentsOf(const ValueTriangles& triangles) {
  Components c;
  c.count = triangles.kinds.size(), c.kinds = triangles.kinds.data();
  std::fill(std::begin(c.all), std::end(c.all), true);
  for (size_t i = 0; i < c.count; ++i) {
    c.noperspective |= c.kinds[i] == ValueKind::Noperspective;
    c.perspective |= c.kinds[i] == ValueKind::Perspective;
    c.all[i / kGroup] &= c.kinds[i] == ValueKind::Perspective;
    c.perspectives[i] = c.kinds[i] == ValueKind::Perspective ? 1 : 0;
    c.flats[i] = c.kinds[i] == ValueKind::Flat ? 1 : 0;
  }
  return c;
}

// A line: pixels whose floats are stored at once.
#if HWY_TARGET <= HWY_AVX3
using LineF = hn::CappedTag<float, 16>;
#else
using LineF = ShadeF;
#endif
inline constexpr size_t kLinePixels = hn::MaxLanes(LineF());

/// Of the pixels of a line: weights by kind, of which only those that some component needs are ever set, and where the values of their
/// triangles begin.
struct alignas(64) LineWeights {
  double noperspective[3][kLinePixels] = {}, perspective[3][kLinePixels] = {};
  size_t values[kLinePixels];
};

/// Where components go: their planes, from the line's first pixel on; zero where nothing is drawn. kPast: past the caches.
template <bool kPast>
struct Outputs {
  float* const* to;
  size_t element;
  hn::Mask<LineF> drawn;

  HWY_INLINE void Put(size_t component, hn::Vec<LineF> value) const {
    const auto v = hn::IfThenElseZero(drawn, value);
    if (kPast) {
      hn::Stream(v, LineF(), to[component] + element);
    } else {
      hn::Store(v, LineF(), to[component] + element);
    }
  }
};

/// All pixels have the triangle whose values are `v`.
template <class Out>
HWY_INLINE void ShadeOne(const float* HWY_RESTRICT v, const Components& components, const LineWeights& weights, const Out& out) {
  const ShadeD d;
  const size_t n = components.count;
  for (size_t c = 0; c < n; ++c) {
    if (components.kinds[c] == ValueKind::Flat) {
      out.Put(c, hn::Set(LineF(), v[c]));
      continue;
    }
    const auto& w = components.kinds[c] == ValueKind::Perspective ? weights.perspective : weights.noperspective;
    const auto part = [&](size_t first) {
      const auto term = [&](size_t vertex) { return hn::Load(d, w[vertex] + first) * hn::Set(d, double{v[vertex * n + c]}); };
      return hn::DemoteTo(ShadeF(), term(0) + term(1) + term(2));
    };
#if HWY_TARGET <= HWY_AVX3
    out.Put(c, hn::Combine(LineF(), part(kShadeLanes), part(0)));
#else
    out.Put(c, part(0));
#endif
  }
}

#if HWY_TARGET <= HWY_AVX2
using GroupD = hn::CappedTag<double, kGroup>;
using GroupF = hn::CappedTag<float, kGroup>;
using GroupV = hn::Vec<GroupF>;

/// Four components of one pixel. Beyond the last component nothing is read.
template <bool kAllPerspective, bool kFull>
HWY_INLINE GroupV ShadeGroup(const float* HWY_RESTRICT v, size_t first, const Components& components, const LineWeights& weights, size_t pixel) {
  const GroupD d;
  const GroupF f;
  const size_t n = components.count;
  const auto value = [&](size_t vertex) {
    if (kFull) return hn::PromoteTo(d, hn::LoadU(f, v + vertex * n));
    return hn::PromoteTo(d, hn::MaskedLoad(hn::FirstN(f, n - first), f, v + vertex * n));
  };
  const auto is = [&](const double* kind) { return hn::Gt(hn::Load(d, kind + first), hn::Zero(d)); };
  const auto weight = [&](size_t i) {
    const auto perspective = hn::Set(d, weights.perspective[i][pixel]);
    return kAllPerspective ? perspective : hn::IfThenElse(is(components.perspectives), perspective, hn::Set(d, weights.noperspective[i][pixel]));
  };
  const auto v0 = value(0), sum = weight(0) * v0 + weight(1) * value(1) + weight(2) * value(2);
  return hn::DemoteTo(f, kAllPerspective ? sum : hn::IfThenElse(is(components.flats), v0, sum));
}

/// From pixels of four components to components of a line.
template <class Out>
HWY_INLINE void PutGroup(const GroupV* pixels, size_t first, size_t count, const Out& out) {
  const LineF f;
  const hn::Repartition<double, LineF> pairs;
  const auto row = [&](size_t k) {
#if HWY_TARGET <= HWY_AVX3
    const hn::Half<LineF> half;
    return hn::Combine(f, hn::Combine(half, pixels[k + 3 * kGroup], pixels[k + 2 * kGroup]), hn::Combine(half, pixels[k + kGroup], pixels[k]));
#else
    return pixels[k];
#endif
  };
  const auto two = [&](auto v) { return hn::BitCast(pairs, v); };
  const auto row0 = row(0), row1 = row(1), row2 = row(2), row3 = row(3);
  const auto low01 = two(hn::InterleaveLower(f, row0, row1)), low23 = two(hn::InterleaveLower(f, row2, row3));
  const auto high01 = two(hn::InterleaveUpper(f, row0, row1)), high23 = two(hn::InterleaveUpper(f, row2, row3));
  out.Put(first, hn::BitCast(f, hn::InterleaveLower(pairs, low01, low23)));
  if (count > 1) out.Put(first + 1, hn::BitCast(f, hn::InterleaveUpper(pairs, low01, low23)));
  if (count > 2) out.Put(first + 2, hn::BitCast(f, hn::InterleaveLower(pairs, high01, high23)));
  if (count > 3) out.Put(first + 3, hn::BitCast(f, hn::InterleaveUpper(pairs, high01, high23)));
}

template <bool kAllPerspective, bool kFull, class Out, size_t... kPixel>
HWY_INLINE void ShadePixels(const float* HWY_RESTRICT values, size_t first, const Components& components, const LineWeights& weights, const Out& out,
                            std::index_sequence<kPixel...>) {
  const GroupV pixels[] = {ShadeGroup<kAllPerspective, kFull>(values + weights.values[kPixel] + first, first, components, weights, kPixel)...};
  PutGroup(pixels, first, kFull ? kGroup : components.count - first, out);
}

/// A function of its own: a compiler that sees the loop over groups keeps all weights in registers, of which there are too few.
template <bool kAllPerspective, bool kFull, class Out>
HWY_NOINLINE void ShadeGroups(const float* HWY_RESTRICT values, size_t first, const Components& components, const LineWeights& weights, const Out& out) {
  ShadePixels<kAllPerspective, kFull>(values, first, components, weights, out, std::make_index_sequence<kLinePixels>());
}

/// Each pixel has its own triangle.
template <class Out>
HWY_INLINE void ShadeMany(const float* HWY_RESTRICT values, const Components& components, const LineWeights& weights, const Out& out) {
  for (size_t first = 0; first < components.count; first += kGroup) {
    if (components.count - first < kGroup) {
      ShadeGroups<false, false>(values, first, components, weights, out);
    } else if (components.all[first / kGroup]) {
      ShadeGroups<true, true>(values, first, components, weights, out);
    } else {
      ShadeGroups<false, true>(values, first, components, weights, out);
    }
  }
}
#else
template <class Out>
HWY_INLINE void ShadeMany(const float* HWY_RESTRICT values, const Components& components, const LineWeights& weights, const Out& out) {
  const size_t n = components.count;
  for (size_t c = 0; c < n; ++c) {
    const auto& w = components.kinds[c] == ValueKind::Perspective ? weights.perspective : weights.noperspective;
    alignas(32) float pixels[kLinePixels];
    for (size_t k = 0; k < kLinePixels; ++k) {
      const float* v = values + weights.values[k] + c;
      const double sum = w[0][k] * double{v[0]} + w[1][k] * double{v[n]} + w[2][k] * double{v[2 * n]};
      pixels[k] = components.kinds[c] == ValueKind::Flat ? v[0] : static_cast<float>(sum);
    }
    out.Put(c, hn::Load(LineF(), pixels));
  }
}
#endif

}  // namespace HWY_NAMESPACE
}  // namespace rasterdiff::rasterizer
HWY_AFTER_NAMESPACE();
#endif
