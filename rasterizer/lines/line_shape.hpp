// Lines as shapes: what a profile covers and what the specification allows, by pixel rows.
// [vk:primsrast-lines-basic] [vk:primsrast-lines-bresenham] [vk:primsrast-lines-stipple]
#pragma once

#include <memory>

#include "rasterizer/lines/line_style.hpp"
#include "rasterizer/lines/stipple.hpp"
#include "rasterizer/shape.hpp"

namespace rasterdiff::rasterizer {

/// Null when nothing is drawn: zero length, or no fragment; under open rules only where no device may draw anything.
/// Closed rules classify as In or Out. `style.stipple.start` comes from stippleAfter() of the segment before.
[[nodiscard]] std::unique_ptr<Shape> makeLineShape(const LineEnds& ends, const LineStyle& style, const Rules& rules);

}  // namespace rasterdiff::rasterizer
