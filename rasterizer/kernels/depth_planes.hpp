// Planes of depth with their bounds, of many triangles at a time: TrianglePlane::through (fragment/triangle_plane.hpp), bit for bit.
#pragma once

#include <cstdint>
#include <span>

#include "rasterizer/fragment/linear_function.hpp"
#include "rasterizer/kernels/value_target.hpp"

namespace rasterdiff::rasterizer {

/// How well a triangle's corners are known.
struct CornerErrors {
  double deviation = 0;   ///< pixels, in x and in y
  double inputError = 0;  ///< of the depths
};

/// planes[k] = the plane of triangle numbers[k] - 1; as many planes as numbers.
void depthPlanes(std::span<const DepthCorners> corners, std::span<const CornerErrors> errors, std::span<const uint32_t> numbers,
                 std::span<LinearFunction> planes);

}  // namespace rasterdiff::rasterizer
