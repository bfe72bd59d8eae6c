// Builds graphics pipelines for dynamic rendering; recording draws with them is commands.cpp's work.
#include "vkref/pipeline.hpp"

#include "vkref/spirv_patch.hpp"
#include "vkref/vk_error.hpp"
#include "vkref/vk_struct.hpp"

namespace rasterdiff::vkref {
namespace {

constexpr size_t kMaxPipelines = 512;  ///< then all are dropped: bounds the memory of a long search

constexpr std::array kDynamicStates = {
    VK_DYNAMIC_STATE_VIEWPORT,           VK_DYNAMIC_STATE_SCISSOR,
    VK_DYNAMIC_STATE_CULL_MODE,          VK_DYNAMIC_STATE_FRONT_FACE,
    VK_DYNAMIC_STATE_PRIMITIVE_TOPOLOGY, VK_DYNAMIC_STATE_DEPTH_TEST_ENABLE,
    VK_DYNAMIC_STATE_DEPTH_WRITE_ENABLE, VK_DYNAMIC_STATE_DEPTH_COMPARE_OP,
};

/// Binding 0 is the position, binding 1 + i varying i; each array is tight and lies by itself.
struct VertexInput {
  std::array<VkVertexInputBindingDescription, 1 + kMaxVaryingsPerPass> bindings{};
  std::array<VkVertexInputAttributeDescription, 1 + kMaxVaryingsPerPass> attributes{};
  VkPipelineVertexInputStateCreateInfo info = vkStruct<VkPipelineVertexInputStateCreateInfo>(
      VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO);

  explicit VertexInput(const PipelineKey& key) {
    constexpr std::array kFormats = {VK_FORMAT_UNDEFINED, VK_FORMAT_R32_SFLOAT, VK_FORMAT_R32G32_SFLOAT,
                                     VK_FORMAT_R32G32B32_SFLOAT, VK_FORMAT_R32G32B32A32_SFLOAT};
    for (uint32_t i = 0; i <= key.varyings; ++i) {
      const uint32_t components = i == 0 ? 4 : key.components[i - 1];
      bindings[i] = {i, components * 4, VK_VERTEX_INPUT_RATE_VERTEX};
      attributes[i] = {i, i, kFormats[components], 0};
    }
    info.vertexBindingDescriptionCount = 1 + key.varyings;
    info.pVertexBindingDescriptions = bindings.data();
    info.vertexAttributeDescriptionCount = 1 + key.varyings;
    info.pVertexAttributeDescriptions = attributes.data();
  }
};

/// Color attachments in the order of the pass; the count adds up, all else is replaced.
struct ColorOutput {
  std::array<VkFormat, 2 + kMaxVaryingsPerPass> formats{};
  std::array<VkPipelineColorBlendAttachmentState, 2 + kMaxVaryingsPerPass> blends{};
  uint32_t count = 0;

  explicit ColorOutput(const PipelineKey& key) {
    if (key.primitives != PrimitiveSource::None) {
      add(kPrimitiveFormat);
      add(kCountFormat);
      VkPipelineColorBlendAttachmentState& blend = blends[1];
      blend.blendEnable = VK_TRUE;
      blend.srcColorBlendFactor = blend.dstColorBlendFactor = VK_BLEND_FACTOR_ONE;
      blend.srcAlphaBlendFactor = blend.dstAlphaBlendFactor = VK_BLEND_FACTOR_ONE;
      blend.colorBlendOp = blend.alphaBlendOp = VK_BLEND_OP_ADD;
    }
    for (uint32_t i = 0; i < key.varyings; ++i) add(varyingFormat(key.components[i]));
  }

  void add(VkFormat format) {
    formats[count] = format;
    blends[count].colorWriteMask =
        VK_COLOR_COMPONENT_R_BIT | VK_COLOR_COMPONENT_G_BIT | VK_COLOR_COMPONENT_B_BIT | VK_COLOR_COMPONENT_A_BIT;
    ++count;
  }
};

}  // namespace

PipelineKey pipelineKey(const Scene& scene, const RenderPlan& plan, const PassPlan& pass, PrimitiveSource primitives) {
  PipelineKey key;
  key.samples = plan.samples;
  key.depth = plan.depth;
  key.negativeOneToOne = scene.state.negativeOneToOne;
  key.provokingVertexMode = scene.state.provokingVertexMode;
  key.primitives = pass.primitives ? primitives : PrimitiveSource::None;
  key.varyings = pass.varyings;
  for (uint32_t i = 0; i < pass.varyings; ++i) {
    const Varying& varying = scene.draws.front().varyings[pass.firstVarying + i];
    key.interpolations[i] = varying.interpolation;
    key.components[i] = varying.components;
  }
  return key;
}

Result<OwnedShaderModule> makeShaderModule(const Context& context, std::span<const uint32_t> code) {
  auto info = vkStruct<VkShaderModuleCreateInfo>(VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO);
  info.codeSize = code.size_bytes();
  info.pCode = code.data();
  VkShaderModule module = VK_NULL_HANDLE;
  VKREF_TRY(context.vk.vkCreateShaderModule(context.device, &info, nullptr, &module));
  return OwnedShaderModule(context, module);
}

Result<std::unique_ptr<PipelineCache>> PipelineCache::create(const Context& context) {
  std::unique_ptr<PipelineCache> self(new PipelineCache(context));
  auto cacheInfo = vkStruct<VkPipelineCacheCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_CACHE_CREATE_INFO);
  VkPipelineCache cache = VK_NULL_HANDLE;
  VKREF_TRY(context.vk.vkCreatePipelineCache(context.device, &cacheInfo, nullptr, &cache));
  self->driverCache_ = OwnedPipelineCache(context, cache);

