// The state structures of a graphics pipeline, each with what it points to, filled in from a key.
#pragma once

#include <array>
#include <vector>

#include "vkref/pipeline_key.hpp"
#include "vkref/vk_struct.hpp"

namespace rasterdiff::vkref {

/// The bindings of vertex buffers: each array is tight and lies by itself. Binding 1 + i is varying i of the pass.
inline constexpr uint32_t kPositionBinding = 0, kPointSizeBinding = 1 + kMaxVaryingsPerPass,
                          kClipDistanceBinding = kPointSizeBinding + 1,
                          kCullDistanceBinding = kClipDistanceBinding + 1,
                          kVertexBindings = kCullDistanceBinding + 1;

struct VertexInput {
  explicit VertexInput(const PipelineKey& key);
  VertexInput(const VertexInput&) = delete;
  VertexInput& operator=(const VertexInput&) = delete;

  std::vector<VkVertexInputBindingDescription> bindings;
  std::vector<VkVertexInputAttributeDescription> attributes;
  VkPipelineVertexInputStateCreateInfo info{};

 private:
  void addBinding(uint32_t binding, uint32_t components);
  void addAttribute(uint32_t location, uint32_t binding, uint32_t components, uint32_t offset = 0);
  void addDistances(uint32_t location, uint32_t binding, uint32_t distances);
};

struct RasterState {
  explicit RasterState(const PipelineKey& key);
  RasterState(const RasterState&) = delete;
  RasterState& operator=(const RasterState&) = delete;

  VkPipelineRasterizationProvokingVertexStateCreateInfoEXT provoking{};
  VkPipelineRasterizationDepthClipStateCreateInfoEXT depthClip{};
  VkPipelineRasterizationLineStateCreateInfoEXT lines{};
  VkPipelineRasterizationStateCreateInfo info{};
};

struct MultisampleState {
  explicit MultisampleState(const PipelineKey& key);
  MultisampleState(const MultisampleState&) = delete;
  MultisampleState& operator=(const MultisampleState&) = delete;

  VkSampleMask mask = 0;
  std::vector<VkSampleLocationEXT> locations;
  VkPipelineSampleLocationsStateCreateInfoEXT custom{};
  VkPipelineMultisampleStateCreateInfo info{};
};

/// Color attachments in the order of a pass; the count adds up, all else is replaced.
struct ColorOutput {
  explicit ColorOutput(const PipelineKey& key);
  ColorOutput(const ColorOutput&) = delete;
  ColorOutput& operator=(const ColorOutput&) = delete;

  std::vector<VkFormat> formats;
  std::vector<VkPipelineColorBlendAttachmentState> blends;
  VkPipelineColorBlendStateCreateInfo info{};

 private:
  void add(VkFormat format, bool adds = false);
};

}  // namespace rasterdiff::vkref
