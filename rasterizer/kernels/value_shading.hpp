// Varyings of what is visible: each sample's values once, from its final primitive.
#pragma once

#include "rasterizer/kernels/value_target.hpp"

namespace rasterdiff::rasterizer {

/// Pixels left <= x < right, top <= y < bottom.
struct ShadedArea {
  uint32_t left = 0, top = 0, right = 0, bottom = 0;
};

/// Evaluates all varyings of rows [firstRow, endRow) at pixel centres, for samples with a primitive.
/// How precisely: value_setup-inl.h.
void shadeRows(const ValueTriangles& triangles, ValueTarget& target, uint32_t firstRow, uint32_t endRow);

}  // namespace rasterdiff::rasterizer
