// Everything that a pipeline depends on; what can be set while drawing (culling, facing, depth state, width of lines,
// viewports, …) is left to commands.cpp.
#pragma once

#include <array>
#include <compare>
#include <vector>

#include "scene/scene.hpp"
#include "vkref/plan.hpp"
#include "scene/primitive_class.hpp"
#include "vkref/shader_code.hpp"
#include "vkref/spirv_patch.hpp"

namespace rasterdiff::vkref {

/// VkSampleLocationEXT, ordered.
using SampleLocation2D = std::array<float, 2>;

struct PipelineKey {
  uint32_t samples = 1;
  VkFormat depth = VK_FORMAT_UNDEFINED;
  bool negativeOneToOne = false;
  ProvokingVertexMode provokingVertexMode = ProvokingVertexMode::FIRST_VERTEX;
  PrimitiveSource primitives = PrimitiveSource::None;
  uint32_t varyings = 0;
  std::array<InputInterpolation, kMaxVaryingsPerPass> interpolations{};
  std::array<uint32_t, kMaxVaryingsPerPass> components{};

  TopologyClass topology = TopologyClass::Triangle;
  PolygonMode polygonMode = PolygonMode::FILL;
  bool depthClamp = false;
  bool depthClipStated = false, depthClip = true;  ///< stated: other than Vulkan's default, the opposite of the clamp
  LineRasterizationMode lineMode = LineRasterizationMode::DEFAULT;
  bool stippled = false;
  uint32_t sampleMask = 0;    ///< bits of samples that are masked out
  bool sampleShading = false;
  float minSampleShading = 0;
  bool alphaToCoverage = false, alphaFirst = false;
  ShaderSampleMask shaderSampleMask = ShaderSampleMask::NONE;
  std::vector<SampleLocation2D> sampleLocations{};  ///< none: the standard ones
  uint32_t sampleLocationGridWidth = 1, sampleLocationGridHeight = 1;
  VertexExtras extras{};
  uint32_t clipDistances = 0, cullDistances = 0;
  uint32_t viewports = 1;
  bool observes = false;  ///< the pass observes `builtIn`
  BuiltIn builtIn{};
  friend auto operator<=>(const PipelineKey&, const PipelineKey&) = default;
};

/// `primitives` is where the device has them from; passes without them take none.
[[nodiscard]] PipelineKey pipelineKey(const Scene& scene, const RenderPlan& plan, const PassPlan& pass,
                                      PrimitiveSource primitives);

}  // namespace rasterdiff::vkref
