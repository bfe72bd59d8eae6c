// A value that is linear on the screen, evaluated in float32 as one device or another may do it: set up once a primitive.
#pragma once

#include <array>

#include "rasterizer/legal/variation.hpp"

namespace rasterdiff::rasterizer {

struct FloatSpot {
  float x = 0, y = 0;  ///< pixels
};

class FloatFunction {
 public:
  FloatFunction() = default;
  /// Through `values` at the corners of a triangle, every operation rounded to float32.
  FloatFunction(Variation::Arithmetic arithmetic, const std::array<FloatSpot, 3>& corners, const std::array<float, 3>& values);
  /// Along the line from a to b: by projection, or along the major axis.
  FloatFunction(FloatSpot a, FloatSpot b, bool majorAxis, const std::array<float, 2>& values);

  /// Can a function go through values at these corners, in float32?
  [[nodiscard]] static bool hasArea(const std::array<FloatSpot, 3>& corners);

  [[nodiscard]] float at(FloatSpot p) const;

 private:
  Variation::Arithmetic arithmetic_ = Variation::Arithmetic::PlaneAtVertex;
  std::array<FloatSpot, 3> corners_{};
  std::array<float, 3> values_{};
  float anchor_ = 0, dx_ = 0, dy_ = 0, area_ = 0;
};

}  // namespace rasterdiff::rasterizer
