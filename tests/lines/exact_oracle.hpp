// Lines by the specification's own words, in exact rationals and by brute force: shares no formula with the product.
// Ties go where the sample goes when it is moved right by ε and down by ε², which is what top-left ownership means.
#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <vector>

#include "scene/spaces.hpp"

namespace rasterdiff::rasterizer::testing {

using Rational = boost::multiprecision::cpp_rational;

struct RationalPoint {
  Rational x, y;
};

/// An ε that no comparison of the tests can miss: coordinates are integers below 2^20.
inline Rational tiny() { return Rational(1, boost::multiprecision::cpp_int(1) << 120); }

inline RationalPoint moved(SubpixelPosition sample) {
  const Rational e = tiny();
  return {sample.x + e, sample.y + e * e};
}

/// Within half the width of the segment, and projected between its ends. [vk:primsrast-lines-basic]
inline bool inRectangle(SubpixelPosition a, SubpixelPosition b, int64_t width, const RationalPoint& p) {
  const Rational dx = b.x - a.x, dy = b.y - a.y, x = p.x - a.x, y = p.y - a.y;
  const Rational t = (x * dx + y * dy) / (dx * dx + dy * dy);
  const Rational footX = t * dx - x, footY = t * dy - y;  // Pythagoras instead of a cross product
  return t > 0 && t < 1 && 4 * (footX * footX + footY * footY) < Rational(width) * width;
}

/// Between the ends along the major axis, within half the width of the segment along the minor one.
inline bool inParallelogram(SubpixelPosition a, SubpixelPosition b, int64_t width, const RationalPoint& p) {
  const int64_t dx = b.x - a.x, dy = b.y - a.y;
  const bool xMajor = std::abs(dx) >= std::abs(dy);
  const Rational t = xMajor ? (p.x - a.x) / dx : (p.y - a.y) / dy;
  const Rational aside = xMajor ? p.y - (a.y + t * dy) : p.x - (a.x + t * dx);
  return t > 0 && t < 1 && 2 * aside < width && 2 * aside > -width;
}

/// Is the pixel a fragment of a thin line? The ends are moved by -(ε, ε²); the segment must meet the open diamond and
/// its end must not be in it. [vk:primsrast-lines-bresenham]
inline bool isFragment(SubpixelPosition a, SubpixelPosition b, int32_t pixelX, int32_t pixelY) {
  const Rational e = tiny();
  const RationalPoint from{a.x - e, a.y - e * e}, to{b.x - e, b.y - e * e};
  const Rational cx = pixelX * 256 + 128, cy = pixelY * 256 + 128;
  const auto distance = [&](const Rational& t) {
    return Rational(abs(from.x + t * (to.x - from.x) - cx) + abs(from.y + t * (to.y - from.y) - cy));
  };
  if (distance(1) < 128) return false;
  if (distance(0) < 128) return true;
  // The distance is convex and linear between the places where the line is level with the centre.
  for (const auto& [start, end, centre] : {std::tuple{from.x, to.x, cx}, std::tuple{from.y, to.y, cy}}) {
    if (start == end) continue;
    const Rational t = (centre - start) / (end - start);
    if (t > 0 && t < 1 && distance(t) < 128) return true;
  }
  return false;
}

}  // namespace rasterdiff::rasterizer::testing
