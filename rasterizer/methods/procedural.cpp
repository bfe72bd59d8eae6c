#include "rasterizer/methods/procedural.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace rasterdiff::rasterizer {
namespace {

constexpr double kZoneFactor = std::numbers::pi / kProceduralExtent;
constexpr double kHorizon = -1;                        // pixels
constexpr double kDepthScale = kProceduralExtent / 2;  // depth of the row y is scale / (y - horizon), in squares
constexpr double kFocal = kProceduralExtent / 8;       // pixels a square at depth 1
constexpr double kMiddle = kProceduralExtent / 2.0;

/// ∫ cos and ∫ sin of kZoneFactor t² over [from, from + 1].
struct Fresnel {
  double cosine = 0, sine = 0;
};

Fresnel fresnel(int32_t from) {
  // Five-point Gauss-Legendre (Abramowitz and Stegun, table 25.4) on 16 pieces.
  static constexpr std::array<double, 5> kNodes = {-0.906179845938664, -0.538469310105683, 0, 0.538469310105683,
                                                   0.906179845938664};
  static constexpr std::array<double, 5> kWeights = {0.236926885056189, 0.478628670499366, 0.568888888888889,
                                                     0.478628670499366, 0.236926885056189};
  constexpr int32_t kPieces = 16;
  Fresnel result;
  for (int32_t piece = 0; piece < kPieces; ++piece) {
    for (size_t i = 0; i < kNodes.size(); ++i) {
      const double t = from + (piece + 0.5 + 0.5 * kNodes[i]) / kPieces;
      result.cosine += kWeights[i] / (2 * kPieces) * std::cos(kZoneFactor * t * t);
      result.sine += kWeights[i] / (2 * kPieces) * std::sin(kZoneFactor * t * t);
    }
  }
  return result;
}

bool isOdd(double integer) { return std::fmod(integer, 2) != 0; }

/// ∫ from 0 to t of the square wave that is 1 where ⌊t⌋ is even.
double evenSquares(double t) {
  const double pairs = std::floor(t / 2);
  return pairs + std::min(t - 2 * pairs, 1.0);
}

/// Mean over pixel column x of the row at `y`, exact but for rounding.
double checkerRow(int32_t x, double y) {
  const double depth = kDepthScale / (y - kHorizon);
  const double squares = depth / kFocal;  // a pixel
  const double from = (x - kMiddle) * squares;
  const double even = (evenSquares(from + squares) - evenSquares(from)) / squares;
  return isOdd(std::floor(depth)) ? 1 - even : even;
}

}  // namespace

double zonePlate(double x, double y) { return 0.5 + 0.5 * std::cos(kZoneFactor * (x * x + y * y)); }

double zonePlateMean(int32_t x, int32_t y) {
  const Fresnel alongX = fresnel(x), alongY = fresnel(y);  // cos(a + b) = cos a cos b - sin a sin b
  return 0.5 + 0.5 * (alongX.cosine * alongY.cosine - alongX.sine * alongY.sine);
}

double farCheckerboard(double x, double y) {
  const double depth = kDepthScale / (y - kHorizon);
  const double across = (x - kMiddle) * depth / kFocal;
  return isOdd(std::floor(depth)) == isOdd(std::floor(across)) ? 1 : 0;
}

double farCheckerboardMean(int32_t x, int32_t y) {
  // Between rows of integer depth the parity is fixed and the row's mean changes smoothly: midpoint rule there.
  constexpr double kNodesAPixel = 256, kFewestNodes = 8;
  double total = 0, top = y;
  const double bottom = y + 1.0;
  for (double depth = std::ceil(kDepthScale / (top - kHorizon)) - 1; top < bottom; --depth) {
    const double strip = depth > 0 ? std::min(bottom, kHorizon + kDepthScale / depth) : bottom;
    const double nodes = std::max(kFewestNodes, std::ceil((strip - top) * kNodesAPixel));
    for (double i = 0; i < nodes; ++i)
      total += checkerRow(x, top + (strip - top) * (i + 0.5) / nodes) * (strip - top) / nodes;
    top = strip;
  }
  return total;
}

std::span<const ProceduralPicture> proceduralPictures() {
  static constexpr ProceduralPicture kPictures[] = {
      {"zone-plate", "rings whose frequency grows with the radius", zonePlate, zonePlateMean},
      {"far-checkerboard", "a ground plane up to the horizon", farCheckerboard, farCheckerboardMean},
  };
  return kPictures;
}

GrayImage samplePicture(const ProceduralPicture& picture, const SamplePoints& points) {
  GrayImage image(kProceduralExtent, kProceduralExtent);
  const double unit = 1.0 / (double{kSubpixelOne} * points.scale);
  for (int32_t y = 0; y < image.height; ++y) {
    for (int32_t x = 0; x < image.width; ++x) {
      double sum = 0;
      for (const SubpixelPosition offset : points.offsets) sum += picture.at(x + offset.x * unit, y + offset.y * unit);
      image.at(x, y) = sum / static_cast<double>(points.offsets.size());
    }
  }
  return image;
}

GrayImage meanPicture(const ProceduralPicture& picture) {
  GrayImage image(kProceduralExtent, kProceduralExtent);
  for (int32_t y = 0; y < image.height; ++y) {
    for (int32_t x = 0; x < image.width; ++x) image.at(x, y) = picture.mean(x, y);
  }
  return image;
}

PictureError comparePictures(const GrayImage& picture, const GrayImage& truth) {
  constexpr int32_t kBlock = 8;
  PictureError error;
  GrayImage difference(truth.width, truth.height);
  for (size_t i = 0; i < truth.value.size(); ++i) {
    difference.value[i] = picture.value[i] - truth.value[i];
    error.pixels.add(difference.value[i]);
    error.wrongPixels += std::lround(picture.value[i] * 255) != std::lround(truth.value[i] * 255) ? 1u : 0u;
  }
  for (const double mean : resampleBox(difference, kBlock).value) {
    error.blocks.add(mean);
    error.wrongBlocks += std::fabs(mean) > 0.5 / 255 ? 1u : 0u;
  }
  return error;
}

}  // namespace rasterdiff::rasterizer
