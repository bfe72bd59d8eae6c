// Scene files (*.scene.json): text to Scene and back. The format is described in docs/scene-format.md and by the JSON
// Schema scene.schema.json beside this file.
#pragma once

#include <string>
#include <string_view>

#include "scene/result.hpp"
#include "scene/scene.hpp"

namespace rasterdiff {

/// Reads and checks a scene file; cameras, pixel coordinates and meshes are resolved to clip space. The scene is valid.
/// Error: Io (`where` = path), BadInput (`where` = path:line:column, counted from 1, columns in characters).
[[nodiscard]] Result<Scene> loadScene(const std::string& path);

/// As loadScene, from memory. `fileName` is for messages, for the default name (its stem) and for relative mesh paths.
[[nodiscard]] Result<Scene> parseScene(std::string_view text, const std::string& fileName);

/// A scene file in clip space that parseScene turns into the same scene, bit by bit.
[[nodiscard]] std::string writeScene(const Scene& scene);

}  // namespace rasterdiff
