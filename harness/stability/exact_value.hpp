// Values in extended precision at points of a triangle: what the reference's doubles are measured against.
#pragma once

#include <array>

#include "rasterizer/geometry.hpp"

namespace rasterdiff::harness::stability {

/// The corners of a piece, unsnapped, with what is interpolated there.
struct ExactTriangle {
  std::array<long double, 3> x{}, y{}, reciprocalW{}, value{};

  /// Linear on the screen, or perspective (by 1 / w), at (px, py) in pixels. Weights are areas; rounding 2^-64 each.
  [[nodiscard]] long double at(long double px, long double py, bool perspective) const {
    const auto area = [&](size_t i, size_t j) { return (x[i] - px) * (y[j] - py) - (y[i] - py) * (x[j] - px); };
    const std::array<long double, 3> weights{area(1, 2), area(2, 0), area(0, 1)};
    long double numerator = 0, denominator = 0;
    for (size_t i = 0; i < 3; ++i) {
      const long double weight = perspective ? weights[i] * reciprocalW[i] : weights[i];
      numerator += weight * value[i];
      denominator += weight;
    }
    return numerator / denominator;
  }
};

}  // namespace rasterdiff::harness::stability
