// Strips and fans as lists of the same triangles: winding and provoking vertices stay as they are.
#pragma once

#include <cstdint>
#include <vector>

#include "scene/scene.hpp"

namespace rasterdiff::vkref {

/// Three vertex numbers for each triangle of the draw, in the order of its primitives; restarts are taken into account.
[[nodiscard]] std::vector<uint32_t> triangleList(const State& state, const Draw& draw);

}  // namespace rasterdiff::vkref
