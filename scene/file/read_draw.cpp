// One draw of a scene file: its own vertices in clip, world or pixel space, or a mesh.
#include <algorithm>
#include <array>
#include <cmath>

#include "scene/camera/projection.hpp"
#include "scene/camera/screen.hpp"
#include "scene/file/read_scene.hpp"
#include "scene/mesh/obj.hpp"

namespace rasterdiff {
namespace {

enum class Space { Clip, World, Pixels };

bool readSpace(Reader& reader, const JsonValue& draw, const DrawContext& context, Space& space) {
  const auto value = draw.member("space");
  if (!value) return true;
  static constexpr std::array<std::string_view, 3> kNames{"clip", "world", "pixels"};
  std::string name;
  if (!reader.text(*value, name)) return false;
  const auto found = std::find(kNames.begin(), kNames.end(), name);
  if (found == kNames.end()) return reader.fail(*value, "'" + name + "' is no space", Reader::suggest(name, kNames));
  space = static_cast<Space>(found - kNames.begin());
  if (space == Space::World && !context.clipFromWorld) {
    return reader.fail(*value, "world space without a camera", "add a camera to the scene");
  }
  return true;
}

bool clipPosition(Reader& reader, const JsonValue& value, bool allowNonFinite, ClipPosition& out) {
  if (!reader.array(value, "a position")) return false;
  if (value.size() != 4) {
    return reader.fail(value, fmt::format("a position of {} numbers", value.size()), "[x, y, z, w] in clip space");
  }
  JsonValue number = value.first();
  for (float* to : {&out.x, &out.y, &out.z, &out.w}) {
    if (!reader.float32(number, *to, allowNonFinite)) return false;
    number = number.next();
  }
  return true;
}

bool readPositions(Reader& reader, const JsonValue& value, Space space, const DrawContext& context, Draw& draw) {
  if (!reader.array(value, "positions")) return false;
  draw.positions.resize(value.size());
  JsonValue vertex = value.first();
  std::vector<double> n;
  for (ClipPosition& position : draw.positions) {
    switch (space) {
      case Space::Clip:
        if (!clipPosition(reader, vertex, context.scene.allowNonFinite, position)) return false;
        break;
      case Space::World:
        if (!reader.numbers(vertex, "a position in world space", 3, 3, n)) return false;
        position = toClip(*context.clipFromWorld, n[0], n[1], n[2]);
        break;
      case Space::Pixels:
        if (!reader.numbers(vertex, "a position in pixels", 2, 4, n)) return false;
        position =
            clipFromPixels(context.scene.viewport, {n[0], n[1], n.size() > 2 ? n[2] : 0, n.size() > 3 ? n[3] : 1});
        break;
    }
    vertex = vertex.next();
  }
  return true;
}

/// Each vertex's value is a number or an array of 1 to 4 numbers, all alike.
bool readValues(Reader& reader, const JsonValue& value, bool allowNonFinite, Varying& varying) {
  if (!reader.array(value, "values")) return false;
  JsonValue vertex = value.first();
  for (uint32_t i = 0; i < value.size(); ++i, vertex = vertex.next()) {
    const bool isArray = vertex.kind() == JsonKind::Array;
    const uint32_t components = isArray ? vertex.size() : 1;
    if (components < 1 || components > 4) {
      return reader.fail(vertex, fmt::format("a value of {} components", components), "1 to 4");
    }
    if (i == 0) varying.components = components;
    if (components != varying.components) {
      return reader.fail(vertex,
                         fmt::format("{} components where the first vertex has {}", components, varying.components));
    }
    JsonValue number = isArray ? vertex.first() : vertex;
    for (uint32_t c = 0; c < components; ++c, number = number.next()) {
      if (!reader.float32(number, varying.values.emplace_back(), allowNonFinite)) return false;
    }
  }
  return true;
}

bool readVarying(Reader& reader, const JsonValue& value, bool ofMesh, bool allowNonFinite, Varying& varying) {
  static constexpr std::array<std::string_view, 3> kFields{"name", "interpolation", "values"};
  if (!reader.object(value, "varying", kFields, {"name"})) return false;
  if (!reader.text(*value.member("name"), varying.name)) return false;
  if (const auto v = value.member("interpolation");
      v && !reader.enumerant(*v, "interpolation", varying.interpolation)) {
    return false;
  }
  const auto values = value.member("values");
  if (!ofMesh) {
    return values ? readValues(reader, *values, allowNonFinite, varying)
                  : reader.fail(value, "varying without 'values'", "one value for every position");
  }
  if (values) return reader.fail(*values, "a mesh brings its own values", "leave 'values' out");
  if (std::find(kMeshVaryings.begin(), kMeshVaryings.end(), varying.name) == kMeshVaryings.end()) {
    return reader.fail(*value.member("name"), fmt::format("a mesh has no '{}'", varying.name),
                       Reader::suggest(varying.name, kMeshVaryings));
  }
  return true;
}

bool readVaryings(Reader& reader, const JsonValue& draw, bool ofMesh, bool allowNonFinite, std::vector<Varying>& out) {
  const auto value = draw.member("varyings");
  if (!value) return true;
  if (!reader.array(*value, "varyings")) return false;
  if (value->size() > kMaxVaryings) {
    return reader.fail(*value, fmt::format("{} varyings; at most {}", value->size(), kMaxVaryings));
  }
  JsonValue element = value->first();
  for (uint32_t i = 0; i < value->size(); ++i, element = element.next()) {
    if (!readVarying(reader, element, ofMesh, allowNonFinite, out.emplace_back())) return false;
  }
  return true;
}

bool readTransform(Reader& reader, const JsonValue& draw, glm::dmat4& transform) {
  const auto value = draw.member("transform");
  if (!value) return true;
  std::vector<double> n;
  if (!reader.numbers(*value, "a transform", 16, 16, n)) return false;
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) transform[column][row] = n[static_cast<size_t>(4 * row + column)];
  }
  return true;
}

