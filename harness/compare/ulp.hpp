// Distance between float32 numbers in units in the last place.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace rasterdiff::harness {

/// Number of float32 values from a to b; -0 and +0 are the same; infinity where either is NaN (unless both are).
[[nodiscard]] inline double ulpDistance(float a, float b) {
  if (std::isnan(a) || std::isnan(b)) {
    return std::isnan(a) && std::isnan(b) ? 0 : std::numeric_limits<double>::infinity();
  }
  const auto ordered = [](float value) {
    const auto bits = std::bit_cast<int32_t>(value);
    return bits >= 0 ? int64_t{bits} : -int64_t{bits & std::numeric_limits<int32_t>::max()};
  };
  return std::fabs(static_cast<double>(ordered(a) - ordered(b)));
}

}  // namespace rasterdiff::harness
