// `<polygon points="...">` elements out of SVG text, on the subpixel grid. Styling, groups, style sheets and all other
// elements are left to real SVG programs.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "scene/polygon/polygon.hpp"

namespace rasterdiff {

struct SvgPolygon {
  Polygon polygon;                        ///< as parsePolygonPoints() rounds it
  FillRule fillRule = FillRule::NonZero;  ///< attribute fill-rule; SVG's initial value
  friend bool operator==(const SvgPolygon&, const SvgPolygon&) = default;
};

/// All polygon elements of an SVG document or fragment, in order. Error: BadInput, `where` "fileName:line:column", for
/// broken markup, an element without points, bad points, an unknown fill-rule, and for what would move the picture
/// (user units must be pixels): `transform`, and a `viewBox` that is not "0 0 width height" of the same element.
[[nodiscard]] Result<std::vector<SvgPolygon>> parseSvgPolygons(std::string_view svg, const std::string& fileName);

/// The same of a file. Error: also Io.
[[nodiscard]] Result<std::vector<SvgPolygon>> loadSvgPolygons(const std::string& path);

}  // namespace rasterdiff
