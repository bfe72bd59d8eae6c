// Two pictures made to alias, as functions of the plane: a zone plate and a checkerboard that reaches to the horizon.
// Each comes with its true mean over a pixel, which is what every sampling of it tries to approach.
#pragma once

#include <span>
#include <string_view>

#include "rasterizer/methods/error_sum.hpp"
#include "rasterizer/methods/supersample.hpp"

namespace rasterdiff::rasterizer {

/// All procedural pictures have this many pixels a side.
inline constexpr int32_t kProceduralExtent = 128;

/// ½ + ½ cos(π r² / extent), r in pixels from the top-left corner: r / extent cycles a pixel, so everything beyond half
/// the extent is above the sampling limit of one sample a pixel.
[[nodiscard]] double zonePlate(double x, double y);
/// The same averaged over pixel (x, y): products of one-dimensional integrals, Gauss-Legendre, within 1e-12.
[[nodiscard]] double zonePlateMean(int32_t x, int32_t y);

/// A checkerboard on the ground (0 or 1), seen along it; the horizon is one pixel above the picture.
[[nodiscard]] double farCheckerboard(double x, double y);
/// The same averaged over pixel (x, y): exact along x, strip by strip of equal depth along y, within 1e-5.
[[nodiscard]] double farCheckerboardMean(int32_t x, int32_t y);

struct ProceduralPicture {
  std::string_view name, what;
  double (*at)(double x, double y);
  double (*mean)(int32_t x, int32_t y);
};

/// "zone-plate", "far-checkerboard".
[[nodiscard]] std::span<const ProceduralPicture> proceduralPictures();

/// Sampled at `points` and averaged to one value a pixel.
[[nodiscard]] GrayImage samplePicture(const ProceduralPicture& picture, const SamplePoints& points);
/// The true means.
[[nodiscard]] GrayImage meanPicture(const ProceduralPicture& picture);

/// How far a picture is from the true one.
struct PictureError {
  ErrorSum pixels;
  ErrorSum blocks;           ///< means of 8 × 8 pixels: false patterns (moiré) that are still there from afar
  uint64_t wrongPixels = 0;  ///< differing after rounding to 8 bits
  uint64_t wrongBlocks = 0;  ///< off by more than half a step of 8 bits
};
[[nodiscard]] PictureError comparePictures(const GrayImage& picture, const GrayImage& truth);

}  // namespace rasterdiff::rasterizer