bool readMesh(Reader& reader, const JsonValue& value, const DrawContext& context, Draw& draw) {
  static constexpr std::array<std::string_view, 3> kFields{"mesh", "transform", "varyings"};
  if (!reader.object(value, "mesh draw", kFields)) return false;
  const JsonValue file = *value.member("mesh");
  std::string path;
  if (!reader.text(file, path)) return false;
  if (!context.clipFromWorld) return reader.fail(file, "a mesh without a camera", "add a camera to the scene");
  glm::dmat4 transform(1);
  std::vector<Varying> varyings;
  if (!readTransform(reader, value, transform) || !readVaryings(reader, value, true, false, varyings)) return false;
  if (!path.starts_with('/')) path = context.folder + path;
  const Result<Mesh> mesh = loadObj(path);
  if (!mesh) {
    const Error& e = mesh.error();
    return reader.fail(file.offset(), fmt::format("{}: {}", e.where, e.what), e.hint, e.code);
  }
  draw = meshDraw(*mesh, *context.clipFromWorld * transform, varyings);
  return true;
}

}  // namespace

bool readDraw(Reader& reader, const JsonValue& value, const DrawContext& context, Draw& draw) {
  if (value.member("mesh")) return readMesh(reader, value, context, draw);
  static constexpr std::array<std::string_view, 6> kFields{"positions", "space", "indices",
                                                           "varyings",  "mesh",  "transform"};
  if (!reader.object(value, "draw", kFields, {"positions"})) return false;
  if (const auto v = value.member("transform"))
    return reader.fail(*v, "'transform' without 'mesh'", "only meshes are transformed");
  Space space = Space::Clip;
  if (!readSpace(reader, value, context, space)) return false;
  if (!readPositions(reader, *value.member("positions"), space, context, draw)) return false;
  if (const auto v = value.member("indices")) {
    if (!reader.array(*v, "indices")) return false;
    draw.indices.emplace(v->size());
    JsonValue index = v->first();
    for (uint32_t& out : *draw.indices) {
      if (!reader.unsigned32(index, out)) return false;
      index = index.next();
    }
  }
  return readVaryings(reader, value, false, context.scene.allowNonFinite, draw.varyings);
}

}  // namespace rasterdiff
