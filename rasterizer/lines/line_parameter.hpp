// How far along a line a fragment is: what depth and varyings are interpolated by. [vk:primsrast-lines-basic]
#pragma once

#include "rasterizer/lines/line_style.hpp"

namespace rasterdiff::rasterizer {

/// t = value + dx · x + dy · y with x, y in pixels; 0 at the start of the line and 1 at its end, the unsnapped ones.
struct LineParameter {
  double value = 0, dx = 0, dy = 0;
  /// Bound on the difference to another legal parameter: of a line without strictLines, or a Bresenham line, whose
  /// fragments may be projected on the line, or may all have the value of their column or row.
  double alternative = 0;
  [[nodiscard]] double at(double x, double y) const { return value + dx * x + dy * y; }
};

/// Rectangles: the projection on the line. Parallelograms and Bresenham lines: along the major axis, so that a column
/// (row) has one value. All zero for a line without length.
[[nodiscard]] LineParameter lineParameter(const LineEnds& ends, const LineStyle& style, const Rules& rules);

}  // namespace rasterdiff::rasterizer
