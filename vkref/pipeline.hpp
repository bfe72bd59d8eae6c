// Graphics pipelines, made once for each combination of what cannot be set while drawing.
#pragma once

#include <array>
#include <compare>
#include <map>

#include "scene/scene.hpp"
#include "vkref/owned.hpp"
#include "vkref/plan.hpp"
#include "vkref/shader_code.hpp"

namespace rasterdiff::vkref {

/// Everything that a pipeline depends on; culling, facing, topology, depth state, viewport and scissor are dynamic.
struct PipelineKey {
  uint32_t samples = 1;
  bool depth = false;
  bool negativeOneToOne = false;
  ProvokingVertexMode provokingVertexMode = ProvokingVertexMode::FIRST_VERTEX;
  PrimitiveSource primitives = PrimitiveSource::None;
  uint32_t varyings = 0;
  std::array<Interpolation, kMaxVaryingsPerPass> interpolations{};
  std::array<uint32_t, kMaxVaryingsPerPass> components{};
  friend auto operator<=>(const PipelineKey&, const PipelineKey&) = default;
};

[[nodiscard]] PipelineKey pipelineKey(const Scene& scene, const RenderPlan& plan, const PassPlan& pass,
                                      PrimitiveSource primitives);

/// Push constants of the raster shaders.
struct DrawConstants {
  uint32_t firstPrimitive = 0, verticesPerPrimitive = 1, firstProvoking = 0;
};

class PipelineCache {
 public:
  [[nodiscard]] static Result<std::unique_ptr<PipelineCache>> create(const Context& context);

  /// Made on first use. The handle is good until the next call. Error: DeviceLost, NotOffered (memory).
  [[nodiscard]] Result<VkPipeline> get(const PipelineKey& key);
  [[nodiscard]] VkPipelineLayout layout() const { return layout_.get(); }
  [[nodiscard]] VkPipelineCache driverCache() const { return driverCache_.get(); }
  [[nodiscard]] uint32_t created() const { return created_; }  ///< since the device was opened

 private:
  explicit PipelineCache(const Context& context) : context_(context) {}
  [[nodiscard]] Result<OwnedPipeline> make(const PipelineKey& key) const;

  const Context& context_;
  OwnedPipelineCache driverCache_;
  OwnedPipelineLayout layout_;
  std::map<PipelineKey, OwnedPipeline> pipelines_;
  uint32_t created_ = 0;
};

/// Error: DeviceLost, NotOffered (memory).
[[nodiscard]] Result<OwnedShaderModule> makeShaderModule(const Context& context, std::span<const uint32_t> code);

}  // namespace rasterdiff::vkref
