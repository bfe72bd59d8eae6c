// Primitive assembly: which vertices make which triangle, in which order, and which one provokes.
// [vk:drawing-primitive-topologies] [vk:vertexpostproc-flatshading]
#pragma once

#include <array>
#include <vector>

#include "rasterizer/deliberate_error.hpp"
#include "scene/scene.hpp"

namespace rasterdiff::rasterizer {

/// A point, line or triangle: vertex numbers into Draw::positions. The provoking vertex comes first in FIRST_VERTEX mode, last in LAST_VERTEX mode;
/// the winding is that of the specification's tables.
struct AssembledTriangle {
  std::array<uint32_t, 3> vertices{};
  uint32_t provoking = 0;
  uint32_t count = 3;          ///< 1: point, 2: line, 3: triangle
  bool continuesLine = false;  ///< a line of a strip that goes on from the one before it (stipple)
};

[[nodiscard]] std::vector<AssembledTriangle> assemble(const Draw& draw, const State& state,
                                                      DeliberateError error = DeliberateError::None);

}  // namespace rasterdiff::rasterizer
