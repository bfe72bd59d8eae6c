// The screen transform and its inverse: scenes that are written in pixels become clip positions here, such that the
// viewport transform brings them back to the same pixels.
#pragma once

#include <glm/mat4x4.hpp>

#include "scene/scene.hpp"

namespace rasterdiff {

/// The lecture's screen transform for NDC with y up (15-362/662 lecture 4): reflect y, translate by (1, 1), scale by
/// (width / 2, height / 2). NDC to pixels.
[[nodiscard]] glm::dmat4 screenTransform(double width, double height);

/// A point in pixels; z is the depth before the viewport's depth range (z of clip space over w).
struct PixelPosition {
  double x = 0, y = 0, z = 0, w = 1;
};

/// The clip position whose x / w, y / w land on (x, y) under `viewport`: [vk:vertexpostproc-viewport] solved for the
/// NDC, in double, rounded to float32 once. Exact where the pixel is a multiple of 2^-k with |x| 2^k < 2^23 or so, the
/// viewport's size is a power of two and w is a power of two.
[[nodiscard]] ClipPosition clipFromPixels(const Viewport& viewport, const PixelPosition& position);

}  // namespace rasterdiff
