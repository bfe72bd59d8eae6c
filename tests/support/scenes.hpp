// Small scenes for tests: triangles given in pixels on a square target whose viewport is exact in float32.
#pragma once

#include <array>
#include <vector>

#include "rasterizer/render.hpp"
#include "scene/scene.hpp"

namespace rasterdiff::testing {

struct Point {
  double x, y, z = 0, w = 1;
};

/// Clip position of a point in pixels of a square target with `extent` (a power of two) pixels a side.
inline ClipPosition fromPixels(const Point& p, uint32_t extent) {
  const double half = extent / 2.0;
  return {static_cast<float>((p.x / half - 1) * p.w), static_cast<float>((p.y / half - 1) * p.w),
          static_cast<float>(p.z * p.w), static_cast<float>(p.w)};
}

inline Scene sceneOf(const std::vector<Point>& points, uint32_t extent = 8, uint32_t samples = 1) {
  Scene scene;
  scene.name = "test";
  scene.target.width = scene.target.height = extent;
  scene.target.samples = samples;
  scene.viewport = {0, 0, static_cast<float>(extent), static_cast<float>(extent), 0, 1};
  Draw draw;
  for (const Point& point : points) draw.positions.push_back(fromPixels(point, extent));
  scene.draws.push_back(std::move(draw));
  return scene;
}

inline rasterizer::Rules referenceRules() { return *rasterizer::Rules::profile("reference", Limits{}); }

}  // namespace rasterdiff::testing
