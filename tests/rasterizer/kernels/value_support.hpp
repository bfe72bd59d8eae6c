// Triangles with values at their vertices, and targets to draw them into, for the tests of the value kernels.
#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "every_target.hpp"
#include "kernel_families.hpp"
#include "rasterizer/kernels/value_target.hpp"

namespace rasterdiff::rasterizer::testing {

/// Owns what ValueTriangles refers to.
struct ValueLoad {
  std::vector<SnappedTriangle> positions;
  std::vector<float> depth, reciprocalW, values;
  std::vector<ValueKind> kinds;
  ValueRows<float> carried = {};

  [[nodiscard]] ValueTriangles view() const { return {positions, depth, carried, kinds}; }
};

/// Depth in [0, 1), w in [1/8, 8], values in [-1, 1] for each of `kinds`.
inline ValueLoad makeLoad(std::vector<SnappedTriangle> positions, std::vector<ValueKind> kinds, Prng& random) {
  ValueLoad load;
  load.positions = std::move(positions);
  load.kinds = std::move(kinds);
  for (size_t i = 0; i < 3 * load.positions.size(); ++i) {
    load.depth.push_back(static_cast<float>(random.between(0.0, 0.999)));
    load.reciprocalW.push_back(1 / static_cast<float>(random.between(0.125, 8.0)));
    for (size_t c = 0; c < load.kinds.size(); ++c) load.values.push_back(static_cast<float>(random.between(-1.0, 1.0)));
  }
  load.carried = carriedValues(load.reciprocalW, load.values, load.kinds.size());
  return load;
}

}  // namespace rasterdiff::rasterizer::testing
