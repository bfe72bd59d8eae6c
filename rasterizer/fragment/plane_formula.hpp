// plane_formula.inc for double.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "rasterizer/fragment/linear_function.hpp"

namespace rasterdiff::rasterizer {

// What a formula needs of a number besides arithmetic.
[[nodiscard]] inline double magnitude(double v) { return std::fabs(v); }
[[nodiscard]] inline double larger(double a, double b) { return std::max(a, b); }
[[nodiscard]] inline bool isZero(double v) { return v == 0; }
[[nodiscard]] inline bool isAtLeast(double v, double bound) { return v >= bound; }
[[nodiscard]] inline bool both(bool a, bool b) { return a && b; }
[[nodiscard]] inline bool either(bool a, bool b) { return a || b; }
[[nodiscard]] inline double chosen(bool which, double yes, double no) { return which ? yes : no; }

/// Of a term of a sum of weighted vertices: 1 / det, times the edge, times the value, two sums.
inline constexpr double kWeightRoundings = 5;

#include "rasterizer/fragment/plane_formula.inc"

}  // namespace rasterdiff::rasterizer
