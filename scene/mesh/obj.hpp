// Triangle meshes from OBJ files (through tinyobjloader), and draws made of them. Materials, texture coordinates,
// points and lines of a file are left out.
#pragma once

#include <array>
#include <glm/mat4x4.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.hpp"

namespace rasterdiff {

struct Mesh {
  std::vector<std::array<float, 3>> positions;  ///< model space
  std::vector<std::array<float, 3>> normals;    ///< one a position: the file's, else area-weighted means of its faces
  std::vector<uint32_t> indices;                ///< triangles
};

/// Reads a file. Error: Io (missing, unreadable), BadInput with fileName:line:column (see checkedFaceLines).
[[nodiscard]] Result<Mesh> loadObj(const std::string& path);
/// As loadObj, from memory; `fileName` is only for messages.
[[nodiscard]] Result<Mesh> parseObj(std::string_view text, const std::string& fileName);

/// What a mesh can hand to the fragment shader, by varying name.
inline constexpr std::array<std::string_view, 2> kMeshVaryings{"normal", "position"};

/// An indexed draw of the mesh. Each of `varyings` is asked for by name (one of kMeshVaryings) and interpolation; its
/// three components are the model-space values.
[[nodiscard]] Draw meshDraw(const Mesh& mesh, const glm::dmat4& clipFromModel, std::span<const Varying> varyings);

/// The Stanford bunny of Debian's package glmark2-data (69,666 triangles): its path, or an Io error that names the
/// package.
[[nodiscard]] Result<std::string> findBunny();

}  // namespace rasterdiff
