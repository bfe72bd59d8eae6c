// The random triangles, lines and points that the families of random state start from: 128 × 128 pixels, on the 1/16
// grid (flat) or anywhere (in perspective).
#pragma once

#include "scene/catalogue/build.hpp"
#include "scene/generators/random_lines.hpp"
#include "scene/generators/random_points.hpp"
#include "scene/generators/random_triangles.hpp"

namespace rasterdiff::families {

inline constexpr uint32_t kRandomExtent = 128;

inline Scene someTriangles(uint64_t seed, uint32_t count, uint32_t samples, bool perspective = false) {
  return randomTriangles({seed, count, perspective ? Grid::Free : Grid::Sixteenth, samples, perspective, kRandomExtent, false});
}

inline Scene someLines(uint64_t seed, uint32_t count, uint32_t samples,
                       LineRasterizationMode mode = LineRasterizationMode::RECTANGULAR, float width = 1) {
  return randomLines({seed, count, Grid::Free, samples, mode, width, kRandomExtent});
}

inline Scene somePoints(uint64_t seed, uint32_t count, uint32_t samples) {
  return randomPoints({seed, count, Grid::Sixteenth, samples, 1, 8, kRandomExtent});
}

}  // namespace rasterdiff::families
