// The pixels of one triangle by integer edge functions with top-left ties, for methods that are made of triangles.
#pragma once

#include "rasterizer/kernels/snapped_triangle.hpp"
#include "rasterizer/methods/pixel_mask.hpp"

namespace rasterdiff::rasterizer {

/// Sets the pixels whose centre the triangle covers; either winding; zero area covers nothing.
void addTrianglePixels(const SnappedTriangle& triangle, PixelMask& mask);

}  // namespace rasterdiff::rasterizer
