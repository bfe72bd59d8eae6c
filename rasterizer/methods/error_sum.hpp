// Largest, mean and root-mean-square error of a number of cases.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace rasterdiff::rasterizer {

struct ErrorSum {
  uint64_t cases = 0;
  double max = 0, sum = 0, squares = 0;

  /// `error` is a magnitude or signed.
  void add(double error) {
    ++cases;
    max = std::max(max, std::fabs(error));
    sum += std::fabs(error);
    squares += error * error;
  }
  [[nodiscard]] double mean() const { return cases == 0 ? 0 : sum / static_cast<double>(cases); }
  [[nodiscard]] double rms() const { return cases == 0 ? 0 : std::sqrt(squares / static_cast<double>(cases)); }
};

}  // namespace rasterdiff::rasterizer
