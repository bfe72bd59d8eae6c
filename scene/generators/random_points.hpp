// Random points on a stated grid: the same seed gives the same scene everywhere.
#pragma once

#include <cstdint>

#include "scene/generators/grid.hpp"
#include "scene/scene.hpp"

namespace rasterdiff {

struct RandomPoints {
  uint64_t seed = 1;
  uint32_t points = 400;
  Grid grid = Grid::Sixteenth;
  uint32_t samples = 1;
  float smallest = 1, largest = 1;  ///< pixels; sizes between them are multiples of 1/8
  uint32_t extent = 128;            ///< square target, pixels; rounded down to a power of two in 16..16384
};

/// A point list inside the view volume; one point in four lies on a pixel's centre, corner or edge.
[[nodiscard]] Scene randomPoints(const RandomPoints& options);

}  // namespace rasterdiff
