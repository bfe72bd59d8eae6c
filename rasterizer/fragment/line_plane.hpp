// Values along a line: linear on the screen in the line's parameter t, with their derived bounds.
// [vk:primsrast-lines-basic]
#pragma once

#include "rasterizer/fragment/triangle_plane.hpp"

namespace rasterdiff::rasterizer {

/// Which t a point has.
enum class LineParameter : uint8_t {
  Projection,  ///< t = (p - a) · (b - a) / |b - a|²
  MajorAxis,   ///< of a parallelogram whose ends are parallel to the minor axis: t = (x - xa) / (xb - xa), or with y
  Replicated,  ///< of the lowest fragment of a wide Bresenham line's column [vk:primsrast-lines-bresenham]
};

class LinePlane {
 public:
  /// Ends with their legal deviations; `width` in pixels.
  LinePlane(const RasterVertex& a, const RasterVertex& b, float width, LineParameter parameter);

  /// The function that is `fa` and `fb` at the ends, which are known within `inputError`.
  [[nodiscard]] LinearFunction through(double fa, double fb, double inputError) const;

  [[nodiscard]] double slopeX() const { return tx_; }  ///< ∂t/∂x, 1/pixels
  [[nodiscard]] double slopeY() const { return ty_; }

 private:
  double ax_, ay_, farX_, farY_;
  double tx_ = 0, ty_ = 0;
  double parameterRadius_ = kUnbounded;  // deviation of t where the ends may be elsewhere
  double spread_ = 1;                    // bound on |1 - t| + |t|
};

}  // namespace rasterdiff::rasterizer
