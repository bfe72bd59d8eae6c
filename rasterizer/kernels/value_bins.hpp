// Bands of rows whose planes stay in a core's cache, and which triangles reach which of them.
#pragma once

#include <vector>

#include "rasterizer/kernels/value_view.hpp"

namespace rasterdiff::rasterizer {

/// Rows that are best drawn at a time, a multiple of 8: all of the target's where bands would gain nothing. Depends on what is drawn, but
/// no choice changes what comes out.
[[nodiscard]] uint32_t nearRows(const ValueTriangles& triangles, const ValueTarget& target);

/// For bands of `rows` rows from firstRow to endRow, the places of the triangles that may touch each, in order.
class ValueBins {
 public:
  ValueBins(std::span<const SnappedTriangle> triangles, uint32_t firstRow, uint32_t endRow, uint32_t rows);

  [[nodiscard]] size_t size() const { return starts_.size() - 1; }
  [[nodiscard]] DrawnList of(size_t band) const { return {places_.data() + starts_[band], starts_[band + 1] - starts_[band]}; }

 private:
  std::vector<size_t> starts_;  // of each band in places_, and the end
  std::vector<uint32_t> places_;
};

}  // namespace rasterdiff::rasterizer