  const VkPushConstantRange range{VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT, 0, sizeof(DrawConstants)};
  auto layoutInfo = vkStruct<VkPipelineLayoutCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO);
  layoutInfo.pushConstantRangeCount = 1;
  layoutInfo.pPushConstantRanges = &range;
  VkPipelineLayout layout = VK_NULL_HANDLE;
  VKREF_TRY(context.vk.vkCreatePipelineLayout(context.device, &layoutInfo, nullptr, &layout));
  self->layout_ = OwnedPipelineLayout(context, layout);
  return self;
}

Result<VkPipeline> PipelineCache::get(const PipelineKey& key) {
  if (const auto found = pipelines_.find(key); found != pipelines_.end()) return found->second.get();
  Result<OwnedPipeline> made = make(key);
  if (!made) return tl::unexpected(made.error());
  if (pipelines_.size() >= kMaxPipelines) pipelines_.clear();
  ++created_;
  return pipelines_.emplace(key, std::move(*made)).first->second.get();
}

Result<OwnedPipeline> PipelineCache::make(const PipelineKey& key) const {
  const Result<OwnedShaderModule> vertex = makeShaderModule(context_, vertexCode(key.primitives, key.varyings));
  if (!vertex) return tl::unexpected(vertex.error());
  const std::vector<uint32_t> patched =
      withInterpolations(fragmentCode(key.primitives, key.varyings), {key.interpolations.data(), key.varyings});
  const Result<OwnedShaderModule> fragment = makeShaderModule(context_, patched);
  if (!fragment) return tl::unexpected(fragment.error());

  std::array<VkPipelineShaderStageCreateInfo, 2> stages{};
  stages[0] = {VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO, nullptr, 0, VK_SHADER_STAGE_VERTEX_BIT,
               vertex->get(), "main", nullptr};
  stages[1] = {VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO, nullptr, 0, VK_SHADER_STAGE_FRAGMENT_BIT,
               fragment->get(), "main", nullptr};

  const VertexInput vertexInput(key);
  auto assembly = vkStruct<VkPipelineInputAssemblyStateCreateInfo>(
      VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO);
  assembly.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;  // its class; the topology itself is dynamic

  auto clip = vkStruct<VkPipelineViewportDepthClipControlCreateInfoEXT>(
      VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_DEPTH_CLIP_CONTROL_CREATE_INFO_EXT);
  clip.negativeOneToOne = VK_TRUE;
  auto viewport = vkStruct<VkPipelineViewportStateCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO);
  viewport.pNext = key.negativeOneToOne ? &clip : nullptr;
  viewport.viewportCount = 1;
  viewport.scissorCount = 1;

  auto provoking = vkStruct<VkPipelineRasterizationProvokingVertexStateCreateInfoEXT>(
      VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_PROVOKING_VERTEX_STATE_CREATE_INFO_EXT);
  provoking.provokingVertexMode = VK_PROVOKING_VERTEX_MODE_LAST_VERTEX_EXT;
  auto raster = vkStruct<VkPipelineRasterizationStateCreateInfo>(
      VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO);
  raster.pNext = key.provokingVertexMode == ProvokingVertexMode::LAST_VERTEX ? &provoking : nullptr;
  raster.lineWidth = 1;

  auto multisample = vkStruct<VkPipelineMultisampleStateCreateInfo>(
      VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO);
  multisample.rasterizationSamples = static_cast<VkSampleCountFlagBits>(key.samples);
  const auto depth = vkStruct<VkPipelineDepthStencilStateCreateInfo>(
      VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO);

  const ColorOutput output(key);
  auto blend = vkStruct<VkPipelineColorBlendStateCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO);
  blend.attachmentCount = output.count;
  blend.pAttachments = output.blends.data();
  auto rendering = vkStruct<VkPipelineRenderingCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO);
  rendering.colorAttachmentCount = output.count;
  rendering.pColorAttachmentFormats = output.formats.data();
  rendering.depthAttachmentFormat = key.depth ? kDepthFormat : VK_FORMAT_UNDEFINED;

  auto dynamic = vkStruct<VkPipelineDynamicStateCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO);
  dynamic.dynamicStateCount = kDynamicStates.size();
  dynamic.pDynamicStates = kDynamicStates.data();

  auto info = vkStruct<VkGraphicsPipelineCreateInfo>(VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO, &rendering);
  info.stageCount = stages.size();
  info.pStages = stages.data();
  info.pVertexInputState = &vertexInput.info;
  info.pInputAssemblyState = &assembly;
  info.pViewportState = &viewport;
  info.pRasterizationState = &raster;
  info.pMultisampleState = &multisample;
  info.pDepthStencilState = &depth;
  info.pColorBlendState = &blend;
  info.pDynamicState = &dynamic;
  info.layout = layout_.get();
  VkPipeline pipeline = VK_NULL_HANDLE;
  VKREF_TRY(context_.vk.vkCreateGraphicsPipelines(context_.device, driverCache_.get(), 1, &info, nullptr, &pipeline));
  return OwnedPipeline(context_, pipeline);
}

}  // namespace rasterdiff::vkref
