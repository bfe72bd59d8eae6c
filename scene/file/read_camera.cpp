// The camera of a scene file: look-at, then perspective or orthographic.
#include <array>

#include "scene/camera/look_at.hpp"
#include "scene/camera/projection.hpp"
#include "scene/file/read_scene.hpp"

namespace rasterdiff {
namespace {

/// An error of scene/camera names a field of `object`: report it there, or at the object.
bool cameraFail(Reader& reader, const JsonValue& object, const Error& error) {
  return reader.fail(object.member(error.where).value_or(object), error.what, error.hint);
}

bool point(Reader& reader, const JsonValue& object, std::string_view field, glm::dvec3& out) {
  const auto value = object.member(field);
  if (!value) return true;
  std::vector<double> numbers;
  if (!reader.numbers(*value, field, 3, 3, numbers)) return false;
  out = {numbers[0], numbers[1], numbers[2]};
  return true;
}

bool readLookAt(Reader& reader, const JsonValue& value, glm::dmat4& view) {
  static constexpr std::array<std::string_view, 3> kFields{"eye", "target", "up"};
  if (!reader.object(value, "lookAt", kFields, {"eye", "target"})) return false;
  glm::dvec3 eye(0), target(0), up(0, 1, 0);
  if (!point(reader, value, "eye", eye) || !point(reader, value, "target", target) || !point(reader, value, "up", up)) {
    return false;
  }
  const Result<glm::dmat4> result = lookAt(eye, target, up);
  if (!result) return cameraFail(reader, value, result.error());
  view = *result;
  return true;
}

bool optionalNumber(Reader& reader, const JsonValue& object, std::string_view field, double& out) {
  const auto value = object.member(field);
  return !value || reader.number(*value, out);
}

bool readConvention(Reader& reader, const JsonValue& object, bool negativeOneToOne, Convention& convention) {
  const auto value = object.member("convention");
  if (!value) return true;
  std::string name;
  if (!reader.text(*value, name)) return false;
  static constexpr std::array<std::string_view, 2> kNames{"vulkan", "opengl"};
  if (name != kNames[0] && name != kNames[1]) {
    return reader.fail(*value, "'" + name + "' is no convention", Reader::suggest(name, kNames));
  }
  convention = name == kNames[0] ? Convention::Vulkan : Convention::OpenGL;
  if (convention == Convention::OpenGL && !negativeOneToOne) {
    return reader.fail(*value, "OpenGL's depth -1 .. 1 does not fit the view volume 0 <= z <= w",
                       "set state.negativeOneToOne to true");
  }
  return true;
}

bool readBox(Reader& reader, const JsonValue& value, ViewBox& box) {
  return optionalNumber(reader, value, "left", box.left) && optionalNumber(reader, value, "right", box.right) &&
         optionalNumber(reader, value, "bottom", box.bottom) && optionalNumber(reader, value, "top", box.top) &&
         optionalNumber(reader, value, "near", box.near) && optionalNumber(reader, value, "far", box.far);
}

bool readPerspective(Reader& reader, const JsonValue& value, double aspect, bool negativeOneToOne, glm::dmat4& matrix) {
  static constexpr std::array<std::string_view, 9> kFields{"fovY", "aspect", "left", "right",     "bottom",
                                                           "top",  "near",   "far",  "convention"};
  if (!reader.object(value, "perspective", kFields, {"near", "far"})) return false;
  Convention convention = Convention::Vulkan;
  if (!readConvention(reader, value, negativeOneToOne, convention)) return false;
  const bool byAngle = value.member("fovY").has_value();
  for (std::string_view side : {"left", "right", "bottom", "top"}) {
    const auto v = value.member(side);
    if (byAngle && v) return reader.fail(*v, "both fovY and the sides of a frustum", "give one of them");
    if (!byAngle && !v)
      return reader.fail(value, "perspective without 'fovY' and without '" + std::string(side) + "'",
                         "give fovY, or left, right, bottom and top");
  }
  if (const auto v = value.member("aspect"); v && !byAngle) {
    return reader.fail(*v, "'aspect' without 'fovY'", "a frustum has its aspect in its sides");
  }
  ViewBox box;
  double fovY = 0;
  if (!readBox(reader, value, box) || !optionalNumber(reader, value, "fovY", fovY) ||
      !optionalNumber(reader, value, "aspect", aspect)) {
    return false;
  }
  const Result<glm::dmat4> result =
      byAngle ? perspective(fovY, aspect, box.near, box.far, convention) : perspective(box, convention);
  if (!result) return cameraFail(reader, value, result.error());
  matrix = *result;
  return true;
}

bool readOrthographic(Reader& reader, const JsonValue& value, bool negativeOneToOne, glm::dmat4& matrix) {
  static constexpr std::array<std::string_view, 7> kFields{"left", "right", "bottom",    "top",
                                                           "near", "far",   "convention"};
  if (!reader.object(value, "orthographic", kFields, {"left", "right", "bottom", "top", "near", "far"})) return false;
  Convention convention = Convention::Vulkan;
  ViewBox box;
  if (!readConvention(reader, value, negativeOneToOne, convention) || !readBox(reader, value, box)) return false;
  const Result<glm::dmat4> result = orthographic(box, convention);
  if (!result) return cameraFail(reader, value, result.error());
  matrix = *result;
  return true;
}

}  // namespace

bool readCamera(Reader& reader, const JsonValue& value, double aspect, bool negativeOneToOne,
                glm::dmat4& clipFromWorld) {
  static constexpr std::array<std::string_view, 3> kFields{"lookAt", "perspective", "orthographic"};
  if (!reader.object(value, "camera", kFields)) return false;
  const auto wide = value.member("perspective"), parallel = value.member("orthographic");
  if (wide.has_value() == parallel.has_value()) {
    return reader.fail(value, wide ? "a camera with two projections" : "a camera without a projection",
                       "give one of perspective, orthographic");
  }
  glm::dmat4 view(1), projection(1);
  if (const auto v = value.member("lookAt"); v && !readLookAt(reader, *v, view)) return false;
  if (wide ? !readPerspective(reader, *wide, aspect, negativeOneToOne, projection)
           : !readOrthographic(reader, *parallel, negativeOneToOne, projection)) {
    return false;
  }
  clipFromWorld = projection * view;
  return true;
}

}  // namespace rasterdiff
