#include "rasterizer/methods/method_inputs.hpp"

#include <algorithm>
#include <cmath>

#include "rasterizer/edge_function.hpp"

namespace rasterdiff::rasterizer {
namespace {

constexpr int32_t kHalfPixel = kSubpixelOne / 2;

SubpixelPosition randomPoint(Prng& prng, int32_t extentPixels, int32_t step) {
  const int32_t steps = extentPixels * kSubpixelOne / step;
  const int32_t x = prng.between(0, steps);
  return {x * step, prng.between(0, steps) * step};
}

SubpixelPosition offsetBy(SubpixelPosition p, int32_t dx, int32_t dy) { return {p.x + dx, p.y + dy}; }

/// Draws until the area is not zero.
template <class Make>
SnappedTriangle withArea(const Make& make) {
  SnappedTriangle triangle;
  do triangle = make();
  while (doubleArea(triangle.v[0], triangle.v[1], triangle.v[2]) == 0);
  return triangle;
}

}  // namespace

Polygon convexPolygon(Prng& prng) {
  while (true) {
    std::vector<SubpixelPosition> points;
    for (int i = 0; i < 9; ++i) points.push_back(randomPoint(prng, kInputExtent, 1));
    std::sort(points.begin(), points.end(), [](auto l, auto r) { return l.x != r.x ? l.x < r.x : l.y < r.y; });
    // Andrew's monotone chain: lower hull, then upper hull, strictly convex.
    std::vector<SubpixelPosition> hull;
    const auto extend = [&hull](SubpixelPosition p, size_t keep) {
      while (hull.size() > keep && doubleArea(hull[hull.size() - 2], hull.back(), p) <= 0) hull.pop_back();
      hull.push_back(p);
    };
    for (const SubpixelPosition p : points) extend(p, 1);
    const size_t lower = hull.size();
    for (size_t i = points.size() - 1; i-- > 0;) extend(points[i], lower);
    hull.pop_back();
    if (hull.size() >= 3) return {hull};
  }
}

Polygon concavePolygon(Prng& prng) {
  constexpr int32_t kCentre = kInputExtent / 2 * kSubpixelOne;
  constexpr SubpixelPosition kMiddle{kCentre, kCentre};
  // One or two points in each of eight sectors around the middle, in order of direction: no gap of half a turn, no
  // direction twice, so the contour is simple.
  Polygon polygon;
  for (int sector = 0; sector < 8; ++sector) {
    std::vector<SubpixelPosition> points;
    const int count = prng.between(1, 2);
    for (int i = 0; i < count; ++i) {
      const int32_t along = prng.between(2, kInputExtent - 1), across = prng.between(0, along - 1);  // half pixels
      // Odd sectors run their octant backwards: swapped axes with `across` measured from the diagonal.
      const int32_t u = sector % 2 == 0 ? along : along - across, v = sector % 2 == 0 ? across : along;
      const int32_t quarter = sector / 2;
      const int32_t x = quarter == 0 ? u : quarter == 1 ? -v : quarter == 2 ? -u : v;
      const int32_t y = quarter == 0 ? v : quarter == 1 ? u : quarter == 2 ? -v : -u;
      points.push_back(offsetBy(kMiddle, x * kHalfPixel, y * kHalfPixel));
    }
    if (points.size() == 2) {
      const int64_t turn = doubleArea(kMiddle, points[0], points[1]);
      if (turn < 0) std::swap(points[0], points[1]);
      if (turn == 0) points.pop_back();
    }
    polygon.vertices.insert(polygon.vertices.end(), points.begin(), points.end());
  }
  return polygon;
}

Polygon crossingPolygon(Prng& prng) {
  Polygon polygon;
  const int count = prng.between(5, 9);
  for (int i = 0; i < count; ++i) polygon.vertices.push_back(randomPoint(prng, kInputExtent, kHalfPixel));
  return polygon;
}

LineEnds centredLine(Prng& prng) {
  const SubpixelPosition a = randomPoint(prng, kInputExtent, kSubpixelOne);
  const SubpixelPosition b = randomPoint(prng, kInputExtent, kSubpixelOne);
  return {offsetBy(a, kHalfPixel, kHalfPixel), offsetBy(b, kHalfPixel, kHalfPixel)};
}

LineEnds hardLine(Prng& prng) {
  const int32_t step = prng.chance(50) ? 1 : kSubpixelOne / 4;
  const SubpixelPosition a = randomPoint(prng, kInputExtent, step);
  return {a, randomPoint(prng, kInputExtent, step)};
}

SnappedTriangle mediumTriangle(Prng& prng) {
  constexpr int32_t kSmallest = 8 * kSubpixelOne * 8 * kSubpixelOne;
  while (true) {
    SnappedTriangle t;
    for (SubpixelPosition& v : t.v) v = randomPoint(prng, 40, 1);
    if (std::abs(doubleArea(t.v[0], t.v[1], t.v[2])) >= kSmallest) return t;
  }
}

SnappedTriangle sliverTriangle(Prng& prng) {
  return withArea([&] {
    const SubpixelPosition a = randomPoint(prng, 40, 1), b = randomPoint(prng, 40, 1);
    const auto near = [&] { return prng.between(-kHalfPixel, kHalfPixel); };
    const int32_t dx = near();
    const SubpixelPosition middle{(a.x + b.x) / 2, (a.y + b.y) / 2};
    return SnappedTriangle{{a, b, offsetBy(middle, dx, near())}};
  });
}

SnappedTriangle farTriangle(Prng& prng) {
  SnappedTriangle t = mediumTriangle(prng);
  for (SubpixelPosition& v : t.v) v = offsetBy(v, 16000 * kSubpixelOne, 16000 * kSubpixelOne);
  return t;
}

SnappedTriangle tinyTriangle(Prng& prng) {
  return withArea([&] {
    const SubpixelPosition corner = randomPoint(prng, kInputExtent, 1);
    SnappedTriangle t;
    for (SubpixelPosition& v : t.v) {
      const int32_t dx = prng.between(0, 2 * kSubpixelOne);
      v = offsetBy(corner, dx, prng.between(0, 2 * kSubpixelOne));
    }
    return t;
  });
}

InterpolatedTriangle withValues(const SnappedTriangle& triangle, double ratio, Prng& prng) {
  InterpolatedTriangle result;
  result.position = triangle.v;
  for (size_t i = 0; i < 3; ++i) {
    result.value[i] = static_cast<float>(prng.between(0.25, 1.0));
    result.w[i] = static_cast<float>(std::pow(ratio, prng.unit()));
  }
  return result;
}

SubpixelPosition pointInside(const SnappedTriangle& triangle, Prng& prng) {
  const auto& [a, b, c] = triangle.v;
  const int64_t area = doubleArea(a, b, c), sign = area > 0 ? 1 : -1;
  for (int attempt = 0; attempt < 256; ++attempt) {
    double u = prng.unit(), v = prng.unit();
    if (u + v > 1) u = 1 - u, v = 1 - v;
    const SubpixelPosition p{a.x + static_cast<int32_t>(std::lround(u * (b.x - a.x) + v * (c.x - a.x))),
                             a.y + static_cast<int32_t>(std::lround(u * (b.y - a.y) + v * (c.y - a.y)))};
    if (doubleArea(a, b, p) * sign >= 0 && doubleArea(b, c, p) * sign >= 0 && doubleArea(c, a, p) * sign >= 0) return p;
  }
  return a;
}

}  // namespace rasterdiff::rasterizer
