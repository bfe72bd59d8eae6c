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

/// The viewport that a draw's viewportIndex names.
[[nodiscard]] const Viewport& viewportOf(const DrawContext& context, const Draw& draw);

/// The varyings that a mesh or a polygon brings itself.
struct OfferedVaryings {
  const char* owner;  ///< "a mesh"
  std::span<const std::string_view> names;
};

/// `varyings` of a draw, if it has them; `offered` null: each with its values.
bool readVaryings(Reader& reader, const JsonValue& draw, const OfferedVaryings* offered, bool allowNonFinite,
                  std::vector<Varying>& out);

/// Each vertex has a number or an array of 1 to `most` numbers, all alike; `count` is how many.
bool readVertexArrays(Reader& reader, const JsonValue& value, std::string_view what, uint32_t most, bool allowNonFinite,
                      uint32_t& count, std::vector<float>& out);

/// In range already: pixels are those of this viewport.
bool readViewportIndex(Reader& reader, const JsonValue& draw, const DrawContext& context, Draw& out);

/// A draw with `svg` or `points`.
bool readPolygon(Reader& reader, const JsonValue& value, const DrawContext& context, Draw& draw);

bool readDraw(Reader& reader, const JsonValue& value, const DrawContext& context, Draw& draw);

}  // namespace rasterdiff
