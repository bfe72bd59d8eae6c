// The grammar of SVG's `points` attribute (SVG 2, "Basic shapes"): numbers in pairs. Elements are left to svg_polygon.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "scene/polygon/polygon.hpp"

namespace rasterdiff {

/// A point in SVG user units, y down.
struct SvgPoint {
  double x = 0, y = 0;
  friend bool operator==(const SvgPoint&, const SvgPoint&) = default;
};

/// What is wrong with a list of points; where the list stands is its owner's knowledge.
struct PointsMistake {
  size_t at = 0;  ///< bytes from the start of the list
  std::string what, hint;
};

/// `text` is the attribute's value: numbers separated by white space, one comma, or nothing where a sign or a second
/// dot starts the next number ("10-20", ".5.5"). An empty list is legal. A mistake: no number, an odd count, a number
/// beyond what a polygon may have (kMaxPolygonCoordinate).
[[nodiscard]] tl::expected<std::vector<SvgPoint>, PointsMistake> parseSvgPoints(std::string_view text);

/// The polygon of such a list: user units taken as pixels, rounded to 1/256, ties to even. Also a mistake: fewer than
/// three points, or more than kMaxPolygonVertices.
[[nodiscard]] tl::expected<Polygon, PointsMistake> parsePolygonPoints(std::string_view text);

}  // namespace rasterdiff
