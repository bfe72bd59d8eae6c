// Random triangles on a stated grid: the same seed gives the same scene everywhere.
#pragma once

#include <cstdint>

#include "scene/generators/grid.hpp"
#include "scene/scene.hpp"

namespace rasterdiff {

struct RandomTriangles {
  uint64_t seed = 1;
  uint32_t triangles = 500;
  Grid grid = Grid::Half;
  uint32_t samples = 1;
  bool perspective = false;  ///< w varies: powers of two on a grid (so that x/w is exact), any float for Free
  uint32_t extent = 256;     ///< square target; a power of two, so that grid positions survive the viewport exactly
  bool values = false;       ///< also depth (LESS, written) and one smooth, one noperspective and one flat varying
};

/// Half the triangles are small (2..12 pixels), the others medium (12..40), slivers, below a pixel, as large as the
/// target, or rich in ties: vertices on samples, edges horizontal, vertical and diagonal. With `perspective` or `Free`
/// one triangle in twenty crosses a side of the view volume, with both one in a hundred crosses the near plane or w =
/// 0. All others lie inside. Depth is between 0 and w. `extent` is rounded down to a power of two in 16..16384.
[[nodiscard]] Scene randomTriangles(const RandomTriangles& options);

}  // namespace rasterdiff
