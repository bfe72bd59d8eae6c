// The thin line whose pixels are the lowest (leftmost) of each column (row) of a wide Bresenham line.
#pragma once

#include <cstdlib>

#include "rasterizer/lines/line_width.hpp"
#include "rasterizer/methods/diamond_exit.hpp"

namespace rasterdiff::rasterizer {

/// Ends moved by -(width - 1) / 2 pixels along the minor axis. [vk:primsrast-lines-bresenham]
[[nodiscard]] DiamondLine bresenhamLine(SubpixelPosition a, SubpixelPosition b, int64_t width, DiamondExit rule);

}  // namespace rasterdiff::rasterizer
