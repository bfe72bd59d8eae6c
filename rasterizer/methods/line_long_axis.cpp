// A line by one loop over its longer axis, in the float32 of the lecture's pseudocode, with and without end pixels.
#include <array>
#include <cmath>
#include <utility>

#include "rasterizer/methods/line_methods.hpp"

namespace rasterdiff::rasterizer {
namespace {

using Point = std::array<float, 2>;

Point inPixels(SubpixelPosition p) {
  constexpr float kUnit = 1.0f / kSubpixelOne;
  return {static_cast<float>(p.x) * kUnit, static_cast<float>(p.y) * kUnit};
}

bool inOpenDiamond(const Point& p, PixelIndex pixel) {
  return std::fabs(p[0] - (static_cast<float>(pixel.x) + 0.5f)) +
             std::fabs(p[1] - (static_cast<float>(pixel.y) + 0.5f)) <
         0.5f;
}

std::vector<PixelIndex> walk(Point a, Point b) {
  const size_t longer = std::fabs(b[0] - a[0]) >= std::fabs(b[1] - a[1]) ? 0 : 1, shorter = 1 - longer;
  if (a[longer] > b[longer]) std::swap(a, b);
  const float extent = b[longer] - a[longer];
  std::vector<PixelIndex> pixels;
  if (extent == 0) return pixels;
  const auto from = static_cast<int32_t>(std::floor(a[longer])), to = static_cast<int32_t>(std::floor(b[longer]));
  for (int32_t u = from; u <= to; ++u) {
    const float way = (static_cast<float>(u) + 0.5f - a[longer]) / extent;
    const float v = way * (b[shorter] - a[shorter]) + a[shorter];
    const auto across = static_cast<int32_t>(std::floor(v));
    pixels.push_back(longer == 0 ? PixelIndex{u, across} : PixelIndex{across, u});
  }
  return pixels;
}

}  // namespace

std::vector<PixelIndex> drawLineLongAxis(SubpixelPosition a, SubpixelPosition b) {
  return walk(inPixels(a), inPixels(b));
}

std::vector<PixelIndex> drawLineLongAxisTrimmed(SubpixelPosition a, SubpixelPosition b) {
  const Point ends[] = {inPixels(a), inPixels(b)};
  std::vector<PixelIndex> pixels = walk(ends[0], ends[1]);
  const auto holdsAnEnd = [&](PixelIndex pixel) {
    return inOpenDiamond(ends[0], pixel) || inOpenDiamond(ends[1], pixel);
  };
  if (!pixels.empty() && holdsAnEnd(pixels.back())) pixels.pop_back();
  if (!pixels.empty() && holdsAnEnd(pixels.front())) pixels.erase(pixels.begin());
  return pixels;
}

}  // namespace rasterdiff::rasterizer
