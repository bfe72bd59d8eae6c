// Deferred varyings: runs of pixels of one primitive; the planes of all components side by side in a vector, then the
// pixels of the run. Bound and arithmetic: value_setup-inl.h, the chunk being the whole way from the anchor.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rasterizer/kernels/value_shading.cpp"
#define HWY_DISABLED_TARGETS HWY_SSSE3
#include "hwy/foreach_target.h"
// After foreach_target.h:
#include <algorithm>
#include <cstring>

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
inline constexpr size_t kMostPlanes = kMaxValueComponents + 8;  // a vector may reach beyond the last

/// Planes of one triangle's components at a row: value = row + gx (x - x0).
struct RowPlanes {
  alignas(64) double row[kMostPlanes], gx[kMostPlanes];
  double rowW = 0, gxW = 0;  // of 1 / w
  double x0 = 0;             // of vertex 0, pixels
};

/// The components' kinds as factors: gradients of flat ones are zero.
struct Components {
  size_t count = 0;
  bool perspective[kMaxValueComponents] = {};
  bool anyPerspective = false;
  alignas(64) double sloped[kMostPlanes] = {};    // 0 for flat
  alignas(64) double weighted[kMostPlanes] = {};  // 1 for perspective: the value times 1 / w
};

HWY_INLINE Components ComponentsOf(const ValueTriangles& triangles) {
  Components c;
  c.count = triangles.kinds.size();
  for (size_t i = 0; i < c.count; ++i) {
    c.perspective[i] = triangles.kinds[i] == ValueKind::Perspective;
    c.anyPerspective |= c.perspective[i];
    c.sloped[i] = triangles.kinds[i] == ValueKind::Flat ? 0 : 1;
    c.weighted[i] = c.perspective[i] ? 1 : 0;
  }
  return c;
}

/// `y`: of the pixel centres.
HWY_INLINE void SetUpRow(const ValueTriangles& triangles, size_t t, double y, const Components& components, RowPlanes& planes) {
  const ShadeD d;
  const ShadeF df;
  const auto& v = triangles.positions[t].v;
  const double ax = v[0].x, ay = v[0].y;
  const double e1x = v[1].x - ax, e1y = v[1].y - ay, e2x = v[2].x - ax, e2y = v[2].y - ay;
  const double q = kSubpixelOne / (e1x * e2y - e1y * e2x), dy = y - ay / kSubpixelOne;
  planes.x0 = ax / kSubpixelOne;
  double w[3] = {1, 1, 1};
  if (components.anyPerspective) {
    for (size_t k = 0; k < 3; ++k) w[k] = triangles.reciprocalW[3 * t + k];
    const double d1 = w[1] - w[0], d2 = w[2] - w[0];
    planes.gxW = (d1 * e2y - d2 * e1y) * q;
    planes.rowW = w[0] + (d2 * e1x - d1 * e2x) * q * dy;
  }
  const size_t n = components.count;
  const float* values = triangles.values.data() + 3 * n * t;
  float copy[3 * kMaxValueComponents + 8];
  if (HWY_UNLIKELY(3 * n * (t + 1) + kShadeLanes > triangles.values.size())) {  // vectors would reach beyond the end
    std::copy_n(values, 3 * n, copy);
    values = copy;
  }
  for (size_t c = 0; c < n; c += kShadeLanes) {
    const ShadeV weighted = hn::Load(d, components.weighted + c), sloped = hn::Load(d, components.sloped + c);
    ShadeV a[3];
    for (size_t k = 0; k < 3; ++k) {
      // 1, or 1 / w: sums of a number and zero.
      const ShadeV factor = weighted * hn::Set(d, w[k]) + (hn::Set(d, 1.0) - weighted);
      a[k] = hn::PromoteTo(d, hn::LoadU(df, values + k * n + c)) * factor;
    }
    const ShadeV d1 = (a[1] - a[0]) * sloped, d2 = (a[2] - a[0]) * sloped, vq = hn::Set(d, q);
    const ShadeV gy = (d2 * hn::Set(d, e1x) - d1 * hn::Set(d, e2x)) * vq;
    hn::Store((d1 * hn::Set(d, e2y) - d2 * hn::Set(d, e1y)) * vq, d, planes.gx + c);
    hn::Store(a[0] + gy * hn::Set(d, dy), d, planes.row + c);
  }
}

/// Pixels [x, end) of a row that starts at element `row` of the planes.
HWY_INLINE void ShadeRun(const RowPlanes& planes, const Components& components, ValueTarget& target, size_t row, size_t x, size_t end) {
  const ShadeD d;
  const ShadeF df;
  for (; x < end; x += kShadeLanes) {
    const auto mask = hn::FirstN(df, end - x);
    const ShadeV dx = hn::Set(d, static_cast<double>(x) + 0.5 - planes.x0) + hn::Iota(d, 0);
    ShadeV w = hn::Set(d, 1.0);
    if (components.anyPerspective) w = w / (hn::Set(d, planes.rowW) + hn::Set(d, planes.gxW) * dx);
    for (size_t c = 0; c < components.count; ++c) {
      ShadeV value = hn::Set(d, planes.row[c]) + hn::Set(d, planes.gx[c]) * dx;
      if (components.perspective[c]) value = value * w;
      hn::BlendedStore(hn::DemoteTo(df, value), mask, df, target.varyings[c].data() + row + x);
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

void Shade(const ValueTriangles& triangles, ValueTarget& target, uint32_t firstRow, uint32_t endRow) {
  const Components components = ComponentsOf(triangles);
  RowPlanes planes;
  for (uint32_t y = firstRow; y < endRow; ++y)
    for (uint32_t s = 0; s < target.samples(); ++s) {
      const size_t row = target.index(0, y, s);
      const uint32_t* HWY_RESTRICT numbers = target.primitive.data() + row;
      for (size_t x = 0; x < target.width();) {
        const uint32_t number = numbers[x];
        const size_t end = EndOfRun(numbers, x + 1, target.width(), number);
        if (number != 0) {
          SetUpRow(triangles, number - 1, y + 0.5, components, planes);
          ShadeRun(planes, components, target, row, x, end);
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

void shadeRows(const ValueTriangles& triangles, ValueTarget& target, uint32_t firstRow, uint32_t endRow) {
  HWY_DYNAMIC_DISPATCH(Shade)(triangles, target, firstRow, endRow);
}

}  // namespace rasterdiff::rasterizer
#endif
