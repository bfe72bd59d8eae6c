// Small scenes made in code: a square target, and triangles in pixels.
#pragma once

#include <array>

#include "scene/camera/screen.hpp"
#include "scene/generators/prng.hpp"
#include "scene/scene.hpp"

namespace rasterdiff::harness {

inline constexpr uint32_t kSketchExtent = 32;  ///< pixels

class SceneSketch {
 public:
  SceneSketch(std::string name, uint32_t samples, uint32_t extent = kSketchExtent) {
    scene_.name = std::move(name);
    scene_.target.width = scene_.target.height = extent;
    scene_.target.samples = samples;
    scene_.viewport.width = scene_.viewport.height = static_cast<float>(extent);
    scene_.draws.emplace_back();
  }

  /// A viewport that reaches beyond the target, so that coordinates may be negative; its size stays a power of two.
  void widenViewport() {
    const auto extent = static_cast<float>(scene_.target.width);
    scene_.viewport.x = scene_.viewport.y = -extent;
    scene_.viewport.width = scene_.viewport.height = 4 * extent;
  }

  void triangle(const PixelPosition& a, const PixelPosition& b, const PixelPosition& c) {
    for (const PixelPosition& p : {a, b, c}) draw().positions.push_back(clipFromPixels(scene_.viewport, p));
  }
  void clipTriangle(const std::array<ClipPosition, 3>& corners) {
    draw().positions.insert(draw().positions.end(), corners.begin(), corners.end());
  }

  Scene& scene() { return scene_; }
  Draw& draw() { return scene_.draws.front(); }

 private:
  Scene scene_;
};

}  // namespace rasterdiff::harness
