// The grammar of SVG's `points` attribute (SVG 2, "Basic shapes"): numbers in pairs. Elements are left to svg_polygon.
#pragma once

#include <string_view>
#include <vector>

#include "scene/result.hpp"

namespace rasterdiff::rasterizer {

/// A point in SVG user units, y down.
struct SvgPoint {
  double x = 0, y = 0;
  friend bool operator==(const SvgPoint&, const SvgPoint&) = default;
};

/// `text` is the attribute's value: numbers separated by white space, one comma, or nothing where a sign or a second
/// dot starts the next number ("10-20", ".5.5"). An empty list is legal.
/// Error: BadInput with `where` "points:column" (1-based): no number, an odd count, a number beyond double.
[[nodiscard]] Result<std::vector<SvgPoint>> parseSvgPoints(std::string_view text);

}  // namespace rasterdiff::rasterizer
