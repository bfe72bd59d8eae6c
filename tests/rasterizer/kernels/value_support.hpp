// Triangles with values at their vertices, and targets to draw them into, for the tests of the value kernels.
#pragma once

#include <gtest/gtest.h>

#include <span>
#include <vector>

#include "every_target.hpp"
#include "kernel_families.hpp"
#include "rasterizer/kernels/value_kernel.hpp"

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

/// What `load` draws if each triangle is drawn alone, where nothing can hide it; or beside a triangle that is behind all of `cleared`.
inline ValueTarget drawnApart(const ValueLoad& load, const ValueTarget& cleared, std::span<const SnappedTriangle> beside = {}) {
  constexpr float kBehind = 2;
  ValueTarget apart = cleared;
  for (size_t t = 0; t < load.positions.size(); ++t) {
    ValueLoad one{{load.positions[t]}, {load.depth[3 * t], load.depth[3 * t + 1], load.depth[3 * t + 2]}, {}, {}, {}};
    one.positions.insert(one.positions.end(), beside.begin(), beside.end());
    one.depth.insert(one.depth.end(), 3 * beside.size(), kBehind);
    ValueTarget alone = cleared;
    drawValues(one.view(), alone);
    for (uint32_t y = 0; y < apart.height(); ++y)
      for (uint32_t s = 0; s < apart.samples(); ++s)
        for (size_t i = apart.index(0, y, s); i < apart.index(apart.width(), y, s); ++i) {
          if (alone.primitive[i] == 0 || !(alone.depth[i] < apart.depth[i])) continue;
          apart.depth[i] = alone.depth[i];
          apart.primitive[i] = static_cast<uint32_t>(t + 1);
          ++apart.count[i];
        }
  }
  return apart;
}

}  // namespace rasterdiff::rasterizer::testing
