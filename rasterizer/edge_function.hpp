// Edge functions of snapped triangles in 64-bit integers, and who owns a sample that lies on an edge.
// (Pineda 1988; lecture "Edge Equations", whose constant term C has a sign error: C = x1·y0 - x0·y1 here.)
#pragma once

#include <cstdint>

#include "rasterizer/rules.hpp"
#include "scene/spaces.hpp"

namespace rasterdiff::rasterizer {

/// E(p) = (b - a) × (p - a), in 1/65536 pixel²; positive on the inner side of an edge of a positively oriented polygon
/// (positive: doubleArea > 0, clockwise to the eye since y points down).
/// // Q23.8 × Q23.8 → Q47.16; coordinates are within ±2^29, differences ±2^30, products ±2^60, the sum of two ±2^61.
struct EdgeFunction {
  int64_t dx = 0, dy = 0;  ///< b - a  // Q23.8
  int64_t ax = 0, ay = 0;
  bool ownsTies = false;

  [[nodiscard]] int64_t at(int64_t px, int64_t py) const { return dx * (py - ay) - dy * (px - ax); }
  [[nodiscard]] bool covers(int64_t px, int64_t py) const {
    const int64_t value = at(px, py);
    return value > 0 || (value == 0 && ownsTies);
  }
};

/// Who owns samples on level and on slanted edges.
struct TieRule {
  TieOwner owner = TieOwner::TopLeft;
  SlantedTies slanted = SlantedTies::LikeVertical;
  // NOLINTNEXTLINE(google-explicit-constructor): an owner alone is a rule.
  constexpr TieRule(TieOwner o, SlantedTies s = SlantedTies::LikeVertical) : owner(o), slanted(s) {}
};

[[nodiscard]] constexpr TieRule tieRule(const Choices& choices) { return {choices.tieOwner, choices.slantedTies}; }

/// Does an edge with this direction own its samples? Of the two polygons that share an edge with identical ends exactly
/// one sees it in the owning direction. // [vk:primsrast-polygons-basic] [choice:tie-owner] [choice:slanted-ties]
[[nodiscard]] constexpr bool ownsTies(TieRule rule, int64_t dx, int64_t dy) {
  const bool leftOwns = rule.owner == TieOwner::TopLeft || rule.owner == TieOwner::BottomLeft;
  const bool topOwns = rule.owner == TieOwner::TopLeft || rule.owner == TieOwner::TopRight;
  const bool left = dy < 0, top = dx > 0;  // the interior lies to the right of a left edge, below a top edge
  if (dy == 0) return dx != 0 && top == topOwns;
  if (dx == 0) return left == leftOwns;
  switch (rule.slanted) {
    case SlantedTies::LikeVertical: return left == leftOwns;
    case SlantedTies::AgainstVertical: return left != leftOwns;
    case SlantedTies::LikeHorizontal: return top == topOwns;
    case SlantedTies::AgainstHorizontal: return top != topOwns;
  }
  return false;
}

[[nodiscard]] inline EdgeFunction edgeFunction(SubpixelPosition a, SubpixelPosition b, TieRule rule) {
  EdgeFunction edge;
  edge.dx = int64_t{b.x} - a.x;
  edge.dy = int64_t{b.y} - a.y;
  edge.ax = a.x;
  edge.ay = a.y;
  edge.ownsTies = ownsTies(rule, edge.dx, edge.dy);
  return edge;
}

/// Twice the signed area, 1/65536 pixel². Vulkan's a = -doubleArea / 2 (its sum runs over framebuffer coordinates).
[[nodiscard]] inline int64_t doubleArea(SubpixelPosition a, SubpixelPosition b, SubpixelPosition c) {
  return (int64_t{b.x} - a.x) * (int64_t{c.y} - a.y) - (int64_t{b.y} - a.y) * (int64_t{c.x} - a.x);
}

}  // namespace rasterdiff::rasterizer
