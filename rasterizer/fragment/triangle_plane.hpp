// The plane equations of one triangle: what all values that are linear on the screen share, with their derived bounds.
#pragma once

#include <array>
#include <span>

#include "rasterizer/fragment/linear_function.hpp"
#include "rasterizer/geometry.hpp"

namespace rasterdiff::rasterizer {

struct Gradient {
  double dx = 0, dy = 0;
  double radius = 0;  ///< bound on either's deviation in a legal float32 evaluation
};

class TrianglePlane {
 public:
  /// Corners in pixels; a legal corner lies within `deviation` pixels of its place in x and in y.
  TrianglePlane(const std::array<FramebufferPosition, 3>& corners, double deviation);

  /// The planes are evaluated around a part of the screen that need not lie inside of the triangle.
  void reachTo(std::span<const RasterVertex> polygon);

  /// The plane through `values` at the corners, which are known within `inputError`. `outside`: how many pixels outside
  /// of the triangle the plane may be evaluated.
  [[nodiscard]] LinearFunction through(const std::array<double, 3>& values, double inputError, double outside) const;

  /// The gradient of that plane.
  [[nodiscard]] Gradient gradient(const std::array<double, 3>& values, double inputError) const;

 private:
  [[nodiscard]] bool undetermined() const { return determinant_ == 0 || sensitivity_ >= 0.5; }

  double x_[3], y_[3];
  double e1x_, e1y_, e2x_, e2y_, determinant_;
  double perimeter_;    // L1, pixels
  double width_, height_;  // pixels
  double deviation_;    // pixels
  double condition_;    // 1 + (|e| + |f|) / |det|: how much the determinant's cancellation amplifies roundings
  double reach_ = 1;    // bound on Σ |bᵢ| where the planes are evaluated
  double sensitivity_;  // relative change of the determinant under legal placements
};

}  // namespace rasterdiff::rasterizer
