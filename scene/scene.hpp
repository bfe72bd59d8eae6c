// What is drawn: the one description that both renderers receive. Positions are in clip space already; cameras, pixel
// coordinates and meshes are resolved while a scene is made (scene/camera, scene/mesh, scene/file).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "scene/result.hpp"
#include "scene/spaces.hpp"
#include "scene/vulkan_enums.hpp"

namespace rasterdiff {

struct Target {
  uint32_t width = 0, height = 0;  ///< pixels
  uint32_t samples = 1;            ///< rasterizationSamples
  std::optional<DepthFormat> depthFormat;
  float depthClearValue = 1;       ///< what the depth attachment holds before the first draw
  friend bool operator==(const Target&, const Target&) = default;
};

/// VkViewport. Height may be negative (flips y); minDepth may exceed maxDepth.
struct Viewport {
  float x = 0, y = 0, width = 0, height = 0, minDepth = 0, maxDepth = 1;
  friend bool operator==(const Viewport&, const Viewport&) = default;
};

/// VkRect2D in pixels.
struct Rect2D {
  int32_t x = 0, y = 0;
  uint32_t width = 0, height = 0;
  friend bool operator==(const Rect2D&, const Rect2D&) = default;
};

/// Field names are those of Vulkan's pipeline state structures; defaults are those of a zeroed structure where Vulkan
/// has one, and the harmless choice where it has none.
struct State {
  PrimitiveTopology topology = PrimitiveTopology::TRIANGLE_LIST;
  CullMode cullMode = CullMode::NONE;
  FrontFace frontFace = FrontFace::COUNTER_CLOCKWISE;
  ProvokingVertexMode provokingVertexMode = ProvokingVertexMode::FIRST_VERTEX;
  bool depthTestEnable = false;
  bool depthWriteEnable = false;
  CompareOp depthCompareOp = CompareOp::LESS;
  bool negativeOneToOne = false;  ///< VkPipelineViewportDepthClipControlCreateInfoEXT: view volume -w <= z <= w
  friend bool operator==(const State&, const State&) = default;
};

/// One fragment shader input; values are vertex-major, `components` floats a vertex.
struct Varying {
  std::string name;
  Interpolation interpolation = Interpolation::smooth;
  uint32_t components = 4;  ///< 1..4
  std::vector<float> values;
  friend bool operator==(const Varying&, const Varying&) = default;
};

/// One draw command. Indexed where `indices` has a value (an empty index list draws nothing).
struct Draw {
  std::vector<ClipPosition> positions;
  std::optional<std::vector<uint32_t>> indices;
  std::vector<Varying> varyings;  ///< the same names, interpolations and components in every draw of a scene
  friend bool operator==(const Draw&, const Draw&) = default;
};

inline constexpr uint32_t kMaxVaryings = 8;
inline constexpr uint32_t kMaxTargetExtent = 16384;
/// Largest frame (all planes of the reference with their bounds) that a scene may ask for.
inline constexpr uint64_t kMaxFrameBytes = uint64_t{4} << 30;

struct Scene {
  std::string name;
  Target target;
  Viewport viewport;              ///< a scene file that gives none has the whole target
  std::optional<Rect2D> scissor;  ///< none = the whole target
  State state;
  std::vector<Draw> draws;
  bool allowNonFinite = false;  ///< without it, NaN and infinities in positions or varyings are refused
  friend bool operator==(const Scene&, const Scene&) = default;
};

/// Checks everything a renderer relies on: extents, samples in {1, 2, 4, 8, 16}, finite numbers, indices in range,
/// array lengths, varyings alike in all draws, depth state only with a depth format.
/// `where` of the error names the field (`draws[1].indices[7]`).
[[nodiscard]] Result<void> validate(const Scene& scene);

/// Number of vertices the draw command consumes: indices if indexed, else positions.
[[nodiscard]] uint32_t vertexCount(const Draw& draw);

/// Number of primitives that assembly makes of `vertices` vertices (whole ones only). [vk:drawing-primitive-topologies]
[[nodiscard]] uint32_t primitiveCount(PrimitiveTopology topology, uint32_t vertices);

}  // namespace rasterdiff
