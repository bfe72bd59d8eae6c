// The width a device draws when a pipeline asks for one. [vk:primsrast-lines] [vk:limits-lineWidthRange]
#pragma once

#include "rasterizer/rules.hpp"

namespace rasterdiff::rasterizer {

/// Widths of rectangles and parallelograms in 1/256 pixel.  // Q9.8
struct LineWidth {
  int64_t nominal = kUnit;
  /// Widths between the advertised ones may be supported too, and the nearest supported width is used: any width that
  /// is no farther from the requested one than the nearest advertised width is legal.
  int64_t narrowest = kUnit, widest = kUnit;

  static constexpr int64_t kUnit = 256;
};

/// The advertised width nearest to `width`: clamped to the range, a whole number of granules above its lower end.
[[nodiscard]] LineWidth lineWidth(float width, const Limits& limits);

/// Pixels of a Bresenham line across: rounded to the nearest integer, clamped to the rounded range, at least 1.
/// [vk:primsrast-lines-bresenham]
struct BresenhamWidth {
  int64_t nominal = 1;
  int64_t other = 1;  ///< the other nearest integer where the width is half-way between two
};
[[nodiscard]] BresenhamWidth bresenhamWidth(float width, const Limits& limits);

}  // namespace rasterdiff::rasterizer
