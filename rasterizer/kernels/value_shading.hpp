// Varyings of what is visible: each sample's values once, from its final primitive.
#pragma once

#include "rasterizer/kernels/value_view.hpp"

namespace rasterdiff::rasterizer {

/// Evaluates all varyings of the area at pixel centres, for samples with a primitive. How precisely: varyingBound.
void shadeArea(const ValueTriangles& triangles, ValueTarget& target, const DrawnArea& area);

}  // namespace rasterdiff::rasterizer
