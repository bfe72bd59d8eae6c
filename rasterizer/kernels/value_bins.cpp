// Which triangles reach which band, by counting first.
#include "rasterizer/kernels/value_bins.hpp"

#include <algorithm>
#include <cmath>

namespace rasterdiff::rasterizer {

MeanShape meanShape(std::span<const SnappedTriangle> triangles) {
  constexpr size_t kLooked = 256;
  const size_t step = std::max(triangles.size() / kLooked, size_t{1});
  double area = 0, height = 0, looked = 0;
  for (size_t i = 0; i < triangles.size(); i += step, ++looked) {
    const auto& v = triangles[i].v;
    const auto difference = [](int32_t a, int32_t b) { return static_cast<double>(a) - static_cast<double>(b); };
    const double x1 = difference(v[1].x, v[0].x), y1 = difference(v[1].y, v[0].y), x2 = difference(v[2].x, v[0].x), y2 = difference(v[2].y, v[0].y);
    area += std::fabs(x1 * y2 - x2 * y1) / (2.0 * kSubpixelOne * kSubpixelOne);
    height += (std::max({0.0, y1, y2}) - std::min({0.0, y1, y2})) / kSubpixelOne;
  }
  return looked > 0 ? MeanShape{area / looked, height / looked} : MeanShape{};
}

// Measured on a core with 1 MB of second-level cache and 32 MB behind it: planes that come from there cost little, planes that do not
// cost up to two thirds of the time. Small triangles pay more for bins, and gain nothing where few lie upon one another; high ones are
// set up once a band.
uint32_t nearRows(const ValueTriangles& triangles, const ValueTarget& target) {
  constexpr size_t kBandBytes = size_t{2} << 20, kHighBandBytes = size_t{8} << 20, kManyBytes = size_t{24} << 20, kSomeBytes = size_t{12} << 20;
  constexpr size_t kSomeHighBytes = size_t{20} << 20;
  constexpr double kSmallArea = 100, kHigh = 256, kFewLayers = 0.4;
  const ValueNeeds& needs = target.needs();
  const size_t rowBytes = sizeof(float) * target.stride() * target.samples() * (size_t{needs.primitive} + size_t{needs.count} + size_t{needs.depth});
  const uint32_t all = (target.height() + 7) / 8 * 8;
  if (rowBytes * target.height() < kSomeBytes) return all;
  const MeanShape mean = meanShape(triangles.positions);
  const bool high = mean.height > kHigh;
  if (high && rowBytes * target.height() < kSomeHighBytes) return all;
  const double pixels = static_cast<double>(target.width()) * target.height();
  if (mean.area * static_cast<double>(triangles.positions.size()) < kFewLayers * pixels) return all;
  if (rowBytes * target.height() < kManyBytes && mean.area < kSmallArea) return all;
  return static_cast<uint32_t>(std::max((high ? kHighBandBytes : kBandBytes) / rowBytes / 8, size_t{1})) * 8;
}

ValueBins::ValueBins(std::span<const SnappedTriangle> triangles, std::span<const uint32_t> order, uint32_t firstRow, uint32_t endRow, uint32_t rows) {
  struct Bands {
    uint16_t first, last;  // none: first > last
  };
  const size_t size = (endRow - firstRow + rows - 1) / rows;
  std::vector<Bands> bands(triangles.size());
  std::vector<uint16_t> bandOf(endRow - firstRow);
  for (uint32_t row = 0; row < bandOf.size(); ++row) bandOf[row] = static_cast<uint16_t>(row / rows);
  std::vector<size_t> ends(size + 1);  // first how many triangles begin in a band less those that ended above it
  const auto top = static_cast<int32_t>(firstRow), bottom = static_cast<int32_t>(endRow);
  for (size_t i = 0; i < triangles.size(); ++i) {
    const auto& v = triangles[i].v;
    // Samples of row r are at 256 r to 256 r + 255.
    const int32_t first = std::max(std::min({v[0].y, v[1].y, v[2].y}) >> kSubpixelBits, top);
    const int32_t last = std::min(std::max({v[0].y, v[1].y, v[2].y}) >> kSubpixelBits, bottom - 1);
    const bool none = first > last;
    bands[i].first = none ? 1 : bandOf[static_cast<size_t>(first - top)];
    bands[i].last = none ? 0 : bandOf[static_cast<size_t>(last - top)];
    ends[bands[i].first] += none ? 0 : 1, ends[bands[i].last + size_t{1}] -= none ? 0 : 1;
  }
  starts_.resize(size + 1);
  for (size_t k = 0, open = 0; k < size; ++k) open += ends[k], starts_[k + 1] = starts_[k] + open;
  places_.resize(starts_[size]);
  std::vector<size_t> to(starts_.begin(), starts_.end() - 1);
  for (size_t n = 0; n < triangles.size(); ++n) {
    const size_t i = order.empty() ? n : order[n];
    for (size_t k = bands[i].first; k <= bands[i].last; ++k) places_[to[k]++] = static_cast<uint32_t>(i);
  }
}

}  // namespace rasterdiff::rasterizer
