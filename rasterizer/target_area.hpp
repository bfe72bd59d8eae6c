// The pixels a scene can write: the target cut by the scissor. [vk:fragops-scissor]
#pragma once

#include <algorithm>

#include "rasterizer/deliberate_error.hpp"
#include "scene/scene.hpp"

namespace rasterdiff::rasterizer {

/// left <= x < right, top <= y < bottom.
struct PixelArea {
  int32_t left = 0, top = 0, right = 0, bottom = 0;
  [[nodiscard]] bool contains(int32_t x, int32_t y) const { return x >= left && x < right && y >= top && y < bottom; }
};

[[nodiscard]] inline PixelArea wholeTarget(const Scene& scene) {
  return {0, 0, static_cast<int32_t>(scene.target.width), static_cast<int32_t>(scene.target.height)};
}

[[nodiscard]] inline const Viewport& viewportOf(const Scene& scene, uint32_t index) {
  return index == 0 ? scene.viewport : scene.furtherViewports[index - 1].viewport;
}

/// Is viewport `index` the whole target with depths 0 to 1?
[[nodiscard]] inline bool isWholeTarget(const Scene& scene, uint32_t index) {
  return viewportOf(scene, index) == Viewport{0, 0, static_cast<float>(scene.target.width), static_cast<float>(scene.target.height), 0, 1};
}

/// For draws through viewport `index`: each viewport has its own scissor.
[[nodiscard]] inline PixelArea targetArea(const Scene& scene, uint32_t index, DeliberateError error = DeliberateError::None) {
  PixelArea area = wholeTarget(scene);
  const std::optional<Rect2D>& given = index == 0 ? scene.scissor : scene.furtherViewports[index - 1].scissor;
  if (!given) return area;
  const Rect2D& scissor = *given;
  const int64_t widened = error == DeliberateError::ScissorOffByOne ? 1 : 0;
  area.left = std::max(area.left, scissor.x);
  area.top = std::max(area.top, scissor.y);
  area.right = static_cast<int32_t>(std::min<int64_t>(area.right, int64_t{scissor.x} + scissor.width + widened));
  area.bottom = static_cast<int32_t>(std::min<int64_t>(area.bottom, int64_t{scissor.y} + scissor.height));
  return area;
}

}  // namespace rasterdiff::rasterizer
