// Which pixels a tiled driver looks at when it draws a multisampled line. Its bounding box of a line is made for the
// one sample of a pixel that positions are relative to; with several samples, positions are relative to the pixel's
// corner: a line that reaches no corner is dropped, and so is the part of a line before its first corner where that
// part lies in another tile. [choice:line-arithmetic]
#pragma once

#include "rasterizer/drawing_region.hpp"
#include "rasterizer/lines/float_corners.hpp"

namespace rasterdiff::rasterizer {

/// Pixels whose upper left corner lies in the outline's bounding box.
[[nodiscard]] PixelBox cornersInside(const LineOutline& outline);

/// Whole tiles. `region`: the target cut by the scissor. Empty (right ≤ left) where the line is dropped altogether.
[[nodiscard]] PixelArea binnedArea(const LineOutline& outline, const PixelArea& region);

}  // namespace rasterdiff::rasterizer
