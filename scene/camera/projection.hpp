// Camera space to clip space: perspective by frustum or by field of view, and orthographic, for either depth
// convention. Division by w, viewport and screen belong to the rasterizer (scene/camera/screen.hpp has the inverse).
#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>

#include "scene/result.hpp"
#include "scene/spaces.hpp"

namespace rasterdiff {

/// What normalized device coordinates mean.
/// Vulkan: depth 0 (near) .. 1 (far), y points down, so the matrix negates y and a scene's up is up in the picture.
/// OpenGL: depth -1 .. 1, y points up; draw it with `negativeOneToOne` and a viewport of negative height.
enum class Convention : uint8_t { Vulkan, OpenGL };

/// The seen box (orthographic), or the near rectangle and distances of the seen frustum (perspective), in camera space:
/// left..right and bottom..top at z = -near; near and far are distances along -z.
struct ViewBox {
  double left = -1, right = 1, bottom = -1, top = 1, near = 0, far = 1;
};

/// Error (BadInput, `where` is the field): not finite, left == right, bottom == top, near == far, near or far <= 0.
[[nodiscard]] Result<glm::dmat4> perspective(const ViewBox& box, Convention convention);

/// `fovY` in degrees between 0 and 180 (both excluded); `aspect` is width / height.
[[nodiscard]] Result<glm::dmat4> perspective(double fovY, double aspect, double near, double far,
                                             Convention convention);

/// As perspective, except that near and far may be zero or negative.
[[nodiscard]] Result<glm::dmat4> orthographic(const ViewBox& box, Convention convention);

/// matrix · (x, y, z, 1) in double, rounded to float32 once.
[[nodiscard]] ClipPosition toClip(const glm::dmat4& matrix, double x, double y, double z);

}  // namespace rasterdiff
