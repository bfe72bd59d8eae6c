// One byte a pixel: what the methods draw into, and how two answers are compared. Fast bit masks are in kernels/.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace rasterdiff::rasterizer {

/// A pixel by its column and row; its square is [x, x + 1] × [y, y + 1], its centre (x + ½, y + ½).
struct PixelIndex {
  int32_t x = 0, y = 0;
  friend bool operator==(const PixelIndex&, const PixelIndex&) = default;
  friend auto operator<=>(const PixelIndex&, const PixelIndex&) = default;
};

/// height × width, row-major; 1 where covered.
struct PixelMask {
  int32_t width = 0, height = 0;
  std::vector<uint8_t> covered;

  PixelMask() = default;
  PixelMask(int32_t w, int32_t h)
      : width(w), height(h), covered(static_cast<size_t>(w) * static_cast<size_t>(h), uint8_t{0}) {}

  [[nodiscard]] size_t index(int32_t x, int32_t y) const {
    return static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x);
  }
  uint8_t& at(int32_t x, int32_t y) { return covered[index(x, y)]; }
  [[nodiscard]] uint8_t at(int32_t x, int32_t y) const { return covered[index(x, y)]; }

  /// Pixels in which two masks of the same shape differ.
  [[nodiscard]] uint64_t differing(const PixelMask& other) const {
    uint64_t count = 0;
    for (size_t i = 0; i < covered.size(); ++i) count += covered[i] != other.covered[i] ? 1u : 0u;
    return count;
  }
};

}  // namespace rasterdiff::rasterizer
