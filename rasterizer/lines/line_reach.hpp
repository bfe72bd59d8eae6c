// Where a line can have samples at all: all points within a distance of a segment, by rows of pixels.
#pragma once

#include "rasterizer/shape.hpp"

namespace rasterdiff::rasterizer {

/// Conservative: computed in doubles, with a margin far above their error.
class LineReach {
 public:
  /// `distance` in 1/256 pixel.
  LineReach(SubpixelPosition a, SubpixelPosition b, double distance);

  [[nodiscard]] Shape::Rows rows() const;
  [[nodiscard]] RowSpan columns(int32_t y) const;

 private:
  double topX_, topY_, bottomX_, bottomY_;  ///< the ends, upper one first
  double distance_;
};

/// The smallest spans that hold both.
[[nodiscard]] Shape::Rows both(Shape::Rows a, Shape::Rows b);
[[nodiscard]] RowSpan both(RowSpan a, RowSpan b);

}  // namespace rasterdiff::rasterizer
