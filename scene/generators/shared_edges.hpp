// Meshes whose triangles share edges that run through samples: every sample inside has exactly one right owner, so
// that a seam or a double hit shows without any reference. [vk:primsrast-polygons-basic]
#pragma once

#include <cstdint>

#include "scene/generators/grid.hpp"
#include "scene/scene.hpp"

namespace rasterdiff {

enum class SharedMesh : uint8_t {
  Fan,    ///< a fan around a vertex on a sample, closed
  Strip,  ///< a zigzag strip
  Grid,   ///< an indexed list over a jittered lattice; both diagonals occur
};

struct SharedEdges {
  uint64_t seed = 1;
  SharedMesh mesh = SharedMesh::Fan;
  Grid grid = Grid::Sixteenth;
  uint32_t samples = 1;
  uint32_t extent = 64;  ///< square target, pixels; rounded down to a power of two in 16..16384
  uint32_t pieces = 12;  ///< fan: rim vertices; strip: triangles; grid: cells a side (3..256)
};

/// Most vertices lie on samples (as far as the grid has them), all w are 1.
/// The topology fits the mesh; a Grid is one indexed draw.
[[nodiscard]] Scene sharedEdges(const SharedEdges& options);

}  // namespace rasterdiff
