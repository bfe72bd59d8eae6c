// Triangles one at a time: beyond the fast range, and for the bounds.
#include <algorithm>
#include <cmath>
#include <limits>

#include "rasterizer/kernels/integer_spans.hpp"
#include "rasterizer/kernels/value_kernel.hpp"
#include "rasterizer/kernels/value_view.hpp"

namespace rasterdiff::rasterizer {
namespace {

__extension__ using Wide = __int128;  // differences < 2^33, products < 2^66

struct Edges {
  double x1, y1, x2, y2, determinant;

  explicit Edges(const SnappedTriangle& t) {
    const Wide e1x = Wide{t.v[1].x} - t.v[0].x, e1y = Wide{t.v[1].y} - t.v[0].y;
    const Wide e2x = Wide{t.v[2].x} - t.v[0].x, e2y = Wide{t.v[2].y} - t.v[0].y;
    x1 = static_cast<double>(e1x), y1 = static_cast<double>(e1y), x2 = static_cast<double>(e2x), y2 = static_cast<double>(e2y);
    determinant = static_cast<double>(e1x * e2y - e1y * e2x);
  }
};

double pixels(int32_t subpixels) { return static_cast<double>(subpixels) / kSubpixelOne; }

constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace

LinearPlane linearPlane(const SnappedTriangle& triangle, const std::array<double, 3>& values) {
  const Edges e(triangle);
  const double d1 = values[1] - values[0], d2 = values[2] - values[0], q = kSubpixelOne / e.determinant;
  return {values[0], (d1 * e.y2 - d2 * e.y1) * q, (d2 * e.x1 - d1 * e.x2) * q, pixels(triangle.v[0].x), pixels(triangle.v[0].y)};
}

LinearPlane linearPlane(const DepthCorners& c) {
  const double e1x = c.x[1] - c.x[0], e1y = c.y[1] - c.y[0], e2x = c.x[2] - c.x[0], e2y = c.y[2] - c.y[0];
  const double d1 = c.z[1] - c.z[0], d2 = c.z[2] - c.z[0], determinant = e1x * e2y - e1y * e2x;
  if (determinant == 0) return {c.z[0], 0, 0, c.x[0], c.y[0]};
  return {c.z[0], (d1 * e2y - d2 * e1y) / determinant, (d2 * e1x - d1 * e2x) / determinant, c.x[0], c.y[0]};
}

void drawFarTriangle(const ValueTriangles& triangles, size_t place, const ValueView& view) {
  const SnappedTriangle& t = triangles.positions[place];
  const bool ownCorners = !triangles.corners.empty();
  LinearPlane z;
  if (ownCorners) {
    z = linearPlane(triangles.corners[place]);
  } else if (view.depth != nullptr) {
    z = linearPlane(t, {triangles.depth[3 * place], triangles.depth[3 * place + 1], triangles.depth[3 * place + 2]});
  }
  const auto [top, bottom] = std::minmax({t.v[0].y, t.v[1].y, t.v[2].y});
  const int64_t first = std::max<int64_t>(static_cast<int64_t>(view.firstRow), top >> kSubpixelBits);
  const int64_t last = std::min<int64_t>(static_cast<int64_t>(view.endRow) - 1, bottom >> kSubpixelBits);
  for (int64_t y = first; y <= last; ++y)
    for (size_t s = 0; s < view.samples; ++s) {
      const SampleLocation at{static_cast<uint8_t>(view.x[s] / kSampleUnit), static_cast<uint8_t>(view.y[s] / kSampleUnit)};
      const IntegerSpan span = integerSpan(t, y, at, static_cast<int64_t>(view.width));
      const size_t row = (static_cast<size_t>(y) * view.samples + s) * view.stride;
      const double rise = z.gy * (static_cast<double>(y) + view.y[s] / kSubpixelOne - z.y0), rowDepth = z.a0 + rise;
      for (int64_t x = span.begin; x < span.end; ++x) {
        const size_t i = row + static_cast<size_t>(x);
        if (view.depth != nullptr) {
          const double alongX = z.gx * (static_cast<double>(x) + view.x[s] / kSubpixelOne - z.x0);
          const auto depth = ownCorners ? static_cast<float>((z.a0 + alongX) + rise) : static_cast<float>(rowDepth + alongX) + 0.0F;  // no -0
          if (view.met != nullptr && depth == view.depth[i] && view.primitive[i] != 0) ++*view.met;
          const bool isFirst = view.reordered && view.primitive != nullptr && depth == view.depth[i] && place + 1 < view.primitive[i];
          if (!(depth < view.depth[i] || isFirst)) continue;
          view.depth[i] = depth;
        }
        if (view.primitive != nullptr) view.primitive[i] = view.before + static_cast<uint32_t>(place + 1);
        if (view.count != nullptr) ++view.count[i];
      }
    }
}

double linearValueBound(const SnappedTriangle& triangle, SubpixelPosition p, const std::array<double, 3>& values) {
  const Edges e(triangle);
  if (e.determinant == 0) return kInfinity;
  const double d1 = std::fabs(values[1] - values[0]), d2 = std::fabs(values[2] - values[0]), area = std::fabs(e.determinant);
  const double x = (std::fabs(pixels(p.x) - pixels(triangle.v[0].x)) + 14) * kSubpixelOne;
  const double y = std::fabs(pixels(p.y) - pixels(triangle.v[0].y)) * kSubpixelOne;
  const double alongX = (d1 * std::fabs(e.y2) + d2 * std::fabs(e.y1)) / area * x;
  const double alongY = (d2 * std::fabs(e.x1) + d1 * std::fabs(e.x2)) / area * y;
  return 0x1p-49 * (std::fabs(values[0]) + alongX + alongY);
}

std::array<double, 3> edgeFunctions(const SnappedTriangle& triangle, SubpixelPosition p) {
  std::array<double, 3> b{};
  for (size_t i = 0; i < 3; ++i) {
    const SubpixelPosition v = triangle.v[(i + 1) % 3], w = triangle.v[(i + 2) % 3];
    b[i] = static_cast<double>((Wide{v.x} - p.x) * (Wide{w.y} - p.y) - (Wide{w.x} - p.x) * (Wide{v.y} - p.y));
  }
  return b;
}

double varyingBound(const SnappedTriangle& triangle, SubpixelPosition p, const std::array<float, 3>& values,
                    const std::array<float, 3>& reciprocalW) {
  const std::array<double, 3> b = edgeFunctions(triangle, p);
  const double area = std::fabs(Edges(triangle).determinant);
  double denominator = 0, here = 0, hereValues = 0, first = 0, firstValues = 0;  // of weights' magnitudes: sums at `p` and at the run's first pixel
  for (size_t i = 0; i < 3; ++i) {
    const SubpixelPosition v = triangle.v[(i + 1) % 3], w = triangle.v[(i + 2) % 3];
    const double length = std::fabs(double{1} * w.x - v.x) + std::fabs(double{1} * w.y - v.y);
    const double weight = b[i] * reciprocalW[i], most = (area + kSubpixelOne / 2 * length) * reciprocalW[i];
    denominator += weight;
    here += std::fabs(weight), hereValues += std::fabs(weight * values[i]);
    first += most, firstValues += most * std::fabs(values[i]);
  }
  denominator = std::fabs(denominator);
  const double relative = (6 * first + 4 * here) / denominator;  // error of the denominator
  if (!(relative < 0x1p40)) return kInfinity;
  return 0x1p-53 * (1 + 0x1p-8) * (8 * firstValues + 5 * hereValues + hereValues * (relative + 2)) / denominator;
}

}  // namespace rasterdiff::rasterizer
