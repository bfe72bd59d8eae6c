// Inverses modulo a number, with which tests place a line at a chosen least distance from a sample.
#pragma once

#include <cstdint>
#include <utility>

namespace rasterdiff::rasterizer::testing {

/// The inverse of `a` modulo `m` > 0, in [0, m); 0 if they have a common factor. For |a|, m < 2^31.
inline int64_t inverseModulo(int64_t a, int64_t m) {
  int64_t r0 = m, r1 = ((a % m) + m) % m, s0 = 0, s1 = 1;
  while (r1 != 0) {
    const int64_t q = r0 / r1;
    r0 = std::exchange(r1, r0 - q * r1);
    s0 = std::exchange(s1, s0 - q * s1);
  }
  return r0 == 1 ? ((s0 % m) + m) % m : 0;
}

}  // namespace rasterdiff::rasterizer::testing
