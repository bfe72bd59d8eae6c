// One draw of a scene file: its own vertices (read_positions.cpp) and what belongs to them, or a mesh.
#include <algorithm>
#include <array>
#include <cmath>

#include "scene/file/read_scene.hpp"
#include "scene/mesh/obj.hpp"

namespace rasterdiff {
namespace {

/// Each vertex has a number or an array of 1 to `most` numbers, all alike; `count` is how many.
bool readArrays(Reader& reader, const JsonValue& value, std::string_view what, uint32_t most, bool allowNonFinite,
                uint32_t& count, std::vector<float>& out) {
  if (!reader.array(value, what)) return false;
  JsonValue vertex = value.first();
  for (uint32_t i = 0; i < value.size(); ++i, vertex = vertex.next()) {
    const bool isArray = vertex.kind() == JsonKind::Array;
    const uint32_t components = isArray ? vertex.size() : 1;
    if (components < 1 || components > most) {
      return reader.fail(vertex, fmt::format("{} of {} components", what, components), fmt::format("1 to {}", most));
    }
    if (i == 0) count = components;
    if (components != count) {
      return reader.fail(vertex, fmt::format("{} components where the first vertex has {}", components, count));
    }
    JsonValue number = isArray ? vertex.first() : vertex;
    for (uint32_t c = 0; c < components; ++c, number = number.next()) {
      if (!reader.float32(number, out.emplace_back(), allowNonFinite)) return false;
    }
  }
  return true;
}

bool readOffset(Reader& reader, const JsonValue& varying, Varying& out) {
  const auto offset = varying.member("offset");
  const bool asked = out.interpolation == Interpolation::offset;
  if (!offset) return !asked || reader.fail(varying, "varying without 'offset'", "[x, y] in pixels from the centre");
  if (!asked) return reader.fail(*offset, "an offset without it as interpolation", "set \"interpolation\": \"offset\"");
  if (!reader.array(*offset, "offset")) return false;
  if (offset->size() != 2) return reader.fail(*offset, fmt::format("an offset of {} numbers", offset->size()), "[x, y]");
  return reader.float32(offset->first(), out.offsetX) && reader.float32(offset->first().next(), out.offsetY);
}

bool readVarying(Reader& reader, const JsonValue& value, bool ofMesh, bool allowNonFinite, Varying& varying) {
  static constexpr std::array<std::string_view, 4> kFields{"name", "interpolation", "offset", "values"};
  if (!reader.object(value, "varying", kFields, {"name"})) return false;
  if (!reader.text(*value.member("name"), varying.name)) return false;
  if (const auto v = value.member("interpolation");
      v && !reader.enumerant(*v, "interpolation", varying.interpolation)) {
    return false;
  }
  if (!readOffset(reader, value, varying)) return false;
  const auto values = value.member("values");
  if (!ofMesh) {
    return values ? readArrays(reader, *values, "a value", 4, allowNonFinite, varying.components, varying.values)
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

/// In range already: pixels are those of this viewport.
bool readViewportIndex(Reader& reader, const JsonValue& draw, const DrawContext& context, Draw& out) {
  const auto value = draw.member("viewportIndex");
  if (!value) return true;
  if (!reader.unsigned32(*value, out.viewportIndex)) return false;
  const size_t viewports = 1 + context.scene.furtherViewports.size();
  return out.viewportIndex < viewports ||
         reader.fail(*value, fmt::format("viewport {} but only {}", out.viewportIndex, viewports),
                     "0 is viewport, 1 the first of furtherViewports");
}

bool readPointSizes(Reader& reader, const JsonValue& draw, Draw& out) {
  const auto value = draw.member("pointSizes");
  if (!value) return true;
  if (!reader.array(*value, "pointSizes")) return false;
  if (value->size() == 0) return reader.fail(*value, "no sizes", "one for every position, or leave pointSizes out");
  JsonValue size = value->first();
  for (uint32_t i = 0; i < value->size(); ++i, size = size.next()) {
    if (!reader.float32(size, out.pointSizes.emplace_back())) return false;
  }
  return true;
}

bool readDistances(Reader& reader, const JsonValue& draw, bool allowNonFinite, Draw& out) {
  if (const auto v = draw.member("clipDistances");
      v && !readArrays(reader, *v, "distances", kMaxDistances, allowNonFinite, out.clipDistanceCount,
                       out.clipDistances)) {
    return false;
  }
  const auto v = draw.member("cullDistances");
  return !v || readArrays(reader, *v, "distances", kMaxDistances, allowNonFinite, out.cullDistanceCount,
                          out.cullDistances);
}

}  // namespace

bool readDraw(Reader& reader, const JsonValue& value, const DrawContext& context, Draw& draw) {
  if (value.member("mesh")) return readMesh(reader, value, context, draw);
  static constexpr std::array<std::string_view, 10> kFields{"positions",  "space",         "indices",       "varyings",
                                                            "pointSizes", "clipDistances", "cullDistances", "mesh",
                                                            "transform",  "viewportIndex"};
  if (!reader.object(value, "draw", kFields, {"positions"})) return false;
  if (const auto v = value.member("transform"))
    return reader.fail(*v, "'transform' without 'mesh'", "only meshes are transformed");
  if (!readViewportIndex(reader, value, context, draw) || !readPositions(reader, value, context, draw)) return false;
  if (const auto v = value.member("indices")) {
    if (!reader.array(*v, "indices")) return false;
    draw.indices.emplace(v->size());
    JsonValue index = v->first();
    for (uint32_t& out : *draw.indices) {
      if (!reader.unsigned32(index, out)) return false;
      index = index.next();
    }
  }
  return readPointSizes(reader, value, draw) && readDistances(reader, value, context.scene.allowNonFinite, draw) &&
         readVaryings(reader, value, false, context.scene.allowNonFinite, draw.varyings);
}

}  // namespace rasterdiff
