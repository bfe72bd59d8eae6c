// The box of places where one end of a line may legally be, and exact ranges of the products that decide coverage.
#pragma once

#include <algorithm>

#include "rasterizer/geometry.hpp"
#include "rasterizer/lines/wide_integer.hpp"

namespace rasterdiff::rasterizer {

/// Closed range of integers.
struct Range {
  int64_t low = 0, high = 0;
  [[nodiscard]] bool fixed() const { return low == high; }
  [[nodiscard]] bool contains(int64_t value) const { return value >= low && value <= high; }
};

[[nodiscard]] constexpr Range operator+(Range a, Range b) { return {a.low + b.low, a.high + b.high}; }
[[nodiscard]] constexpr Range operator-(Range a, Range b) { return {a.low - b.high, a.high - b.low}; }

/// Smallest and largest magnitude in a range.
[[nodiscard]] constexpr Range magnitudes(Range r) {
  if (r.low >= 0) return r;
  if (r.high <= 0) return {-r.high, -r.low};
  return {0, std::max(-r.low, r.high)};
}

struct EndBox {
  Range x, y;  ///< 1/256 pixel
  bool made = false;

  EndBox() = default;
  explicit EndBox(const RasterVertex& v) : x{v.lowest.x, v.highest.x}, y{v.lowest.y, v.highest.y}, made(v.made) {}
  [[nodiscard]] bool fixed() const { return x.fixed() && y.fixed(); }
  /// Sum of its sides: no two places are farther apart.
  [[nodiscard]] int64_t size() const { return (x.high - x.low) + (y.high - y.low); }
  friend bool operator==(const EndBox& a, const EndBox& b) {
    return a.x.low == b.x.low && a.x.high == b.x.high && a.y.low == b.y.low && a.y.high == b.y.high;
  }
};

/// (p - a)(b - a) over a and b, as real numbers: linear in b, convex in a, so that only a minimum can lie inside.
[[nodiscard]] inline Range alongOneAxis(int64_t p, Range a, Range b) {
  Range result{INT64_MAX, INT64_MIN};
  for (const int64_t end : {b.low, b.high}) {
    for (const int64_t start : {a.low, a.high}) {
      const int64_t value = (p - start) * (end - start);
      result = {std::min(result.low, value), std::max(result.high, value)};
    }
    const int64_t vertex2 = p + end;  // twice the a of the minimum
    if (vertex2 > 2 * a.low && vertex2 < 2 * a.high) {
      result.low = std::min(result.low, -(((p - end) * (p - end) + 3) / 4));
    }
  }
  return result;
}

/// (p - a) · (b - a) // 1/65536 pixel², ≤ 2^60
[[nodiscard]] inline Range alongRange(int64_t px, int64_t py, const EndBox& a, const EndBox& b) {
  return alongOneAxis(px, a.x, b.x) + alongOneAxis(py, a.y, b.y);
}

/// Calls visit(ax, ay, bx, by) for the corners of both boxes, where an expression that is linear in each of the four
/// has its extremes.
template <class Visit>
void forEachPlacement(const EndBox& a, const EndBox& b, const Visit& visit) {
  const auto forEachEnd = [](Range range, const auto& visitEnd) {
    visitEnd(range.low);
    if (!range.fixed()) visitEnd(range.high);
  };
  forEachEnd(a.x, [&](int64_t ax) {
    forEachEnd(a.y, [&](int64_t ay) {
      forEachEnd(b.x, [&](int64_t bx) { forEachEnd(b.y, [&](int64_t by) { visit(ax, ay, bx, by); }); });
    });
  });
}

/// (b - a) × (p - a) // 1/65536 pixel², ≤ 2^60
[[nodiscard]] inline Range crossRange(int64_t px, int64_t py, const EndBox& a, const EndBox& b) {
  Range result{INT64_MAX, INT64_MIN};
  forEachPlacement(a, b, [&](int64_t ax, int64_t ay, int64_t bx, int64_t by) {
    const int64_t value = (bx - ax) * (py - ay) - (by - ay) * (px - ax);
    result = {std::min(result.low, value), std::max(result.high, value)};
  });
  return result;
}

/// |b - a|² // 1/65536 pixel²
[[nodiscard]] inline Range squaredLength(const EndBox& a, const EndBox& b) {
  const Range x = magnitudes(b.x - a.x), y = magnitudes(b.y - a.y);
  return {x.low * x.low + y.low * y.low, x.high * x.high + y.high * y.high};
}

}  // namespace rasterdiff::rasterizer
