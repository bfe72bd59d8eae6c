// Deferred varyings: runs of pixels of one primitive; the planes of all components side by side in a vector, then the
// pixels of the run. Bound and arithmetic: value_setup-inl.h, the chunk being the whole way from the anchor.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rasterizer/kernels/value_shading.cpp"
#define HWY_DISABLED_TARGETS HWY_SSSE3
#include "hwy/foreach_target.h"
// After foreach_target.h:
#include <algorithm>
#include <cstdint>
#include <vector>

#include "hwy/highway.h"
#include "rasterizer/kernels/value_shading.hpp"

HWY_BEFORE_NAMESPACE();
namespace rasterdiff::rasterizer {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using ShadeD = hn::CappedTag<double, 8>;
using ShadeF = hn::Rebind<float, ShadeD>;
using ShadeU = hn::Rebind<uint32_t, ShadeD>;
using ShadeV = hn::Vec<ShadeD>;
inline constexpr size_t kShadeLanes = hn::MaxLanes(ShadeD());
inline constexpr size_t kMostPlanes = kMaxValueComponents + kShadeLanes;  // the components', that of 1 / w, a vector's rest

/// The components' kinds as factors.
struct Components {
  size_t count = 0, planes = 0;  // components; whole vectors of them and of 1 / w
  bool perspective[kMaxValueComponents] = {};
  bool anyPerspective = false;
  alignas(64) double sloped[kMostPlanes] = {};    // 0 for flat: no gradient
  alignas(64) double weighted[kMostPlanes] = {};  // 1 for perspective: the value times 1 / w
  alignas(64) double ones[kMostPlanes] = {};      // 1 for the plane of 1 / w, whose value is 1
};

Components ComponentsOf(const ValueTriangles& triangles) {
  Components c;
  c.count = triangles.kinds.size();
  c.planes = (c.count + kShadeLanes) / kShadeLanes * kShadeLanes;
  for (size_t i = 0; i < c.count; ++i) {
    c.perspective[i] = triangles.kinds[i] == ValueKind::Perspective;
    c.anyPerspective |= c.perspective[i];
    c.sloped[i] = triangles.kinds[i] == ValueKind::Flat ? 0 : 1;
    c.weighted[i] = c.perspective[i] ? 1 : 0;
  }
  c.sloped[c.count] = c.weighted[c.count] = c.ones[c.count] = 1;
  return c;
}

/// Planes of one triangle, component beside component: value = (a0 + gy (y - y0)) + gx (x - x0).
struct TrianglePlanes {
  uint32_t number = 0;  // 1 + the triangle's place
  double x0 = 0, y0 = 0;  // of vertex 0, pixels
  alignas(64) double a0[kMostPlanes], gx[kMostPlanes], gy[kMostPlanes];
};

/// A triangle's rows meet again and again: their planes wait here.
struct PlaneCache {
  static constexpr size_t kSize = 1024;
  std::vector<TrianglePlanes> planes = std::vector<TrianglePlanes>(kSize);
  TrianglePlanes& of(uint32_t number) { return planes[number % kSize]; }
};

HWY_NOINLINE void SetUpPlanes(const ValueTriangles& triangles, uint32_t number, const Components& components, TrianglePlanes& planes) {
  const ShadeD d;
  const ShadeF df;
  const size_t t = number - 1, n = components.count;
  const auto& v = triangles.positions[t].v;
  const double ax = v[0].x, ay = v[0].y;
  const double e1x = v[1].x - ax, e1y = v[1].y - ay, e2x = v[2].x - ax, e2y = v[2].y - ay;
  const ShadeV q = hn::Set(d, kSubpixelOne / (e1x * e2y - e1y * e2x));
  planes.number = number;
  planes.x0 = ax / kSubpixelOne, planes.y0 = ay / kSubpixelOne;
  const float* values = triangles.values.data() + 3 * n * t;
  float copy[3 * kMaxValueComponents + kMostPlanes] = {};
  if (HWY_UNLIKELY(3 * n * t + 2 * n + components.planes > triangles.values.size())) {  // vectors would reach beyond the end
    std::copy_n(values, 3 * n, copy);
    values = copy;
  }
  for (size_t c = 0; c < components.planes; c += kShadeLanes) {
    const ShadeV weighted = hn::Load(d, components.weighted + c), sloped = hn::Load(d, components.sloped + c);
    const ShadeV ones = hn::Load(d, components.ones + c);
    const auto isOne = hn::Ne(ones, hn::Zero(d));
    ShadeV a[3];
    for (size_t k = 0; k < 3; ++k) {
      const ShadeV value = hn::IfThenElse(isOne, ones, hn::PromoteTo(d, hn::LoadU(df, values + k * n + c)));
      // 1, or 1 / w: sums of a number and zero.
      const double w = components.anyPerspective ? double{triangles.reciprocalW[3 * t + k]} : 1.0;
      a[k] = value * (weighted * hn::Set(d, w) + (hn::Set(d, 1.0) - weighted));
    }
    const ShadeV d1 = (a[1] - a[0]) * sloped, d2 = (a[2] - a[0]) * sloped;
    hn::Store(a[0], d, planes.a0 + c);
    hn::Store((d1 * hn::Set(d, e2y) - d2 * hn::Set(d, e1y)) * q, d, planes.gx + c);
    hn::Store((d2 * hn::Set(d, e1x) - d1 * hn::Set(d, e2x)) * q, d, planes.gy + c);
  }
}

/// Pixels [x, end) of row y, which starts at element `row` of the planes.
HWY_INLINE void ShadeRun(const TrianglePlanes& planes, const Components& components, float* const* HWY_RESTRICT to, double y, size_t row,
                         size_t x, size_t end) {
  const ShadeD d;
  const ShadeF df;
  alignas(64) double start[kMostPlanes];
  const ShadeV dy = hn::Set(d, y + 0.5 - planes.y0);
  for (size_t c = 0; c < components.planes; c += kShadeLanes)
    hn::Store(hn::Load(d, planes.a0 + c) + hn::Load(d, planes.gy + c) * dy, d, start + c);
  const double fromX = 0.5 - planes.x0;
  const size_t n = components.count;
  for (; x < end; x += kShadeLanes) {
    const auto mask = hn::FirstN(df, end - x);
    const ShadeV dx = hn::Set(d, static_cast<double>(x) + fromX) + hn::Iota(d, 0);
    ShadeV w = hn::Set(d, 1.0);
    if (components.anyPerspective) w = w / (hn::Set(d, start[n]) + hn::Set(d, planes.gx[n]) * dx);
    for (size_t c = 0; c < n; ++c) {
      ShadeV value = hn::Set(d, start[c]) + hn::Set(d, planes.gx[c]) * dx;
      if (components.perspective[c]) value = value * w;
      hn::BlendedStore(hn::DemoteTo(df, value), mask, df, to[c] + row + x);
    }
  }
}

/// First pixel in [x, width) whose number is not `number`; the row has kValuePadding more.
HWY_INLINE size_t EndOfRun(const uint32_t* HWY_RESTRICT numbers, size_t x, size_t width, uint32_t number) {
  const ShadeU du;
  for (; x < width; x += kShadeLanes) {
    const intptr_t other = hn::FindFirstTrue(du, hn::Ne(hn::LoadU(du, numbers + x), hn::Set(du, number)));
    if (other >= 0) return std::min(width, x + static_cast<size_t>(other));
  }
  return width;
}

void Shade(const ValueTriangles& triangles, ValueTarget& target, ShadedArea area) {
  const Components components = ComponentsOf(triangles);
  PlaneCache cache;
  float* to[kMaxValueComponents] = {};
  for (size_t c = 0; c < components.count; ++c) to[c] = target.varyings[c].data();
  for (uint32_t y = area.top; y < area.bottom; ++y)
    for (uint32_t s = 0; s < target.samples(); ++s) {
      const size_t row = target.index(0, y, s);
      const uint32_t* HWY_RESTRICT numbers = target.primitive.data() + row;
      for (size_t x = area.left; x < area.right;) {
        const uint32_t number = numbers[x];
        const size_t end = EndOfRun(numbers, x + 1, area.right, number);
        if (number != 0) {
          TrianglePlanes& planes = cache.of(number);
          if (planes.number != number) SetUpPlanes(triangles, number, components, planes);
          ShadeRun(planes, components, to, y, row, x, end);
        }
        x = end;
      }
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace rasterdiff::rasterizer
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rasterdiff::rasterizer {

HWY_EXPORT(Shade);

namespace {

/// What of the rows the triangles can have drawn.
ShadedArea shadedArea(const ValueTriangles& triangles, const ValueTarget& target, uint32_t firstRow, uint32_t endRow) {
  int32_t left = INT32_MAX, right = INT32_MIN, top = INT32_MAX, bottom = INT32_MIN;
  for (const SnappedTriangle& t : triangles.positions)
    for (const SubpixelPosition p : t.v) {
      left = std::min(left, p.x), right = std::max(right, p.x);
      top = std::min(top, p.y), bottom = std::max(bottom, p.y);
    }
  const auto pixel = [](int32_t position, uint32_t low, uint32_t high) {
    return static_cast<uint32_t>(std::clamp<int64_t>(position >> kSubpixelBits, low, high));
  };
  if (left > right) return {};
  return {pixel(left, 0, target.width()), pixel(top, firstRow, endRow), pixel(right, 0, target.width() - 1) + 1,
          std::min(endRow, pixel(bottom, firstRow, endRow) + 1)};
}

}  // namespace

void shadeRows(const ValueTriangles& triangles, ValueTarget& target, uint32_t firstRow, uint32_t endRow) {
  HWY_DYNAMIC_DISPATCH(Shade)(triangles, target, shadedArea(triangles, target, firstRow, endRow));
}

}  // namespace rasterdiff::rasterizer
#endif
