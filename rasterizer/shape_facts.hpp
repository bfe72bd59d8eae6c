// Why a sample is inside or outside of a point or a line, in numbers. Shapes fill it in when asked; `explain` shows it.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "rasterizer/methods/pixel_mask.hpp"
#include "scene/spaces.hpp"

namespace rasterdiff::rasterizer {

/// One side of an outline, and the sample's distance to it. Decided exactly; `inside` is that decision rounded.
struct SideFacts {
  std::string_view name;     ///< "left", "start", ...
  double inside = 0;         ///< pixels; negative outside
  bool exactlyOn = false;
  bool ownsTies = false;     ///< samples exactly on it are inside
};

/// The column (x-major) or row (y-major) of the sample's pixel in a Bresenham line.
struct DiamondFacts {
  bool xMajor = true;
  int64_t number = 0, count = 0;  ///< the column's number along the line; the line has pixels in columns 0 to count - 1
  PixelIndex pixel;               ///< of the thin line in that column; a wide one goes on down or to the right from it
  int64_t width = 1;              ///< pixels across
  int64_t crossing = 0, unit = 1; ///< where the line crosses the column's middle: crossing / unit pixels, exactly
  [[nodiscard]] bool inColumn() const { return number >= 0 && number < count; }
};

struct StippleFacts {
  uint64_t counter = 0;  ///< s
  uint32_t bit = 0;      ///< ⌊s / factor⌋ mod 16
  bool draws = true;
};

struct ShapeFacts {
  std::vector<FramebufferPosition> corners;  ///< pixels, of the outline around the sample
  std::vector<SideFacts> sides;
  std::optional<DiamondFacts> diamond;
  std::optional<StippleFacts> stipple;
};

}  // namespace rasterdiff::rasterizer
