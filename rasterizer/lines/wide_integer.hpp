// 128-bit integers of the compiler, for comparing squares of edge functions exactly.
#pragma once

#include <cmath>
#include <cstdint>

namespace rasterdiff::rasterizer {

__extension__ typedef __int128 Int128;

[[nodiscard]] constexpr Int128 squared(int64_t value) { return Int128{value} * value; }

/// ⌊√value⌋ for 0 ≤ value < 2^124.
[[nodiscard]] inline int64_t squareRoot(Int128 value) {
  auto root = static_cast<int64_t>(std::sqrt(static_cast<long double>(value)));
  while (root > 0 && squared(root) > value) --root;
  while (squared(root + 1) <= value) ++root;
  return root;
}

/// ⌈√value⌉.
[[nodiscard]] inline int64_t squareRootUp(Int128 value) {
  const int64_t root = squareRoot(value);
  return squared(root) == value ? root : root + 1;
}

}  // namespace rasterdiff::rasterizer
