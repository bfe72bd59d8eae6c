#include "scene/mesh/obj.hpp"

#include <tiny_obj_loader.h>

#include <cmath>
#include <exception>
#include <filesystem>
#include <glm/geometric.hpp>
#include <sstream>
#include <unordered_map>

#include "scene/camera/projection.hpp"
#include "scene/file/read_file.hpp"
#include "scene/mesh/obj_check.hpp"

namespace rasterdiff {
namespace {

std::array<float, 3> triple(const std::vector<float>& values, size_t index) {
  return {values[3 * index], values[3 * index + 1], values[3 * index + 2]};
}

glm::dvec3 point(const std::array<float, 3>& p) { return {p[0], p[1], p[2]}; }

/// The cross product's length is twice the area: larger faces count more. A vertex of zero-area faces only gets 0.
void computeNormals(Mesh& mesh) {
  std::vector<glm::dvec3> sums(mesh.positions.size(), glm::dvec3(0));
  for (size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const uint32_t a = mesh.indices[i], b = mesh.indices[i + 1], c = mesh.indices[i + 2];
    const glm::dvec3 origin = point(mesh.positions[a]);
    const glm::dvec3 normal = glm::cross(point(mesh.positions[b]) - origin, point(mesh.positions[c]) - origin);
    for (uint32_t v : {a, b, c}) sums[v] += normal;
  }
  mesh.normals.reserve(sums.size());
  for (const glm::dvec3& sum : sums) {
    const double length = glm::length(sum);
    const glm::dvec3 unit = length > 0 ? sum / length : glm::dvec3(0);
    mesh.normals.push_back({static_cast<float>(unit.x), static_cast<float>(unit.y), static_cast<float>(unit.z)});
  }
}

/// One vertex for each (position, normal) pair in use, in order of first use.
Mesh weld(const tinyobj::attrib_t& attributes, const std::vector<tinyobj::shape_t>& shapes) {
  bool allNormals = true;
  for (const tinyobj::shape_t& shape : shapes) {
    for (const tinyobj::index_t& index : shape.mesh.indices) allNormals &= index.normal_index >= 0;
  }
  Mesh mesh;
  std::unordered_map<uint64_t, uint32_t> seen;
  for (const tinyobj::shape_t& shape : shapes) {
    for (const tinyobj::index_t& index : shape.mesh.indices) {
      const auto position = static_cast<uint32_t>(index.vertex_index);
      const uint32_t normal = allNormals ? static_cast<uint32_t>(index.normal_index) : 0;
      const auto [entry, isNew] =
          seen.try_emplace(uint64_t{normal} << 32 | position, static_cast<uint32_t>(mesh.positions.size()));
      if (isNew) {
        mesh.positions.push_back(triple(attributes.vertices, position));
        if (allNormals) mesh.normals.push_back(triple(attributes.normals, normal));
      }
      mesh.indices.push_back(entry->second);
    }
  }
  if (!allNormals) computeNormals(mesh);
  return mesh;
}

}  // namespace

Result<Mesh> parseObj(std::string_view text, const std::string& fileName) {
  Result<std::string> lines = checkedFaceLines(text, fileName);
  if (!lines) return tl::unexpected(lines.error());
  tinyobj::attrib_t attributes;
  std::vector<tinyobj::shape_t> shapes;
  std::vector<tinyobj::material_t> materials;
  std::string warning, error;
  std::istringstream stream(std::move(*lines));
  try {
    if (!tinyobj::LoadObj(&attributes, &shapes, &materials, &warning, &error, &stream, nullptr, true, false)) {
      return fail(ErrorCode::BadInput, fileName, "tinyobjloader refuses the file: " + error);
    }
  } catch (const std::exception& e) {
    return fail(ErrorCode::BadInput, fileName, std::string("tinyobjloader refuses the file: ") + e.what());
  }
  Mesh mesh = weld(attributes, shapes);
  if (mesh.indices.empty()) {
    return fail(ErrorCode::BadInput, fileName, "triangulation leaves no triangle", "are all faces degenerate?");
  }
  return mesh;
}

Result<Mesh> loadObj(const std::string& path) {
  Result<std::string> text = readFile(path);
  if (!text) return tl::unexpected(text.error());
  return parseObj(*text, path);
}

Draw meshDraw(const Mesh& mesh, const glm::dmat4& clipFromModel, std::span<const Varying> varyings) {
  Draw draw;
  draw.positions.reserve(mesh.positions.size());
  for (const auto& [x, y, z] : mesh.positions) {
    draw.positions.push_back(toClip(clipFromModel, double{x}, double{y}, double{z}));
  }
  draw.indices = mesh.indices;
  for (const Varying& asked : varyings) {
    Varying& varying =
        draw.varyings.emplace_back(Varying{.name = asked.name, .interpolation = asked.interpolation, .components = 3});
    varying.offsetX = asked.offsetX;
    varying.offsetY = asked.offsetY;
    varying.values.reserve(mesh.positions.size() * 3);
    for (const std::array<float, 3>& v : asked.name == kMeshVaryings[0] ? mesh.normals : mesh.positions) {
      varying.values.insert(varying.values.end(), v.begin(), v.end());
    }
  }
  return draw;
}

Result<std::string> findBunny() {
  for (const char* path : {"/usr/share/glmark2/models/bunny.obj", "/usr/local/share/glmark2/models/bunny.obj"}) {
    std::error_code ignored;
    if (std::filesystem::is_regular_file(path, ignored)) return path;
  }
  return fail(ErrorCode::Io, "bunny.obj", "the Stanford bunny is not installed (package glmark2-data)",
              "apt-get install glmark2-data");
}

}  // namespace rasterdiff
