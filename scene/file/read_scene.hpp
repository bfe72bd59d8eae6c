// The parts of a scene file, each read into its part of the scene. Ranges and relations between fields are left to
// validate(); a mistake is in the reader's error().
#pragma once

#include <glm/mat4x4.hpp>
#include <optional>
#include <string>

#include "scene/file/reader.hpp"
#include "scene/scene.hpp"

namespace rasterdiff {

bool readTarget(Reader& reader, const JsonValue& value, Target& target);
bool readViewport(Reader& reader, const JsonValue& value, Viewport& viewport);
bool readScissor(Reader& reader, const JsonValue& value, Rect2D& scissor);
bool readFurtherViewports(Reader& reader, const JsonValue& value, std::vector<ViewportAndScissor>& out);
bool readBuiltIns(Reader& reader, const JsonValue& value, std::vector<BuiltIn>& out);
bool readState(Reader& reader, const JsonValue& value, State& state);

/// World space to clip space. `aspect` is the viewport's width / |height|, the default of a fovY perspective.
bool readCamera(Reader& reader, const JsonValue& value, double aspect, bool negativeOneToOne,
                glm::dmat4& clipFromWorld);

/// What a draw needs of its scene.
struct DrawContext {
  const Scene& scene;                       ///< viewports and allowNonFinite
  std::optional<glm::dmat4> clipFromWorld;  ///< none without a camera
  std::string folder;                       ///< of the scene file, with a '/' at the end; paths of other files start there
};

/// `space` and `positions` of a draw whose viewport is known; positions are given, or the path of a .npy file.
bool readPositions(Reader& reader, const JsonValue& draw, const DrawContext& context, Draw& out);

bool readDraw(Reader& reader, const JsonValue& value, const DrawContext& context, Draw& draw);

}  // namespace rasterdiff
