// The exact answer of the interpolation methods: integer weights, extended precision for the few remaining operations.
#include <algorithm>
#include <cmath>

#include "rasterizer/edge_function.hpp"
#include "rasterizer/methods/interpolation_methods.hpp"

namespace rasterdiff::rasterizer {

long double interpolateExactly(const InterpolatedTriangle& triangle, SubpixelPosition p, bool perspective) {
  const auto& [a, b, c] = triangle.position;
  // Differences < 2^24, so that weights are below 2^49: exact in int64 and in long double.
  const std::array<int64_t, 3> weights = {doubleArea(p, b, c), doubleArea(a, p, c), doubleArea(a, b, p)};
  long double numerator = 0, denominator = 0;
  for (size_t i = 0; i < 3; ++i) {
    const long double weight =
        perspective ? static_cast<long double>(weights[i]) / triangle.w[i] : static_cast<long double>(weights[i]);
    numerator += weight * triangle.value[i];
    denominator += weight;
  }
  return numerator / denominator;
}

double ulpsFrom(long double exact, float value) {
  constexpr int kMantissaBits = 23, kLowestExponent = -126;
  int exponent = 0;
  (void)std::frexp(exact, &exponent);  // |exact| in [½, 1) · 2^exponent
  const int unit = std::max(exponent - 1, kLowestExponent) - kMantissaBits;
  return static_cast<double>(std::ldexp(std::fabs(static_cast<long double>(value) - exact), -unit));
}

}  // namespace rasterdiff::rasterizer
