// What the span kernels need to know of a mask, as the doubles and words that they compute with.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "rasterizer/kernels/coverage_mask.hpp"

namespace rasterdiff::rasterizer {

struct SpanTarget {
  uint64_t* words = nullptr;
  uint64_t* full = nullptr;  ///< full bits of a mask, `fullStride` words for each 64 windows
  size_t fullStride = 0;
  double width = 0, height = 0;         ///< pixels
  double rowWords = 0, blockWords = 0;  ///< from one block row, and one half column, to the next
  size_t samples = 1;
  double x[16] = {}, y[16] = {};                    ///< sample offsets in 1/256 pixel
  double minX = 0, maxX = 0, minY = 0, maxY = 0;  ///< over the samples
};

/// Blocks of one shape, for narrow triangles.
struct NarrowTarget {
  uint64_t start = 0;  ///< address of the first block, less what span_narrow-inl.h adds to it
  double stride = 0;   ///< blocks of a sample in a row
  size_t samples = 1;
};

/// 8·i as doubles: first rows of block rows, and of every eighth, first pixels of windows.
inline constexpr auto kEights = [] {
  std::array<double, 4104> eights{};
  for (size_t i = 0; i < eights.size(); ++i) eights[i] = 8.0 * static_cast<double>(i);
  return eights;
}();

[[nodiscard]] SpanTarget spanTarget(CoverageMask& mask);

}  // namespace rasterdiff::rasterizer
