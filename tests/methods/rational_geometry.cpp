#include "tests/methods/rational_geometry.hpp"

#include <functional>

namespace rasterdiff::testing {

int rationalWinding(const Polygon& polygon, SubpixelPosition sample) {
  const Rational epsilon(1, 1ll << 40);
  const Rational x = sample.x + epsilon, y = sample.y + epsilon * epsilon;
  int winding = 0;
  for (size_t i = 0; i < polygon.vertices.size(); ++i) {
    const SubpixelPosition a = polygon.vertices[i], b = polygon.vertices[(i + 1) % polygon.vertices.size()];
    if ((a.x < x) == (b.x < x)) continue;
    const Rational crossing = a.y + (x - a.x) * Rational(b.y - a.y) / Rational(b.x - a.x);
    if (crossing > y) winding += b.x < a.x ? 1 : -1;  // below the sample a clockwise contour runs to the left
  }
  return winding;
}

namespace {

struct RationalPoint {
  Rational x, y;
};

/// Keeps what `inside` (linear) says is ≥ 0.
std::vector<RationalPoint> clip(const std::vector<RationalPoint>& polygon,
                                const std::function<Rational(const RationalPoint&)>& inside) {
  std::vector<RationalPoint> kept;
  for (size_t i = 0; i < polygon.size(); ++i) {
    const RationalPoint &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const Rational da = inside(a), db = inside(b);
    if (da >= 0) kept.push_back(a);
    if ((da > 0 && db < 0) || (da < 0 && db > 0)) {
      const Rational t = da / (da - db);
      kept.push_back({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)});
    }
  }
  return kept;
}

/// c0 + c1 ε + c2 ε², compared for small ε > 0.
using Series = std::array<Rational, 3>;

Series operator+(const Series& l, const Series& r) { return {l[0] + r[0], l[1] + r[1], l[2] + r[2]}; }
Series operator-(const Series& l, const Series& r) { return {l[0] - r[0], l[1] - r[1], l[2] - r[2]}; }
Series operator*(const Rational& k, const Series& s) { return {k * s[0], k * s[1], k * s[2]}; }

const Series kZero = {0, 0, 0}, kOne = {1, 0, 0};

/// constant + rate · t, strictly positive or zero.
struct Condition {
  Series constant;
  Rational rate;
  bool equality = false;
};

/// Is there a t in [0, 1] that satisfies all conditions?
bool satisfiable(const std::vector<Condition>& conditions) {
  struct Bound {
    Series at;
    bool strict;
  };
  std::vector<Bound> lower = {{kZero, false}}, upper = {{kOne, false}};
  for (const Condition& c : conditions) {
    if (c.rate == 0) {
      if (c.equality ? c.constant != kZero : c.constant <= kZero) return false;
      continue;
    }
    const Series at = Rational(-1) / c.rate * c.constant;
    if (c.equality || c.rate > 0) lower.push_back({at, !c.equality});
    if (c.equality || c.rate < 0) upper.push_back({at, !c.equality});
  }
  for (const Bound& l : lower) {
    for (const Bound& u : upper) {
      if (l.at > u.at || (l.at == u.at && (l.strict || u.strict))) return false;
    }
  }
  return true;
}

/// A moving point relative to a pixel centre: position(t) = from + t (dx, dy), in pixels.
struct Moving {
  Series x, y;
  Rational dx, dy;
};

/// side · coordinates compared with ½: ½ - sx x - sy y.
Condition edgeOf(const Moving& m, int sx, int sy, bool equality) {
  const Series half = {Rational(1, 2), 0, 0};
  return {half - (Rational(sx) * m.x + Rational(sy) * m.y), -(sx * m.dx + sy * m.dy), equality};
}

bool meetsOpenDiamond(const Moving& m) {
  return satisfiable(
      {edgeOf(m, 1, 1, false), edgeOf(m, 1, -1, false), edgeOf(m, -1, 1, false), edgeOf(m, -1, -1, false)});
}

/// The edge |x| + |y| = ½ in the quadrant (sx, sy), without its corners.
bool meetsOpenEdge(const Moving& m, int sx, int sy) {
  return satisfiable({edgeOf(m, sx, sy, true), {Rational(sx) * m.x, sx * m.dx}, {Rational(sy) * m.y, sy * m.dy}});
}

bool meetsPoint(const Moving& m, const Rational& x, const Rational& y) {
  return satisfiable({{m.x - Series{x, 0, 0}, m.dx, true}, {m.y - Series{y, 0, 0}, m.dy, true}});
}

bool meetsDirect3DDiamond(const Moving& m, bool xMajor) {
  const Rational half(1, 2);
  return meetsOpenDiamond(m) || meetsOpenEdge(m, -1, 1) || meetsOpenEdge(m, 1, 1) || meetsPoint(m, 0, half) ||
         (!xMajor && meetsPoint(m, half, 0));
}

}  // namespace

Rational rationalDoubleArea(const rasterizer::SnappedTriangle& triangle, rasterizer::PixelIndex pixel) {
  std::vector<RationalPoint> polygon;
  for (const SubpixelPosition& v : triangle.v) polygon.push_back({v.x, v.y});
  const Rational left = Rational(pixel.x) * 256, top = Rational(pixel.y) * 256;
  polygon = clip(polygon, [&](const RationalPoint& p) { return Rational(p.x - left); });
  polygon = clip(polygon, [&](const RationalPoint& p) { return Rational(left + 256 - p.x); });
  polygon = clip(polygon, [&](const RationalPoint& p) { return Rational(p.y - top); });
  polygon = clip(polygon, [&](const RationalPoint& p) { return Rational(top + 256 - p.y); });
  Rational area = 0;
  for (size_t i = 0; i < polygon.size(); ++i) {
    const RationalPoint &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    area += a.x * b.y - b.x * a.y;
  }
  return area < 0 ? Rational(-area) : area;
}

bool producesPixel(SubpixelPosition a, SubpixelPosition b, rasterizer::PixelIndex pixel, rasterizer::DiamondRule rule) {
  const bool vulkan = rule == rasterizer::DiamondRule::Vulkan;
  const Rational cx = pixel.x + Rational(1, 2), cy = pixel.y + Rational(1, 2);
  const Series movedX = vulkan ? Series{0, -1, 0} : kZero, movedY = vulkan ? Series{0, 0, -1} : kZero;
  const auto relative = [&](SubpixelPosition p, const Rational& dx, const Rational& dy) {
    return Moving{movedX + Series{Rational(p.x, 256) - cx, 0, 0}, movedY + Series{Rational(p.y, 256) - cy, 0, 0}, dx,
                  dy};
  };
  const Rational dx = Rational(b.x, 256) - Rational(a.x, 256), dy = Rational(b.y, 256) - Rational(a.y, 256);
  const Moving segment = relative(a, dx, dy), end = relative(b, 0, 0);
  if (vulkan) return meetsOpenDiamond(segment) && !meetsOpenDiamond(end);
  const bool xMajor = abs(dx) >= abs(dy);
  return meetsDirect3DDiamond(segment, xMajor) && !meetsDirect3DDiamond(end, xMajor);
}

}  // namespace rasterdiff::testing
