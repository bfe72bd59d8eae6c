// Division of integers towards minus and plus infinity, which C++ leaves out.
#pragma once

#include <cstdint>

namespace rasterdiff::rasterizer {

/// ⌊n / d⌋ for d > 0.
[[nodiscard]] constexpr int64_t floorDivide(int64_t n, int64_t d) { return n / d - (n % d < 0 ? 1 : 0); }

/// ⌈n / d⌉ for d > 0.
[[nodiscard]] constexpr int64_t ceilDivide(int64_t n, int64_t d) { return n / d + (n % d > 0 ? 1 : 0); }

/// n - d ⌊n / d⌋, in 0 .. d - 1, for d > 0.
[[nodiscard]] constexpr int64_t floorRemainder(int64_t n, int64_t d) { return n % d + (n % d < 0 ? d : 0); }

}  // namespace rasterdiff::rasterizer
