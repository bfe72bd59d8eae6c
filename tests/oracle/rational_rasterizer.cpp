#include "rational_rasterizer.hpp"

#include <array>

namespace rasterdiff::oracle {
namespace {

using Integer = boost::multiprecision::cpp_int;

Integer floorOf(const Rational& value) {
  const Integer n = boost::multiprecision::numerator(value), d = boost::multiprecision::denominator(value);
  Integer quotient = n / d;
  if (n % d != 0 && n < 0) --quotient;
  return quotient;
}

Rational nearestEven(const Rational& value, int bits) {
  const Rational scaled = value * (Integer(1) << bits);
  const Integer below = floorOf(scaled);
  const Rational fraction = scaled - below;
  const Rational half(1, 2);
  const bool up = fraction > half || (fraction == half && below % 2 != 0);
  return Rational(below + (up ? 1 : 0)) / (Integer(1) << bits);
}

struct Point {
  Rational x, y;
};

Point project(const ClipPosition& p, const Viewport& v, int bits) {
  const Rational w(p.w);
  const auto axis = [&](float coordinate, float origin, float size) {
    return nearestEven(Rational(coordinate) / w * Rational(size) / 2 + Rational(origin) + Rational(size) / 2, bits);
  };
  return {axis(p.x, v.x, v.width), axis(p.y, v.y, v.height)};
}

int sign(const Rational& value) { return value > 0 ? 1 : value < 0 ? -1 : 0; }

// Side of the line a→b on which p + (ε, ε²) lies: never 0 for a ≠ b.
int side(const Point& a, const Point& b, const Point& p, bool& tie) {
  const Rational dx = b.x - a.x, dy = b.y - a.y;
  const int plain = sign(dx * (p.y - a.y) - dy * (p.x - a.x));
  if (plain != 0) return plain;
  tie = true;
  return dy != 0 ? -sign(dy) : sign(dx);
}

constexpr std::array<std::array<int, 2>, 1> kOne{{{8, 8}}};
constexpr std::array<std::array<int, 2>, 4> kFour{{{6, 2}, {14, 6}, {2, 10}, {10, 14}}};

}  // namespace

Masks rasterize(const Scene& scene, int bits, Counts& counts) {
  const uint32_t width = scene.target.width, height = scene.target.height, samples = scene.target.samples;
  Masks masks;
  masks.winner.resize(size_t{width} * height * samples);
  masks.count.resize(masks.winner.size());
  uint32_t primitive = 0;
  for (const Draw& draw : scene.draws) {
    for (size_t i = 0; i + 2 < draw.positions.size(); i += 3) {
      ++primitive;
      std::array<Point, 3> v;
      for (size_t k = 0; k < 3; ++k) v[k] = project(draw.positions[i + k], scene.viewport, bits);
      const int orientation = sign((v[1].x - v[0].x) * (v[2].y - v[0].y) - (v[1].y - v[0].y) * (v[2].x - v[0].x));
      if (orientation == 0) continue;
      const auto bound = [&](auto pick, bool low) {
        Rational value = pick(v[0]);
        for (const Point& p : v) {
          if (low ? pick(p) < value : pick(p) > value) value = pick(p);
        }
        return floorOf(value).convert_to<int64_t>();
      };
      const auto x = [](const Point& p) { return p.x; };
      const auto y = [](const Point& p) { return p.y; };
      const int64_t x0 = std::max<int64_t>(bound(x, true), 0), x1 = std::min<int64_t>(bound(x, false), int64_t{width} - 1);
      const int64_t y0 = std::max<int64_t>(bound(y, true), 0), y1 = std::min<int64_t>(bound(y, false), int64_t{height} - 1);
      for (int64_t py = y0; py <= y1; ++py) {
        for (int64_t px = x0; px <= x1; ++px) {
          for (uint32_t s = 0; s < samples; ++s) {
            const auto& location = samples == 1 ? kOne[0] : kFour[s];
            const Point p{Rational(px) + Rational(location[0], 16), Rational(py) + Rational(location[1], 16)};
            bool tie = false, inside = true;
            for (size_t k = 0; k < 3 && inside; ++k) inside = side(v[k], v[(k + 1) % 3], p, tie) == orientation;
            ++counts.samplesTested;
            if (tie) ++counts.ties;
            if (!inside) continue;
            const size_t index = (static_cast<size_t>(py) * width + static_cast<size_t>(px)) * samples + s;
            masks.winner[index] = primitive;
            ++masks.count[index];
          }
        }
      }
    }
  }
  return masks;
}

}  // namespace rasterdiff::oracle
