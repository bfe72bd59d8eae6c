// How much of a pixel a triangle covers, exactly: the analytic area of triangle ∩ square as a sum of integer fractions.
#pragma once

#include <array>

#include "rasterizer/kernels/snapped_triangle.hpp"
#include "rasterizer/methods/pixel_mask.hpp"

namespace rasterdiff::rasterizer {

/// whole + Σ numerator / denominator, in halves of a subpixel square: 131072 is a full pixel. Every edge (dx, dy)
/// brings one fraction over |dx| and one over |dy| and nothing else, so the value needs no common denominator.
struct ExactArea {
  static constexpr int64_t kFullPixel = 2 * int64_t{kSubpixelOne} * kSubpixelOne;
  struct Part {
    int64_t numerator = 0, denominator = 1;  ///< |numerator| < 4 · denominator
  };
  int64_t whole = 0;
  std::array<Part, 6> parts;

  /// In pixels, 0..1, within 2^-50.
  [[nodiscard]] double pixels() const;
};

/// Either winding, |coordinates| ≤ 2^28 (1/256 pixel), pixel within ±2^20. Zero area covers nothing.
[[nodiscard]] ExactArea coveredArea(const SnappedTriangle& triangle, PixelIndex pixel);

}  // namespace rasterdiff::rasterizer
