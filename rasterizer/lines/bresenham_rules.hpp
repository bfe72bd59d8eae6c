// What all fragments of one Bresenham line must obey together, whatever algorithm made them; which single pixels they
// can be is line_band.hpp's business. [vk:primsrast-lines-bresenham]
#pragma once

#include <span>

#include "rasterizer/lines/line_style.hpp"
#include "rasterizer/methods/pixel_mask.hpp"

namespace rasterdiff::rasterizer {

enum class BresenhamFault : uint8_t {
  None,
  TwoInAColumn,  ///< an x-major line has two fragments in a column (y-major: in a row)
  WrongWidth,    ///< a column (row) of a wide line has not as many pixels as the line is wide
  TooFar,        ///< more than one pixel from every fragment of the diamond-exit rule
  TooMany,       ///< over one fragment more than by the diamond-exit rule
  TooFew,        ///< over one fragment less
};

struct BresenhamFinding {
  BresenhamFault fault = BresenhamFault::None;
  PixelIndex where;  ///< a pixel that shows it; of no meaning for None, TooMany and TooFew
};

/// `pixels`: those that one unclipped, unstippled line covered within `style.area`, in any order, each once. A fault is
/// reported if no legal placement of the ends and no legal width explains them; it is the nominal one's.
[[nodiscard]] BresenhamFinding checkBresenhamPixels(std::span<const PixelIndex> pixels, const LineEnds& ends,
                                                    const LineStyle& style, const Rules& rules);

}  // namespace rasterdiff::rasterizer
