// The exact sign of a sum of doubles (Shewchuk 1997, grow-expansion), for the few decisions that doubles cannot make.
#pragma once

#include <cmath>
#include <span>

namespace rasterdiff::rasterizer {

/// -1, 0 or 1: the sign of the exact sum of at most 16 finite terms. No overflow for |term| < 2^1000.
[[nodiscard]] inline int exactSign(std::span<const double> terms) {
  double expansion[16];
  int size = 0;
  for (double carry : terms) {
    int kept = 0;
    for (int i = 0; i < size; ++i) {
      // Knuth's two-sum: sum + error == carry + expansion[i], exactly.
      const double sum = carry + expansion[i];
      const double virtualPart = sum - carry;
      const double error = (carry - (sum - virtualPart)) + (expansion[i] - virtualPart);
      if (error != 0) expansion[kept++] = error;
      carry = sum;
    }
    if (carry != 0) expansion[kept++] = carry;
    size = kept;
  }
  // Components do not overlap and grow in magnitude: the last one has the sign of the sum.
  if (size == 0) return 0;
  return expansion[size - 1] > 0 ? 1 : -1;
}

/// a · b as an exact pair of doubles.
inline void twoProduct(double a, double b, double& high, double& low) {
  high = a * b;
  low = std::fma(a, b, -high);
}

}  // namespace rasterdiff::rasterizer
