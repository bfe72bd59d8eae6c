#include "rasterizer/methods/supersample.hpp"

#include <utility>

#include "rasterizer/edge_function.hpp"
#include "scene/sample_locations.hpp"

namespace rasterdiff::rasterizer {

SamplePoints regularSamples(int32_t n) {
  SamplePoints points;
  points.scale = n;
  // (2i + 1) / (2n) pixel = 128 (2i + 1) units of 1 / (256 n)
  const auto place = [](int32_t i) { return kSubpixelOne / 2 * (2 * i + 1); };
  for (int32_t y = 0; y < n; ++y) {
    for (int32_t x = 0; x < n; ++x) points.offsets.push_back({place(x), place(y)});
  }
  return points;
}

SamplePoints standardSamples(uint32_t count) {
  SamplePoints points;
  for (const SampleLocation location : standardSampleLocations(count)) {
    points.offsets.push_back({location.x * kSampleUnit, location.y * kSampleUnit});
  }
  return points;
}

uint32_t coveredSamples(const SnappedTriangle& triangle, const SamplePoints& points, PixelIndex pixel) {
  const int32_t scale = points.scale;
  const auto scaled = [scale](SubpixelPosition p) { return SubpixelPosition{p.x * scale, p.y * scale}; };
  SubpixelPosition a = scaled(triangle.v[0]), b = scaled(triangle.v[1]), c = scaled(triangle.v[2]);
  const int64_t area = doubleArea(a, b, c);
  if (area == 0) return 0;
  if (area < 0) std::swap(b, c);
  const EdgeFunction edges[] = {edgeFunction(a, b, TieOwner::TopLeft), edgeFunction(b, c, TieOwner::TopLeft),
                                edgeFunction(c, a, TieOwner::TopLeft)};
  const int64_t left = int64_t{pixel.x} * kSubpixelOne * scale, top = int64_t{pixel.y} * kSubpixelOne * scale;
  uint32_t covered = 0;
  for (const SubpixelPosition offset : points.offsets) {
    const int64_t x = left + offset.x, y = top + offset.y;
    covered += edges[0].covers(x, y) && edges[1].covers(x, y) && edges[2].covers(x, y) ? 1u : 0u;
  }
  return covered;
}

GrayImage resampleBox(const GrayImage& fine, int32_t n) {
  GrayImage coarse(fine.width / n, fine.height / n);
  for (int32_t y = 0; y < coarse.height * n; ++y) {
    for (int32_t x = 0; x < coarse.width * n; ++x) coarse.at(x / n, y / n) += fine.at(x, y);
  }
  for (double& value : coarse.value) value /= static_cast<double>(n) * n;
  return coarse;
}

}  // namespace rasterdiff::rasterizer
