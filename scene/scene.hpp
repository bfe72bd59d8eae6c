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

/// VkSampleLocationEXT: fractions of the pixel, y down.
struct SampleLocationEXT {
  float x = 0, y = 0;
  friend bool operator==(const SampleLocationEXT&, const SampleLocationEXT&) = default;
};

/// VkSampleLocationsInfoEXT; sampleLocationsPerPixel is the target's number of samples. The location of sample s of pixel
/// (x, y) is [(x mod gridWidth + y mod gridHeight · gridWidth) · samples + s]. [vk:primsrast-samplelocations]
struct SampleLocationsInfo {
  uint32_t gridWidth = 1, gridHeight = 1;  ///< sampleLocationGridSize
  std::vector<SampleLocationEXT> sampleLocations{};
  friend bool operator==(const SampleLocationsInfo&, const SampleLocationsInfo&) = default;
};

struct Target {
  uint32_t width = 0, height = 0;  ///< pixels
  uint32_t samples = 1;            ///< rasterizationSamples
  uint32_t supersample = 1;        ///< n: drawn n times as large in both directions (supersampled())
  bool resolve = false;            ///< the varyings are also resolved to one value a pixel (AVERAGE)
  std::optional<DepthFormat> depthFormat{};
  std::optional<ResolveMode> depthResolveMode{};  ///< the depth is also resolved to one value a pixel
  std::optional<SampleLocationsInfo> sampleLocations{};  ///< none: the standard ones
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
  bool primitiveRestartEnable = false;  ///< index 0xFFFFFFFF ends a strip or fan
  PolygonMode polygonMode = PolygonMode::FILL;
  bool depthClampEnable = false;
  std::optional<bool> depthClipEnable{};  ///< none: the opposite of depthClampEnable
  bool depthBiasEnable = false;
  float depthBiasConstantFactor = 0, depthBiasClamp = 0, depthBiasSlopeFactor = 0;
  float lineWidth = 1;  ///< pixels
  LineRasterizationMode lineRasterizationMode = LineRasterizationMode::DEFAULT;
  bool stippledLineEnable = false;
  uint32_t lineStippleFactor = 1;    ///< 1..256
  uint16_t lineStipplePattern = 0xFFFF;
  float pointSize = 1;               ///< pixels, where a draw has no pointSizes
  uint32_t sampleMask = 0xFFFFFFFF;  ///< pSampleMask[0]
  bool sampleShadingEnable = false;
  float minSampleShading = 0;
  bool alphaToCoverageEnable = false;  ///< alpha is the fourth component of the first varying
  ShaderSampleMask shaderSampleMask = ShaderSampleMask::NONE;  ///< the output of the fragment shader
  friend bool operator==(const State&, const State&) = default;
};

/// One fragment shader input; values are vertex-major, `components` floats a vertex.
struct Varying {
  std::string name;
  Interpolation interpolation = Interpolation::smooth;
  uint32_t components = 4;  ///< 1..4
  std::vector<float> values{};
  float offsetX = 0, offsetY = 0;  ///< pixels from the centre, for Interpolation::offset
  friend bool operator==(const Varying&, const Varying&) = default;
};

/// One draw command. Indexed where `indices` has a value (an empty index list draws nothing).
struct Draw {
  std::vector<ClipPosition> positions{};
  std::optional<std::vector<uint32_t>> indices{};
  std::vector<Varying> varyings{};  ///< the same names, interpolations and components in every draw of a scene
  std::vector<float> pointSizes{};     ///< one a vertex, or none: state.pointSize
  uint32_t clipDistanceCount = 0, cullDistanceCount = 0;  ///< 0..8 each, together at most 8; alike in all draws
  std::vector<float> clipDistances{};  ///< vertex-major, clipDistanceCount a vertex; kept where >= 0
  std::vector<float> cullDistances{};  ///< vertex-major; a primitive with one negative at all vertices is discarded
  uint32_t viewportIndex = 0;        ///< 0: Scene::viewport; n: Scene::furtherViewports[n - 1]
  uint32_t shaderSampleMaskBits = 0xFFFFFFFF;  ///< for State::shaderSampleMask
  friend bool operator==(const Draw&, const Draw&) = default;
};

struct ViewportAndScissor {
  Viewport viewport;
  std::optional<Rect2D> scissor{};
  friend bool operator==(const ViewportAndScissor&, const ViewportAndScissor&) = default;
};

inline constexpr uint32_t kRestartIndex = 0xFFFFFFFF;
inline constexpr uint32_t kMaxDistances = 8;
inline constexpr uint32_t kMaxViewports = 16;  ///< of a scene; the first is Scene::viewport
inline constexpr uint32_t kMaxSupersample = 32;
inline constexpr uint32_t kMaxSampleLocationGrid = 8;  ///< pixels each way
inline constexpr uint32_t kMaxLineStippleFactor = 256;
inline constexpr uint32_t kMaxVaryings = 8;
inline constexpr uint32_t kMaxTargetExtent = 16384;
/// Largest frame (all planes of the reference with their bounds) that a scene may ask for.
inline constexpr uint64_t kMaxFrameBytes = uint64_t{4} << 30;

struct Scene {
  std::string name;
  Target target;
  Viewport viewport;              ///< a scene file that gives none has the whole target
  std::optional<Rect2D> scissor{};  ///< none = the whole target
  std::vector<ViewportAndScissor> furtherViewports{};
  State state;
  std::vector<Draw> draws{};
  std::vector<BuiltIn> builtIns{};  ///< observed: a plane each, after the varyings, named as the built-in
  bool allowNonFinite = false;  ///< without it, NaN and infinities in positions or varyings are refused
  friend bool operator==(const Scene&, const Scene&) = default;
};

/// Checks everything a renderer relies on: extents, samples in {1, 2, 4, 8, 16}, finite numbers, indices in range (or
/// kRestartIndex with primitive restart), array lengths, varyings and numbers of distances alike in all draws, and state
/// only where there is what it acts on (a depth format, several samples, points, lines, polygons).
/// `where` of the error names the field (`draws[1].indices[7]`).
[[nodiscard]] Result<void> validate(const Scene& scene);

/// Number of vertices the draw command consumes: indices if indexed, else positions.
[[nodiscard]] uint32_t vertexCount(const Draw& draw);

/// Number of primitives of a draw, restarts taken into account.
[[nodiscard]] uint32_t primitiveCount(const State& state, const Draw& draw);

/// Number of primitives that assembly makes of `vertices` vertices (whole ones only). [vk:drawing-primitive-topologies]
[[nodiscard]] uint32_t primitiveCount(PrimitiveTopology topology, uint32_t vertices);

}  // namespace rasterdiff
