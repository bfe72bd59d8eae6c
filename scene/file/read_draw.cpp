// One draw of a scene file: its own vertices (read_positions.cpp) and what belongs to them, or a mesh. Varyings are read
// by read_varyings.cpp, polygons by read_polygon.cpp.
#include <array>

#include "scene/file/read_scene.hpp"
#include "scene/mesh/obj.hpp"

namespace rasterdiff {
namespace {

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
  static constexpr std::array<std::string_view, 4> kFields{"mesh", "transform", "varyings", "shaderSampleMaskBits"};
  static constexpr OfferedVaryings kOffered{"a mesh", kMeshVaryings};
  if (!reader.object(value, "mesh draw", kFields)) return false;
  const JsonValue file = *value.member("mesh");
  std::string path;
  if (!reader.text(file, path)) return false;
  if (!context.clipFromWorld) return reader.fail(file, "a mesh without a camera", "add a camera to the scene");
  glm::dmat4 transform(1);
  std::vector<Varying> varyings;
  if (!readTransform(reader, value, transform) || !readVaryings(reader, value, &kOffered, false, varyings)) return false;
  if (!path.starts_with('/')) path = context.folder + path;
  const Result<Mesh> mesh = loadObj(path);
  if (!mesh) {
    const Error& e = mesh.error();
    return reader.fail(file.offset(), fmt::format("{}: {}", e.where, e.what), e.hint, e.code);
  }
  draw = meshDraw(*mesh, *context.clipFromWorld * transform, varyings);
  return true;
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
      v && !readVertexArrays(reader, *v, "distances", kMaxDistances, allowNonFinite, out.clipDistanceCount,
                       out.clipDistances)) {
    return false;
  }
  const auto v = draw.member("cullDistances");
  return !v || readVertexArrays(reader, *v, "distances", kMaxDistances, allowNonFinite, out.cullDistanceCount,
                          out.cullDistances);
}

}  // namespace

bool readViewportIndex(Reader& reader, const JsonValue& draw, const DrawContext& context, Draw& out) {
  const auto value = draw.member("viewportIndex");
  if (!value) return true;
  if (!reader.unsigned32(*value, out.viewportIndex)) return false;
  const size_t viewports = 1 + context.scene.furtherViewports.size();
  return out.viewportIndex < viewports ||
         reader.fail(*value, fmt::format("viewport {} but only {}", out.viewportIndex, viewports),
                     "0 is viewport, 1 the first of furtherViewports");
}

namespace {

/// A draw with its own vertices.
bool readVertices(Reader& reader, const JsonValue& value, const DrawContext& context, Draw& draw) {
  static constexpr std::array<std::string_view, 13> kFields{
      "positions",     "space", "indices",   "varyings",      "pointSizes", "clipDistances",
      "cullDistances", "mesh",  "transform", "viewportIndex", "svg",        "points",
      "shaderSampleMaskBits"};
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
         readVaryings(reader, value, nullptr, context.scene.allowNonFinite, draw.varyings);
}

}  // namespace

bool readDraw(Reader& reader, const JsonValue& value, const DrawContext& context, Draw& draw) {
  const bool polygon = value.member("svg") || value.member("points");
  const auto read = value.member("mesh") ? readMesh : polygon ? readPolygon : readVertices;
  if (!read(reader, value, context, draw)) return false;
  const auto bits = value.member("shaderSampleMaskBits");
  return !bits || reader.unsigned32(*bits, draw.shaderSampleMaskBits);
}

}  // namespace rasterdiff
