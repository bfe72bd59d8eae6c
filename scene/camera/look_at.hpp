// World space to camera space: where the camera stands and looks. The camera is at the origin, looks down -z, x is
// right and y is up. What it sees of that space is the projection's business.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "scene/result.hpp"

namespace rasterdiff {

/// Rigid transform: translate by -eye, then rotate into the basis that Gram-Schmidt makes of the viewing direction and
/// `up` (15-362/662 lecture 4, "camera example"). World units.
/// Error (BadInput, `where` is "eye", "target" or "up"): a number that is not finite, eye == target, or `up` zero or
/// parallel to the direction.
[[nodiscard]] Result<glm::dmat4> lookAt(const glm::dvec3& eye, const glm::dvec3& target, const glm::dvec3& up);

}  // namespace rasterdiff
