// A line whose four corners are made in clip space, cut as a polygon is, and snapped. [choice:line-arithmetic]
#pragma once

#include <memory>

#include "rasterizer/clip.hpp"
#include "rasterizer/lines/line_style.hpp"
#include "rasterizer/shape.hpp"

namespace rasterdiff::rasterizer {

/// From LineEnds::clip; not for stippled lines. A Bresenham line is the parallelogram between opposite corners of the
/// diamonds around its ends, and covers all samples of a pixel or none. Null where nothing is drawn.
[[nodiscard]] std::unique_ptr<Shape> makeClipCornerLine(const std::array<ClipPosition, 2>& ends, const LineStyle& style,
                                                        const VertexStage& stage, const ClipVolume& volume);

}  // namespace rasterdiff::rasterizer
