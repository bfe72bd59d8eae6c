#include "scene/camera/screen.hpp"

#include <glm/ext/matrix_transform.hpp>

namespace rasterdiff {

glm::dmat4 screenTransform(double width, double height) {
  const glm::dmat4 identity(1);
  const glm::dmat4 reflect = glm::scale(identity, glm::dvec3(1, -1, 1));
  const glm::dmat4 translate = glm::translate(identity, glm::dvec3(1, 1, 0));
  const glm::dmat4 scale = glm::scale(identity, glm::dvec3(width / 2, height / 2, 1));
  return scale * translate * reflect;
}

ClipPosition clipFromPixels(const Viewport& viewport, const PixelPosition& p) {
  const double halfWidth = double{viewport.width} / 2, halfHeight = double{viewport.height} / 2;
  const double x = (p.x - (viewport.x + halfWidth)) / halfWidth;
  const double y = (p.y - (viewport.y + halfHeight)) / halfHeight;
  return {static_cast<float>(x * p.w), static_cast<float>(y * p.w), static_cast<float>(p.z * p.w),
          static_cast<float>(p.w)};
}

}  // namespace rasterdiff
