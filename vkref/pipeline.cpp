// Builds graphics pipelines for dynamic rendering; recording draws with them is commands.cpp's work.
#include "vkref/pipeline.hpp"

#include "scene/stopwatch.hpp"
#include "vkref/pipeline_state.hpp"
#include "vkref/vk_error.hpp"

namespace rasterdiff::vkref {
namespace {

/// What every pipeline leaves to commands.cpp; stippled ones also the stipple.
constexpr std::array kDynamicStates = {
    VK_DYNAMIC_STATE_VIEWPORT,           VK_DYNAMIC_STATE_SCISSOR,
    VK_DYNAMIC_STATE_CULL_MODE,          VK_DYNAMIC_STATE_FRONT_FACE,
    VK_DYNAMIC_STATE_PRIMITIVE_TOPOLOGY, VK_DYNAMIC_STATE_PRIMITIVE_RESTART_ENABLE,
    VK_DYNAMIC_STATE_DEPTH_TEST_ENABLE,  VK_DYNAMIC_STATE_DEPTH_WRITE_ENABLE,
    VK_DYNAMIC_STATE_DEPTH_COMPARE_OP,   VK_DYNAMIC_STATE_DEPTH_BIAS_ENABLE,
    VK_DYNAMIC_STATE_DEPTH_BIAS,         VK_DYNAMIC_STATE_LINE_WIDTH,
    VK_DYNAMIC_STATE_LINE_STIPPLE_EXT,
};

/// A topology of the class; the topology itself is dynamic.
VkPrimitiveTopology topologyOf(TopologyClass topologyClass) {
  switch (topologyClass) {
    case TopologyClass::Point:
      return VK_PRIMITIVE_TOPOLOGY_POINT_LIST;
    case TopologyClass::Line:
      return VK_PRIMITIVE_TOPOLOGY_LINE_LIST;
    case TopologyClass::Triangle:
      break;
  }
  return VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
}

std::vector<uint32_t> fragmentModule(const PipelineKey& key) {
  const std::span<const InputInterpolation> interpolations(key.interpolations.data(), key.varyings);
  if (key.observes) return withInterpolations(builtInCode(key.builtIn, key.alphaFirst, key.shaderSampleMask), interpolations);
  std::vector<uint32_t> code = withInterpolations(fragmentCode(key.primitives, key.varyings, key.shaderSampleMask), interpolations);
  const bool alphaIsFirst = !key.alphaFirst || key.primitives == PrimitiveSource::None;
  return alphaIsFirst ? code : withOutputFirst(code, kFirstVarying);
}

}  // namespace

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
  Stopwatch watch;
  Result<OwnedPipeline> made = make(key);
  seconds_ += watch.lap();
  if (!made) return tl::unexpected(made.error());
  ++created_;
  return pipelines_.emplace(key, std::move(*made)).first->second.get();
}

void PipelineCache::dropIfMore(size_t most) {
  if (pipelines_.size() > most) pipelines_.clear();
}

Result<OwnedPipeline> PipelineCache::make(const PipelineKey& key) const {
  const Result<OwnedShaderModule> vertex =
      makeShaderModule(context_, vertexCode(key.primitives, key.varyings, key.extras));
  if (!vertex) return tl::unexpected(vertex.error());
  const Result<OwnedShaderModule> fragment = makeShaderModule(context_, fragmentModule(key));
  if (!fragment) return tl::unexpected(fragment.error());

  const std::array<uint32_t, 2> constants = {key.clipDistances, key.cullDistances};
  const std::array<VkSpecializationMapEntry, 2> entries = {{{0, 0, 4}, {1, 4, 4}}};
  const VkSpecializationInfo distances{entries.size(), entries.data(), sizeof(constants), constants.data()};
  std::array<VkPipelineShaderStageCreateInfo, 2> stages{};
  stages[0] = {VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO, nullptr, 0, VK_SHADER_STAGE_VERTEX_BIT,
               vertex->get(), "main", key.extras.any() ? &distances : nullptr};
  stages[1] = {VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO, nullptr, 0, VK_SHADER_STAGE_FRAGMENT_BIT,
               fragment->get(), "main", nullptr};

  auto assembly = vkStruct<VkPipelineInputAssemblyStateCreateInfo>(
      VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO);
  assembly.topology = topologyOf(key.topology);

  auto clip = vkStruct<VkPipelineViewportDepthClipControlCreateInfoEXT>(
      VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_DEPTH_CLIP_CONTROL_CREATE_INFO_EXT);
  clip.negativeOneToOne = VK_TRUE;
  auto viewport = vkStruct<VkPipelineViewportStateCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO);
  viewport.pNext = key.negativeOneToOne ? &clip : nullptr;
  viewport.viewportCount = key.viewports;
  viewport.scissorCount = key.viewports;

  const VertexInput vertexInput(key);
  const RasterState raster(key);
  const MultisampleState multisample(key);
  const ColorOutput output(key);
  const auto depth = vkStruct<VkPipelineDepthStencilStateCreateInfo>(
      VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO);
  auto rendering = vkStruct<VkPipelineRenderingCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO);
  rendering.colorAttachmentCount = static_cast<uint32_t>(output.formats.size());
  rendering.pColorAttachmentFormats = output.formats.data();
  rendering.depthAttachmentFormat = key.depth;

  auto dynamic = vkStruct<VkPipelineDynamicStateCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO);
  dynamic.dynamicStateCount = kDynamicStates.size() - (key.stippled ? 0 : 1);
  dynamic.pDynamicStates = kDynamicStates.data();

  auto info = vkStruct<VkGraphicsPipelineCreateInfo>(VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO, &rendering);
  info.stageCount = stages.size();
  info.pStages = stages.data();
  info.pVertexInputState = &vertexInput.info;
  info.pInputAssemblyState = &assembly;
  info.pViewportState = &viewport;
  info.pRasterizationState = &raster.info;
  info.pMultisampleState = &multisample.info;
  info.pDepthStencilState = &depth;
  info.pColorBlendState = &output.info;
  info.pDynamicState = &dynamic;
  info.layout = layout_.get();
  VkPipeline pipeline = VK_NULL_HANDLE;
  VKREF_TRY(context_.vk.vkCreateGraphicsPipelines(context_.device, driverCache_.get(), 1, &info, nullptr, &pipeline));
  return OwnedPipeline(context_, pipeline);
}

}  // namespace rasterdiff::vkref
