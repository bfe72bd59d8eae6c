// Many samples a pixel, exactly, and resampling to one value a pixel by the box filter.
#pragma once

#include <cstdint>
#include <vector>

#include "rasterizer/kernels/snapped_triangle.hpp"
#include "rasterizer/methods/pixel_mask.hpp"

namespace rasterdiff::rasterizer {

/// Where the samples of every pixel are, in units of 1 / (256 · scale) pixel from its top-left corner.
struct SamplePoints {
  int32_t scale = 1;  ///< 1..32
  std::vector<SubpixelPosition> offsets;
};

inline constexpr int32_t kMaxSupersample = 32;

/// The centres of n × n equal squares, 1 ≤ n ≤ kMaxSupersample.
[[nodiscard]] SamplePoints regularSamples(int32_t n);
/// Vulkan's standard locations for 1, 2, 4, 8 or 16 samples (none for another count).
[[nodiscard]] SamplePoints standardSamples(uint32_t count);

/// How many of the pixel's samples the triangle covers, by integer edge functions with top-left ties. All coordinates
/// are multiplied by the scale, so the samples lie on integers. |coordinates| ≤ 2^23. // · 32 ≤ 2^28
[[nodiscard]] uint32_t coveredSamples(const SnappedTriangle& triangle, const SamplePoints& points, PixelIndex pixel);

/// One value a pixel, row-major.
struct GrayImage {
  int32_t width = 0, height = 0;
  std::vector<double> value;

  GrayImage() = default;
  GrayImage(int32_t w, int32_t h) : width(w), height(h), value(static_cast<size_t>(w) * static_cast<size_t>(h)) {}
  double& at(int32_t x, int32_t y) { return value[index(x, y)]; }
  [[nodiscard]] double at(int32_t x, int32_t y) const { return value[index(x, y)]; }

 private:
  [[nodiscard]] size_t index(int32_t x, int32_t y) const {
    return static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x);
  }
};

/// The mean of every n × n block of `fine`, whose extents are multiples of n (what is left over is dropped).
[[nodiscard]] GrayImage resampleBox(const GrayImage& fine, int32_t n);

}  // namespace rasterdiff::rasterizer
