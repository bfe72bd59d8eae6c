// A value that is linear on the screen, with the bound on what a float32 evaluation may make of it; how values and
// bounds become float32 numbers.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "scene/frame.hpp"

namespace rasterdiff::rasterizer {

inline constexpr double kHalfUlp = 0x1p-24;  ///< relative rounding error of float32
inline constexpr double kUnbounded = std::numeric_limits<double>::infinity();

/// value + dx (x - x0) + dy (y - y0), pixels; radius(x, y) bounds the deviation of a legal float32 evaluation there.
struct LinearFunction {
  double value = 0, dx = 0, dy = 0, x0 = 0, y0 = 0;
  double constantRadius = 0, radiusPerX = 0, radiusPerY = 0, farX = 0, farY = 0;
  [[nodiscard]] double at(double x, double y) const { return value + dx * (x - x0) + dy * (y - y0); }
  [[nodiscard]] double radius(double x, double y) const {
    return constantRadius + radiusPerX * (std::max(farX, x) + 1) + radiusPerY * (std::max(farY, y) + 1);
  }
};

/// A value with its legal interval, before it becomes a float32 number.
struct Interval {
  double value = 0, lo = 0, hi = 0;
};

struct Interpolated {
  float value = 0;
  Bounds bounds;
};

/// Without branches, which nobody could predict: floats in the order of integers, the next one if rounding went down.
/// A NaN stays one.
[[nodiscard]] inline float roundedUp(double value) {
  const auto rounded = static_cast<float>(value);
  const auto bits = std::bit_cast<int32_t>(rounded);
  const int32_t ordered = (bits ^ ((bits >> 31) & 0x7FFFFFFF)) + (rounded < value ? 1 : 0);
  return std::bit_cast<float>(ordered ^ ((ordered >> 31) & 0x7FFFFFFF));
}

[[nodiscard]] inline float roundedDown(double value) { return -roundedUp(-value); }

/// The nearest float32 number with bounds rounded outward; without bounds where they are not numbers.
[[nodiscard]] inline Interpolated toFloat(const Interval& interval) {
  const bool bounded = !std::isnan(interval.lo) && !std::isnan(interval.hi);
  return {static_cast<float>(interval.value),
          {roundedDown(bounded ? interval.lo : -kUnbounded), roundedUp(bounded ? interval.hi : kUnbounded)}};
}

[[nodiscard]] inline Interpolated exactly(float value) { return {value, {value, value}}; }

}  // namespace rasterdiff::rasterizer
