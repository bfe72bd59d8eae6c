// Bands of rows whose planes stay in a core's cache, and which triangles reach which of them.
#pragma once

#include <vector>

#include "rasterizer/kernels/value_view.hpp"

namespace rasterdiff::rasterizer {

/// Rows that are best drawn at a time, a multiple of 8: all of the target's where bands would gain nothing. Depends on what is drawn, but
/// no choice changes what comes out.
[[nodiscard]] uint32_t nearRows(const ValueTriangles& triangles, const ValueTarget& target);

/// Means over some of the triangles, evenly spread; pixels.
struct MeanShape {
  double area = 0, height = 0;
};
[[nodiscard]] MeanShape meanShape(std::span<const SnappedTriangle> triangles);

/// For bands of `rows` rows from firstRow to endRow, the places of the triangles that may touch each, in `order`: places of all triangles,
/// or none, for their own.
class ValueBins {
 public:
  ValueBins(std::span<const SnappedTriangle> triangles, std::span<const uint32_t> order, uint32_t firstRow, uint32_t endRow, uint32_t rows);

  [[nodiscard]] size_t size() const { return starts_.size() - 1; }
  [[nodiscard]] DrawnList of(size_t band) const { return {places_.data() + starts_[band], starts_[band + 1] - starts_[band]}; }

 private:
  std::vector<size_t> starts_;  // of each band in places_, and the end
  std::vector<uint32_t> places_;
};

}  // namespace rasterdiff::rasterizer
