// Deliberate errors that are errors of reading: the renderer is right, but takes a state, a viewport or a vertex array
// for something else. The others sit in the stages that they break.
#pragma once

#include <optional>

#include "rasterizer/deliberate_error.hpp"
#include "scene/scene.hpp"

namespace rasterdiff::rasterizer {

/// What a renderer with this mistake takes a valid `scene` for; none if the mistake is not one of reading.
[[nodiscard]] std::optional<Scene> mistakenScene(const Scene& scene, DeliberateError error);

}  // namespace rasterdiff::rasterizer
