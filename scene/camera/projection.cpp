#include "scene/camera/projection.hpp"

#include <array>
#include <cmath>
#include <glm/ext/matrix_clip_space.hpp>
#include <numbers>
#include <utility>

namespace rasterdiff {
namespace {

Result<void> checkBox(const ViewBox& box) {
  const std::array<std::pair<const char*, double>, 6> fields{{{"left", box.left},
                                                              {"right", box.right},
                                                              {"bottom", box.bottom},
                                                              {"top", box.top},
                                                              {"near", box.near},
                                                              {"far", box.far}}};
  for (const auto& [name, value] : fields) {
    if (!std::isfinite(value)) return fail(ErrorCode::BadInput, name, std::string(name) + " is not finite");
  }
  if (box.left == box.right) return fail(ErrorCode::BadInput, "right", "left and right are equal: nothing is seen");
  if (box.bottom == box.top) return fail(ErrorCode::BadInput, "top", "bottom and top are equal: nothing is seen");
  if (box.near == box.far) return fail(ErrorCode::BadInput, "far", "near and far are equal: nothing is seen");
  return {};
}

Result<void> checkDistances(double near, double far) {
  if (!(near > 0 && std::isfinite(near))) {
    return fail(ErrorCode::BadInput, "near", "near is not a positive distance", "for example 0.1");
  }
  if (!(far > 0 && std::isfinite(far))) {
    return fail(ErrorCode::BadInput, "far", "far is not a positive distance", "for example 100");
  }
  return {};
}

/// [vk:vertexpostproc-coord-transform] y of Vulkan's NDC points down.
Result<glm::dmat4> withConvention(glm::dmat4 matrix, Convention convention) {
  if (convention == Convention::Vulkan) {
    for (int column = 0; column < 4; ++column) matrix[column][1] = 0 - matrix[column][1];  // 0 - 0 is +0
  }
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) {
      if (!std::isfinite(matrix[column][row])) {
        return fail(ErrorCode::BadInput, "", "the projection overflows double precision", "use a less extreme view");
      }
    }
  }
  return matrix;
}

}  // namespace

Result<glm::dmat4> perspective(const ViewBox& box, Convention convention) {
  if (auto ok = checkBox(box); !ok) return tl::unexpected(ok.error());
  if (auto ok = checkDistances(box.near, box.far); !ok) return tl::unexpected(ok.error());
  const auto make = convention == Convention::Vulkan ? glm::frustumRH_ZO<double> : glm::frustumRH_NO<double>;
  return withConvention(make(box.left, box.right, box.bottom, box.top, box.near, box.far), convention);
}

Result<glm::dmat4> perspective(double fovY, double aspect, double near, double far, Convention convention) {
  if (!(fovY > 0 && fovY < 180)) {
    return fail(ErrorCode::BadInput, "fovY", "fovY is not between 0 and 180 degrees", "for example 60");
  }
  if (!(aspect > 0 && std::isfinite(aspect))) {
    return fail(ErrorCode::BadInput, "aspect", "aspect (width / height) is not positive");
  }
  if (auto ok = checkDistances(near, far); !ok) return tl::unexpected(ok.error());
  const double top = near * std::tan(fovY * std::numbers::pi / 360), right = top * aspect;
  return perspective(ViewBox{-right, right, -top, top, near, far}, convention);
}

Result<glm::dmat4> orthographic(const ViewBox& box, Convention convention) {
  if (auto ok = checkBox(box); !ok) return tl::unexpected(ok.error());
  const auto make = convention == Convention::Vulkan ? glm::orthoRH_ZO<double> : glm::orthoRH_NO<double>;
  return withConvention(make(box.left, box.right, box.bottom, box.top, box.near, box.far), convention);
}

ClipPosition toClip(const glm::dmat4& matrix, double x, double y, double z) {
  const glm::dvec4 clip = matrix * glm::dvec4(x, y, z, 1);
  return {static_cast<float>(clip.x), static_cast<float>(clip.y), static_cast<float>(clip.z),
          static_cast<float>(clip.w)};
}

}  // namespace rasterdiff
