#include "scene/camera/look_at.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace rasterdiff {
namespace {

bool isFinite(const glm::dvec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

/// Scaled to largest component 1 first, so that neither 1e-200 nor 1e200 spoils the length.
/// Zero vectors stay zero.
glm::dvec3 unit(const glm::dvec3& v) {
  const double largest = std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
  if (largest == 0) return v;
  return glm::normalize(v / largest);
}

}  // namespace

Result<glm::dmat4> lookAt(const glm::dvec3& eye, const glm::dvec3& target, const glm::dvec3& up) {
  if (!isFinite(eye)) return fail(ErrorCode::BadInput, "eye", "the eye is not finite");
  if (!isFinite(target) || !isFinite(target - eye)) {
    return fail(ErrorCode::BadInput, "target", "the way from eye to target is not finite");
  }
  if (!isFinite(up)) return fail(ErrorCode::BadInput, "up", "up is not finite");
  const glm::dvec3 back = -unit(target - eye);
  if (back == glm::dvec3(0)) {
    return fail(ErrorCode::BadInput, "target", "eye and target are the same point", "move one of them");
  }
  // Gram-Schmidt: what is left of up without its part along the direction. Unit vectors that are closer to parallel
  // than this leave a remainder that is mostly rounding (2^-53 a component).
  constexpr double kParallel = 1e-9;
  const glm::dvec3 unitUp = unit(up);
  const glm::dvec3 rest = unitUp - glm::dot(unitUp, back) * back;
  if (glm::length(rest) < kParallel) {
    return fail(ErrorCode::BadInput, "up", "up is zero or parallel to the viewing direction",
                "choose an up that is not on the line from eye to target");
  }
  const glm::dvec3 y = glm::normalize(rest);
  const glm::dvec3 x = glm::cross(y, back);
  // Rows of the rotation are the camera's axes (the inverse of an orthonormal basis is its transpose).
  return glm::dmat4(glm::dvec4(x.x, y.x, back.x, 0), glm::dvec4(x.y, y.y, back.y, 0), glm::dvec4(x.z, y.z, back.z, 0),
                    glm::dvec4(-glm::dot(x, eye), -glm::dot(y, eye), -glm::dot(back, eye), 1));
}

}  // namespace rasterdiff
