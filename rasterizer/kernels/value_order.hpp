// The order in which triangles are drawn under a depth test: where it hides more, another one than theirs.
#pragma once

#include <cstdint>
#include <vector>

#include "rasterizer/kernels/value_target.hpp"

namespace rasterdiff::rasterizer {

/// Places of all triangles, roughly those first that are nearest; empty where their own order is as good, or where the planes depend on it:
/// without a depth test or with counts. Otherwise what is left of all is the least depth, and of the triangles that have it the first one, in
/// whatever order they are drawn.
[[nodiscard]] std::vector<uint32_t> nearestFirst(const ValueTriangles& triangles, const ValueTarget& target);

}  // namespace rasterdiff::rasterizer
