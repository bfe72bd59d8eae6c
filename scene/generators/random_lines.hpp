// Random lines on a stated grid: the same seed gives the same scene everywhere.
#pragma once

#include <cstdint>

#include "scene/generators/grid.hpp"
#include "scene/scene.hpp"

namespace rasterdiff {

struct RandomLines {
  uint64_t seed = 1;
  uint32_t lines = 400;
  Grid grid = Grid::Sixteenth;
  uint32_t samples = 1;
  LineRasterizationMode mode = LineRasterizationMode::RECTANGULAR;
  float width = 1;        ///< pixels
  uint32_t extent = 128;  ///< square target, pixels; rounded down to a power of two in 16..16384
};

/// A line list inside the view volume: short and long lines in all octants, axis-parallel ones, slopes of exactly ±1,
/// ends on centres, corners and edges of the pixels' diamonds, and a few of length zero.
[[nodiscard]] Scene randomLines(const RandomLines& options);

}  // namespace rasterdiff
