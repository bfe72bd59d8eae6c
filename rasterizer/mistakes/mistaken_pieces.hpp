// Deliberate errors in the setup of filled triangles: which side is seen, and what an edge is.
#pragma once

#include "rasterizer/geometry.hpp"

namespace rasterdiff::rasterizer {

/// The facing of a piece that is rightly `front`.
[[nodiscard]] bool mistakenFacing(bool front, const Primitive& primitive, DeliberateError error);

void mistakeEdges(std::array<EdgeFunction, 3>& edges, DeliberateError error);

}  // namespace rasterdiff::rasterizer
