// The compute shader that reads multisampled images sample by sample.
#pragma once

#include <map>

#include "vkref/memory.hpp"
#include "vkref/pipeline.hpp"

namespace rasterdiff::vkref {

/// Components a sample that can be unpacked when `components` are wanted: the shader stores whole groups of four words.
[[nodiscard]] uint32_t unpackedComponents(uint32_t samples, uint32_t components);

class Unpack {
 public:
  [[nodiscard]] static Result<std::unique_ptr<Unpack>> create(const Context& context, VkPipelineCache driverCache);

  /// Begins a new submission: what was recorded before has been executed.
  [[nodiscard]] Result<void> reset();
  struct Rows {
    uint32_t first = 0, rows = 0;
    uint32_t components = 1;  ///< the first ones of each sample, as many as unpackedComponents gives
  };
  /// Records the copy of all samples in some rows of `image` (in SHADER_READ_ONLY layout) into `buffer` at `offset`, tight;
  /// they must fit a storage buffer's range. Error: DeviceLost, NotOffered.
  [[nodiscard]] Result<void> record(VkCommandBuffer commands, const Image& image, const Rows& rows, VkBuffer buffer,
                                    VkDeviceSize offset);
  [[nodiscard]] uint32_t created() const { return created_; }  ///< pipelines, since the device was opened
  [[nodiscard]] double seconds() const { return seconds_; }    ///< that they took

 private:
  struct Kind {
    bool unsignedIntegers = false;
    uint32_t samples = 1, components = 1;
    friend auto operator<=>(const Kind&, const Kind&) = default;
  };
  explicit Unpack(const Context& context) : context_(context) {}
  [[nodiscard]] Result<VkPipeline> pipeline(const Kind& kind);
  [[nodiscard]] Result<VkDescriptorSet> descriptors(const Image& image, VkBuffer buffer, VkDeviceSize offset,
                                                    VkDeviceSize bytes);

  const Context& context_;
  VkPipelineCache driverCache_ = VK_NULL_HANDLE;
  OwnedDescriptorSetLayout setLayout_;
  OwnedPipelineLayout layout_;
  std::vector<OwnedDescriptorPool> pools_;  ///< each of kSetsPerPool sets
  uint32_t setsUsed_ = 0;
  std::map<Kind, OwnedPipeline> pipelines_;
  uint32_t created_ = 0;
  double seconds_ = 0;
};

}  // namespace rasterdiff::vkref
