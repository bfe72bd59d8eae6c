// Perspective division and viewport transform, in real numbers (doubles) and in the float32 of a driver.
// [vk:vertexpostproc-coord-transform] [vk:vertexpostproc-viewport]
#pragma once

#include "rasterizer/rules.hpp"
#include "scene/scene.hpp"

namespace rasterdiff::rasterizer {

/// One axis of the viewport transform: framebuffer = ndc · scale + offset, with offset = origin + centre kept as two
/// float32 numbers so that it is exact. // x_f = (p_x / 2) x_d + (x + p_x / 2)
struct ViewportAxis {
  double scale = 0, origin = 0, centre = 0;
  [[nodiscard]] double offset() const { return origin + centre; }
};

struct ViewportTransform {
  ViewportAxis x, y, z;
  double boundsUncertainty = 0;  ///< pixels by which the viewport's bounds may legally be moved (open rules)
};

/// Error-free for finite viewports: halving a float32 is exact. `bits` = viewportSubPixelBits.
[[nodiscard]] ViewportTransform viewportTransform(const Viewport& viewport, bool negativeOneToOne, uint32_t bits);

/// clip → framebuffer in doubles (relative error of a few 2^-53). w must not be 0.
[[nodiscard]] FramebufferPosition toFramebuffer(const double clip[4], const ViewportTransform& transform);

/// One coordinate as a float32 driver computes it. `origin` (0 or half a pixel) is subtracted from the viewport's offset.
/// [choice:viewport-arithmetic]
[[nodiscard]] float toFramebufferFloat(float coordinate, float w, const ViewportAxis& axis, ViewportArithmetic arithmetic,
                                       float origin = 0);

/// Bound on |float32 result - exact| in pixels, for any order of the few float32 operations a driver may choose:
/// reciprocal, two products, one sum and one subtraction of half a pixel, each within 2^-24 relative of its result.
/// Zero where every intermediate result is a float32 number anyway.
[[nodiscard]] double viewportArithmeticBound(float coordinate, float w, const ViewportAxis& axis);

}  // namespace rasterdiff::rasterizer
