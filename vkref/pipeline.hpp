// Graphics pipelines, made once for each combination of what cannot be set while drawing.
#pragma once

#include <map>

#include "vkref/owned.hpp"
#include "vkref/pipeline_key.hpp"

namespace rasterdiff::vkref {

/// Push constants of the raster shaders.
struct DrawConstants {
  uint32_t firstPrimitive = 0, verticesPerPrimitive = 1, firstProvoking = 0, viewportIndex = 0;
  uint32_t shaderSampleMaskBits = 0;
};

class PipelineCache {
 public:
  [[nodiscard]] static Result<std::unique_ptr<PipelineCache>> create(const Context& context);

  /// Made on first use. The handle is good until they are dropped. Error: DeviceLost, NotOffered (memory).
  [[nodiscard]] Result<VkPipeline> get(const PipelineKey& key);
  /// Drops all if they are more than `most`. Not while there are commands with them that have not ended.
  void dropIfMore(size_t most);
  [[nodiscard]] VkPipelineLayout layout() const { return layout_.get(); }
  [[nodiscard]] VkPipelineCache driverCache() const { return driverCache_.get(); }
  [[nodiscard]] uint32_t created() const { return created_; }  ///< since the device was opened
  [[nodiscard]] double seconds() const { return seconds_; }    ///< that they took

 private:
  explicit PipelineCache(const Context& context) : context_(context) {}
  [[nodiscard]] Result<OwnedPipeline> make(const PipelineKey& key) const;

  const Context& context_;
  OwnedPipelineCache driverCache_;
  OwnedPipelineLayout layout_;
  std::map<PipelineKey, OwnedPipeline> pipelines_;
  uint32_t created_ = 0;
  double seconds_ = 0;
};

/// Error: DeviceLost, NotOffered (memory).
[[nodiscard]] Result<OwnedShaderModule> makeShaderModule(const Context& context, std::span<const uint32_t> code);

}  // namespace rasterdiff::vkref
