// The words that the families are written in: a target, triangles in pixels, one value a vertex.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "scene/camera/screen.hpp"
#include "scene/scene.hpp"

namespace rasterdiff::harness::stability {

struct HardVertex {
  double x = 0, y = 0;  ///< pixels
  float value = 0;
  double w = 1, z = 0.5;
};

[[nodiscard]] inline Scene hardTarget(uint32_t width, uint32_t height) {
  Scene scene;
  scene.target.width = width;
  scene.target.height = height;
  scene.viewport.width = static_cast<float>(width);
  scene.viewport.height = static_cast<float>(height);
  Draw& draw = scene.draws.emplace_back();
  draw.varyings.push_back({.name = "value", .interpolation = Interpolation::smooth, .components = 1});
  return scene;
}

inline void addTriangle(Scene& scene, const std::array<HardVertex, 3>& triangle) {
  Draw& draw = scene.draws.front();
  for (const HardVertex& v : triangle) {
    draw.positions.push_back(clipFromPixels(scene.viewport, {v.x, v.y, v.z, v.w}));
    draw.varyings[0].values.push_back(v.value);
  }
}

/// In clip space.
inline void addClipTriangle(Scene& scene, const std::array<ClipPosition, 3>& triangle, const std::array<float, 3>& values) {
  Draw& draw = scene.draws.front();
  draw.positions.insert(draw.positions.end(), triangle.begin(), triangle.end());
  draw.varyings[0].values.insert(draw.varyings[0].values.end(), values.begin(), values.end());
}

/// 1, 10, 100 … up to 10^last.
[[nodiscard]] inline std::vector<double> decades(int first, int last) {
  std::vector<double> values;
  for (int k = first; k <= last; ++k) values.push_back(std::stod("1e" + std::to_string(k)));
  return values;
}

}  // namespace rasterdiff::harness::stability
