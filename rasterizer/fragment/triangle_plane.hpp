// The plane equations of one triangle: what all values that are linear on the screen share, with their derived bounds.
#pragma once

#include <array>
#include <span>

#include "rasterizer/fragment/plane_formula.hpp"
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

  /// Can a legal placement halve the triangle's area, or take it away?
  [[nodiscard]] bool isUndetermined() const { return t_.undetermined(); }

  /// The plane through `values` at the corners, which are known within `inputError`. `outside`: how many pixels outside
  /// of the triangle the plane may be evaluated.
  [[nodiscard]] LinearFunction through(const std::array<double, 3>& values, double inputError, double outside) const;

  /// The gradient of that plane.
  [[nodiscard]] Gradient gradient(const std::array<double, 3>& values, double inputError) const;

 private:
  TriangleMeasures<double> t_;
  double reach_ = 1;  // bound on Σ |bᵢ| where the planes are evaluated
};

}  // namespace rasterdiff::rasterizer
