// Random strips and fans on a stated grid: the same seed gives the same scene everywhere.
#pragma once

#include <cstdint>

#include "scene/generators/grid.hpp"
#include "scene/scene.hpp"

namespace rasterdiff {

struct RandomStrips {
  uint64_t seed = 1;
  uint32_t primitives = 200;  ///< at least
  PrimitiveTopology topology = PrimitiveTopology::TRIANGLE_STRIP;  ///< or TRIANGLE_FAN, LINE_STRIP
  Grid grid = Grid::Sixteenth;
  uint32_t samples = 1;
  bool perspective = false;  ///< w varies: powers of two on a grid, any float for Free
  uint32_t extent = 128;     ///< square target, pixels; rounded down to a power of two in 16..16384
};

/// One indexed draw, cut into runs of 1 to 10 primitives by the restart index, all inside the view volume. Vertices
/// follow each other within 3 to 30 pixels; some are repeated, so that strips have triangles without area and lines
/// without length, and some runs end where they began.
[[nodiscard]] Scene randomStrips(const RandomStrips& options);

}  // namespace rasterdiff
