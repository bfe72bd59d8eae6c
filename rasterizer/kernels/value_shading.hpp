// Varyings of what is visible: each sample's values once, from its final primitive.
#pragma once

#include "rasterizer/kernels/value_target.hpp"

namespace rasterdiff::rasterizer {

/// Evaluates all varyings of rows [firstRow, endRow) at pixel centres, for samples with a primitive.
/// Pixels are in chunks of eight from the target's left side; see value_setup-inl.h for how and how precisely.
void shadeRows(const ValueTriangles& triangles, ValueTarget& target, uint32_t firstRow, uint32_t endRow);

}  // namespace rasterdiff::rasterizer
