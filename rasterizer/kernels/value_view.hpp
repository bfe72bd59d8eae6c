// What the value kernels need to know of a target, as the doubles and pointers that they compute with.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "rasterizer/kernels/value_target.hpp"

namespace rasterdiff::rasterizer {

/// A band of rows of a target; pointers are null for planes that it has not.
struct ValueView {
  uint32_t* primitive = nullptr;
  uint32_t* count = nullptr;
  float* depth = nullptr;
  uint32_t before = 0;        ///< triangles of earlier lists: the first one's number less 1
  uint64_t* met = nullptr;    ///< of planes through DepthCorners: counts fragments with exactly the depth that another one left
  bool shaded = false;        ///< there are varyings: what is drawn where is wanted
  bool reordered = false;     ///< triangles come in another order than theirs: of equally deep ones the first is wanted
  double width = 0, firstRow = 0, endRow = 0;  ///< pixels
  size_t samples = 1, stride = 0;
  double x[16] = {}, y[16] = {};                  ///< sample offsets in 1/256 pixel
  double minX = 0, maxX = 0, minY = 0, maxY = 0;  ///< over the samples
};

/// Rows [firstRow, endRow) of the target.
[[nodiscard]] ValueView valueView(ValueTarget& target, uint32_t firstRow, uint32_t endRow);

/// The triangles to draw, in order: `size` places of a list, or if there is no list all of ValueTriangles.
struct DrawnList {
  const uint32_t* places = nullptr;
  size_t size = 0;
};

/// Pixels left <= x < right, top <= y < bottom that triangles may have drawn; far: some of them are beyond the fast range.
struct DrawnArea {
  uint32_t left = 0, top = 0, right = 0, bottom = 0;
  bool far = false;
};

/// Twice the areas of `p` with the edges opposite to the vertices, exact integers rounded once.
[[nodiscard]] std::array<double, 3> edgeFunctions(const SnappedTriangle& triangle, SubpixelPosition p);

/// The plane of a linear value in doubles, evaluated as value_setup-inl.h says; distances in pixels.
struct LinearPlane {
  double a0 = 0, gx = 0, gy = 0, x0 = 0, y0 = 0;
};
[[nodiscard]] LinearPlane linearPlane(const SnappedTriangle& triangle, const std::array<double, 3>& values);

/// The same through corners that are on no grid: gradients that are divided, not multiplied by a reciprocal; none where the
/// corners are in line.
[[nodiscard]] LinearPlane linearPlane(const DepthCorners& corners);

/// Draws one triangle with any int32 vertices: triangle `place` of the list, without varyings.
void drawFarTriangle(const ValueTriangles& triangles, size_t place, const ValueView& view);

}  // namespace rasterdiff::rasterizer
