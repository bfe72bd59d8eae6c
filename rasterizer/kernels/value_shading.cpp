// Deferred varyings: a vector of neighbouring samples at a time, each from its own primitive, without any set-up of triangles.
// Where the weights come from and how exact values are: value_weights-inl.h.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rasterizer/kernels/value_shading.cpp"
#include "hwy/foreach_target.h"
// After foreach_target.h:
#include <algorithm>
#include <cstdint>
#include <utility>

#include "hwy/highway.h"
#include "rasterizer/kernels/value_shading.hpp"
#include "rasterizer/kernels/value_weights-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rasterdiff::rasterizer {
namespace HWY_NAMESPACE {

inline constexpr size_t kGroup = 4;     // components side by side
inline constexpr uint32_t kTileColumns = 64;  // pixels, of a tile

/// The components' kinds, and what follows from them.
struct Components {
  size_t count = 0;
  const ValueKind* kinds = nullptr;
  bool noperspective = false, perspective = false;        // some component is
  bool all[kMaxValueComponents / kGroup] = {};            // a group's components all have perspective
  alignas(32) double perspectives[kMaxValueComponents] = {}, flats[kMaxValueComponents] = {};  // 1 for those
};

Components ComponentsOf(const ValueTriangles& triangles) {
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

/// Weights of a vector of pixels by kind; only those that some component needs are ever set.
struct alignas(64) WeightLanes {
  double noperspective[3][kShadeLanes] = {}, perspective[3][kShadeLanes] = {};
};

/// Where components go: their planes, from the vector's first pixel on; zero where nothing is drawn.
struct Outputs {
  float* const* to;
  size_t element;
  hn::Mask<ShadeF> drawn;

  HWY_INLINE void Put(size_t component, hn::Vec<ShadeF> value) const {
    hn::StoreU(hn::IfThenElseZero(drawn, value), ShadeF(), to[component] + element);
  }
};

/// All pixels have triangle `t`.
HWY_INLINE void ShadeOne(const ValueTriangles& triangles, size_t t, const Components& components, const WeightLanes& weights, const Outputs& out) {
  const ShadeD d;
  const size_t n = components.count;
  const float* HWY_RESTRICT v = triangles.values.data() + 3 * n * t;
  for (size_t c = 0; c < n; ++c) {
    if (components.kinds[c] == ValueKind::Flat) {
      out.Put(c, hn::Set(ShadeF(), v[c]));
      continue;
    }
    const auto& w = components.kinds[c] == ValueKind::Perspective ? weights.perspective : weights.noperspective;
    const auto value = [&](size_t vertex) { return hn::Set(d, double{v[vertex * n + c]}); };
    out.Put(c, hn::DemoteTo(ShadeF(), hn::Load(d, w[0]) * value(0) + hn::Load(d, w[1]) * value(1) + hn::Load(d, w[2]) * value(2)));
  }
}

#if HWY_TARGET <= HWY_AVX2
using GroupD = hn::CappedTag<double, kGroup>;
using GroupF = hn::CappedTag<float, kGroup>;
using GroupV = hn::Vec<GroupF>;

/// Four components of one pixel. Beyond the last component nothing is read.
template <bool kAllPerspective, bool kFull>
HWY_INLINE GroupV ShadeGroup(const float* HWY_RESTRICT v, size_t first, const Components& components, const WeightLanes& weights, size_t lane) {
  const GroupD d;
  const GroupF f;
  const size_t n = components.count;
  const auto value = [&](size_t vertex) {
    if (kFull) return hn::PromoteTo(d, hn::LoadU(f, v + vertex * n));
    return hn::PromoteTo(d, hn::MaskedLoad(hn::FirstN(f, n - first), f, v + vertex * n));
  };
  const auto is = [&](const double* kind) { return hn::Gt(hn::Load(d, kind + first), hn::Zero(d)); };
  const auto weight = [&](size_t i) {
    const auto perspective = hn::Set(d, weights.perspective[i][lane]);
    return kAllPerspective ? perspective : hn::IfThenElse(is(components.perspectives), perspective, hn::Set(d, weights.noperspective[i][lane]));
  };
  const auto v0 = value(0), sum = weight(0) * v0 + weight(1) * value(1) + weight(2) * value(2);
  return hn::DemoteTo(f, kAllPerspective ? sum : hn::IfThenElse(is(components.flats), v0, sum));
}

/// From pixels of four components to components of a vector of pixels.
HWY_INLINE void PutGroup(const GroupV* pixels, size_t first, size_t count, const Outputs& out) {
  const ShadeF f;
  const hn::Repartition<double, ShadeF> pairs;
  const auto row = [&](size_t k) {
#if HWY_TARGET <= HWY_AVX3
    return hn::Combine(f, pixels[k + kGroup], pixels[k]);
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

template <bool kAllPerspective, bool kFull, size_t... kLane>
HWY_INLINE void ShadeLanes(const float* HWY_RESTRICT values, const Places& places, size_t first, const Components& components,
                           const WeightLanes& weights, const Outputs& out, std::index_sequence<kLane...>) {
  const size_t each = 3 * components.count;
  const GroupV pixels[] = {ShadeGroup<kAllPerspective, kFull>(values + each * places.of[kLane] + first, first, components, weights, kLane)...};
  PutGroup(pixels, first, kFull ? kGroup : components.count - first, out);
}

/// A function of its own: a compiler that sees the loop over groups keeps all weights in registers, of which there are too few.
template <bool kAllPerspective, bool kFull>
HWY_NOINLINE void ShadeGroups(const float* HWY_RESTRICT values, const Places& places, size_t first, const Components& components,
                              const WeightLanes& weights, const Outputs& out) {
  ShadeLanes<kAllPerspective, kFull>(values, places, first, components, weights, out, std::make_index_sequence<kShadeLanes>());
}

/// Each pixel has its own triangle.
HWY_INLINE void ShadeMany(const ValueTriangles& triangles, const Places& places, const Components& components,
                          const WeightLanes& weights, const Outputs& out) {
  const float* HWY_RESTRICT values = triangles.values.data();
  for (size_t first = 0; first < components.count; first += kGroup) {
    if (components.count - first < kGroup) {
      ShadeGroups<false, false>(values, places, first, components, weights, out);
    } else if (components.all[first / kGroup]) {
      ShadeGroups<true, true>(values, places, first, components, weights, out);
    } else {
      ShadeGroups<false, true>(values, places, first, components, weights, out);
    }
  }
}
#else
HWY_INLINE void ShadeMany(const ValueTriangles& triangles, const Places& places, const Components& components,
                          const WeightLanes& weights, const Outputs& out) {
  const ShadeF f;
  const size_t n = components.count;
  for (size_t c = 0; c < n; ++c) {
    const auto& w = components.kinds[c] == ValueKind::Perspective ? weights.perspective : weights.noperspective;
    alignas(32) float pixels[kShadeLanes];
    for (size_t lane = 0; lane < kShadeLanes; ++lane) {
      const float* v = triangles.values.data() + 3 * n * places.of[lane] + c;
      const double sum = w[0][lane] * double{v[0]} + w[1][lane] * double{v[n]} + w[2][lane] * double{v[2 * n]};
      pixels[lane] = components.kinds[c] == ValueKind::Flat ? v[0] : static_cast<float>(sum);
    }
    out.Put(c, hn::Load(f, pixels));
  }
}
#endif

/// Vectors of a row of a tile. First the weights of all, then the values: from a pixel's number to its values it is so long a
/// way that a processor would look ahead no farther than the next vector.
struct TileRow {
  static constexpr size_t kVectors = kTileColumns / kShadeLanes;
  enum class What : uint8_t { Nothing, One, Many };
  What what[kVectors];
  Places places[kVectors];
  WeightLanes weights[kVectors];
};

HWY_INLINE TileRow::What FindWeights(const ValueTriangles& triangles, const uint32_t* HWY_RESTRICT numbers, const Components& components, bool far,
                                     uint32_t x, uint32_t y, Places& places, WeightLanes& weights) {
  const ShadeD d;
  const ShadeU u;
  const auto number = hn::LoadU(u, numbers);
  if (hn::AllTrue(u, hn::Eq(number, hn::Zero(u)))) return TileRow::What::Nothing;
  const SubpixelPosition centre{static_cast<int32_t>(x) * kSubpixelOne + kSubpixelOne / 2, static_cast<int32_t>(y) * kSubpixelOne + kSubpixelOne / 2};
  const ShadeV px = hn::MulAdd(hn::Iota(d, 0), hn::Set(d, kSubpixelOne), hn::Set(d, centre.x)), py = hn::Set(d, centre.y);
  const bool one = hn::AllTrue(u, hn::Eq(number, hn::Set(u, numbers[0])));
  hn::Store(hn::Max(number, hn::Set(u, 1)) - hn::Set(u, 1), u, places.of);  // nobody's pixels take any triangle
  const Corners3 corners = one ? CornersOfOne(triangles, places.of[0], components.perspective, px, py)
                               : CornersOfMany(triangles, places, components.perspective, px, py);
  const PerVertex b = HWY_UNLIKELY(far) ? FarEdgeFunctions(triangles, places, centre) : EdgeFunctions(corners);
  const auto put = [&](const PerVertex& w, double(*to)[kShadeLanes]) {
    for (size_t i = 0; i < 3; ++i) hn::Store(w.v[i], d, to[i]);
  };
  if (components.noperspective) put(WeightsOf(b.v[0], b.v[1], b.v[2]), weights.noperspective);
  if (components.perspective) put(WeightsOf(b.v[0] * corners.r.v[0], b.v[1] * corners.r.v[1], b.v[2] * corners.r.v[2]), weights.perspective);
  return one ? TileRow::What::One : TileRow::What::Many;
}

/// Fetches what a row will want of triangles that the row above has not.
HWY_INLINE void PrefetchRow(const ValueTriangles& triangles, const uint32_t* HWY_RESTRICT numbers, const uint32_t* HWY_RESTRICT above, size_t pixels) {
  const hn::CappedTag<uint32_t, 8> u;
  uint32_t found[kTileColumns + 8];
  size_t size = 0;
  for (size_t x = 0; x < pixels; x += hn::MaxLanes(u)) {
    const auto number = hn::LoadU(u, numbers + x);
    const auto other = hn::Ne(number, hn::LoadU(u, above + x));
    hn::StoreU(hn::Compress(number, other), u, found + size);
    size += hn::CountTrue(u, other);
  }
  const size_t values = 3 * triangles.kinds.size();
  for (size_t k = 0; k < size; ++k) {
    const size_t t = std::max(found[k], 1u) - size_t{1};
    __builtin_prefetch(&triangles.positions[t]);
    __builtin_prefetch(triangles.values.data() + values * t);
    __builtin_prefetch(triangles.values.data() + values * (t + 1) - 1);
    __builtin_prefetch(triangles.reciprocalW.data() + 3 * t);
  }
}

/// Fetches a row of a tile of one plane; beyond its end that does nothing.
template <class T>
HWY_INLINE void PrefetchPlane(const T* from) {
  constexpr size_t kLine = 16;  // elements
  for (size_t k = 0; k < kTileColumns; k += kLine) __builtin_prefetch(from + k);
}

/// Tile by tile, for the sake of caches: a tile's rows have much the same triangles.
void Shade(const ValueTriangles& triangles, ValueTarget& target, const DrawnArea& area) {
  constexpr uint32_t kTileRows = 32, kAhead = 2;
  const Components components = ComponentsOf(triangles);
  float* to[kMaxValueComponents] = {};
  for (size_t c = 0; c < components.count; ++c) to[c] = target.varyings[c].data();
  const uint32_t* HWY_RESTRICT numbers = target.primitive.data();
  TileRow row;
  const auto tile = [&](uint32_t left, uint32_t right, uint32_t top, uint32_t bottom) {
    for (uint32_t y = top; y < bottom; ++y)
      for (uint32_t s = 0; s < target.samples(); ++s) {
        if (y + kAhead < bottom)
          PrefetchRow(triangles, numbers + target.index(left, y + kAhead, s), numbers + target.index(left, y + kAhead - 1, s), right - left);
        const size_t next = target.index(left, y, s) + kTileColumns;  // the next tile: no sequence that a processor foresees
        PrefetchPlane(numbers + next);
        for (size_t c = 0; c < components.count; ++c) PrefetchPlane(to[c] + next);
        const size_t first = target.index(left, y, s), vectors = (right - left + kShadeLanes - 1) / kShadeLanes;
        for (size_t k = 0; k < vectors; ++k)
          row.what[k] = FindWeights(triangles, numbers + first + k * kShadeLanes, components, area.far, left + static_cast<uint32_t>(k * kShadeLanes), y,
                                    row.places[k], row.weights[k]);
        for (size_t k = 0; k < vectors; ++k) {
          if (row.what[k] == TileRow::What::Nothing) continue;
          const size_t element = first + k * kShadeLanes;
          const ShadeU u;
          const Outputs out{to, element, hn::RebindMask(ShadeF(), hn::Ne(hn::LoadU(u, numbers + element), hn::Zero(u)))};
          if (row.what[k] == TileRow::What::One) {
            ShadeOne(triangles, row.places[k].of[0], components, row.weights[k], out);
          } else {
            ShadeMany(triangles, row.places[k], components, row.weights[k], out);
          }
        }
      }
  };
  for (uint32_t top = area.top; top < area.bottom; top += kTileRows)
    for (uint32_t left = area.left / kTileColumns * kTileColumns; left < area.right; left += kTileColumns)
      tile(left, std::min(left + kTileColumns, area.right), top, std::min(top + kTileRows, area.bottom));
}

}  // namespace HWY_NAMESPACE
}  // namespace rasterdiff::rasterizer
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rasterdiff::rasterizer {

HWY_EXPORT(Shade);

void shadeArea(const ValueTriangles& triangles, ValueTarget& target, const DrawnArea& area) {
  HWY_DYNAMIC_DISPATCH(Shade)(triangles, target, area);
}

}  // namespace rasterdiff::rasterizer
#endif
