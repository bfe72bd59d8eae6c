// A pseudo-random source that gives the same numbers on every machine and standard library: SplitMix64 (Steele, Lea,
// Flood, "Fast splittable pseudorandom number generators", 2014). The standard's distributions do not promise that.
#pragma once

#include <cstdint>

namespace rasterdiff {

class Prng {
 public:
  explicit Prng(uint64_t seed) : state_(seed) {}

  uint64_t bits() {
    uint64_t z = (state_ += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }

  /// 0 .. n - 1 for n in 1 .. 2^32.
  uint32_t below(uint64_t n) { return static_cast<uint32_t>(((bits() >> 32) * n) >> 32); }  // Q0.32 × Q32 → Q32.32

  /// lo .. hi, both included.
  int32_t between(int32_t lo, int32_t hi) {
    return static_cast<int32_t>(int64_t{lo} + below(static_cast<uint64_t>(int64_t{hi} - lo + 1)));
  }

  /// [0, 1), 53 bits.
  double unit() { return static_cast<double>(bits() >> 11) * 0x1p-53; }
  double between(double lo, double hi) { return lo + (hi - lo) * unit(); }

  /// True in `percent` of 100 calls.
  bool chance(uint32_t percent) { return below(100) < percent; }

 private:
  uint64_t state_;
};

}  // namespace rasterdiff
