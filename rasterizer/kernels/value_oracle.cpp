// Nothing here is tuned; everything faster is compared with it.
#include "rasterizer/kernels/value_oracle.hpp"

#include <algorithm>

#include "rasterizer/kernels/coverage_oracle.hpp"

namespace rasterdiff::rasterizer {
namespace {

__extension__ using Quad = __float128;  // 113 bits
__extension__ using Wide = __int128;

/// Twice the signed area.  // Q23.8: differences < 2^33, products < 2^66
Wide cross(SubpixelPosition a, SubpixelPosition b, SubpixelPosition c) {
  return (Wide{b.x} - a.x) * (Wide{c.y} - a.y) - (Wide{b.y} - a.y) * (Wide{c.x} - a.x);
}

/// Barycentric coordinates of p times twice the area.
std::array<Quad, 3> weights(const SnappedTriangle& t, SubpixelPosition p) {
  const auto& [a, b, c] = t.v;
  return {static_cast<Quad>(cross(p, b, c)), static_cast<Quad>(cross(a, p, c)), static_cast<Quad>(cross(a, b, p))};
}

std::array<float, 3> valuesOf(const ValueTriangles& triangles, size_t t, size_t component) {
  const size_t components = triangles.kinds.size();
  const auto carried = triangles.carried.subspan(t * carriedSize(components) + kBeforeValues);
  return {carried[component], carried[components + component], carried[2 * components + component]};
}

std::array<float, 3> threeOf(std::span<const float> all, size_t first) { return {all[first], all[first + 1], all[first + 2]}; }

float varyingAt(const ValueTriangles& triangles, size_t t, size_t component, SubpixelPosition p) {
  const std::array<float, 3> v = valuesOf(triangles, t, component);
  switch (triangles.kinds[component]) {
    case ValueKind::Flat: return v[0];
    case ValueKind::Noperspective: return static_cast<float>(exactValue(triangles.positions[t], p, v));
    case ValueKind::Perspective: break;
  }
  return static_cast<float>(exactPerspectiveValue(triangles.positions[t], p, v, threeOf(triangles.carried, carriedSize(triangles.kinds.size()) * t)));
}

void drawSample(const ValueTriangles& triangles, size_t t, uint32_t x, uint32_t y, uint32_t s, ValueTarget& target) {
  const SampleLocation at = target.locations()[s];
  const SubpixelPosition corner{static_cast<int32_t>(x) * kSubpixelOne, static_cast<int32_t>(y) * kSubpixelOne};
  const SubpixelPosition p{corner.x + at.x * kSampleUnit, corner.y + at.y * kSampleUnit};
  const SnappedTriangle& triangle = triangles.positions[t];
  if (!covers(triangle, p)) return;
  const size_t i = target.index(x, y, s);
  if (target.needs().depth) {
    const auto depth = static_cast<float>(exactValue(triangle, p, threeOf(triangles.depth, 3 * t)));
    if (!(depth < target.depth[i])) return;  // LESS
    target.depth[i] = depth;
  }
  if (target.needs().primitive) target.primitive[i] = static_cast<uint32_t>(t + 1);
  if (target.needs().count) ++target.count[i];
  const SubpixelPosition centre{corner.x + kSubpixelOne / 2, corner.y + kSubpixelOne / 2};
  for (size_t c = 0; c < target.varyings.size(); ++c) target.varyings[c][i] = varyingAt(triangles, t, c, centre);
}

}  // namespace

double exactValue(const SnappedTriangle& triangle, SubpixelPosition p, const std::array<float, 3>& vertexValues) {
  const std::array<Quad, 3> b = weights(triangle, p);
  const Quad sum = b[0] * vertexValues[0] + b[1] * vertexValues[1] + b[2] * vertexValues[2];
  return static_cast<double>(sum / static_cast<Quad>(cross(triangle.v[0], triangle.v[1], triangle.v[2])));
}

double exactPerspectiveValue(const SnappedTriangle& triangle, SubpixelPosition p, const std::array<float, 3>& vertexValues,
                             const std::array<float, 3>& reciprocalW) {
  const std::array<Quad, 3> b = weights(triangle, p);
  Quad numerator = 0, denominator = 0;
  for (size_t i = 0; i < 3; ++i) {
    numerator += b[i] * (static_cast<Quad>(vertexValues[i]) * reciprocalW[i]);
    denominator += b[i] * reciprocalW[i];
  }
  return static_cast<double>(numerator / denominator);
}

void drawValuesOracle(const ValueTriangles& triangles, ValueTarget& target) {
  for (size_t t = 0; t < triangles.positions.size(); ++t) {
    const auto& v = triangles.positions[t].v;
    const auto [x0, x1] = std::minmax({v[0].x, v[1].x, v[2].x});
    const auto [y0, y1] = std::minmax({v[0].y, v[1].y, v[2].y});
    const int32_t lastX = std::min(static_cast<int32_t>(target.width()) - 1, x1 >> kSubpixelBits);
    const int32_t lastY = std::min(static_cast<int32_t>(target.height()) - 1, y1 >> kSubpixelBits);
    for (int32_t y = std::max(0, y0 >> kSubpixelBits); y <= lastY; ++y)
      for (int32_t x = std::max(0, x0 >> kSubpixelBits); x <= lastX; ++x)
        for (uint32_t s = 0; s < target.samples(); ++s)
          drawSample(triangles, t, static_cast<uint32_t>(x), static_cast<uint32_t>(y), s, target);
  }
}

}  // namespace rasterdiff::rasterizer
