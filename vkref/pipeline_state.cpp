// Structures of extensions are chained only where a scene asks for what they change.
#include "vkref/pipeline_state.hpp"

#include <algorithm>

#include "scene/built_ins.hpp"

namespace rasterdiff::vkref {

void VertexInput::addBinding(uint32_t binding, uint32_t components) {
  bindings.push_back({binding, components * 4, VK_VERTEX_INPUT_RATE_VERTEX});
}

void VertexInput::addAttribute(uint32_t location, uint32_t binding, uint32_t components, uint32_t offset) {
  constexpr std::array kFormats = {VK_FORMAT_UNDEFINED, VK_FORMAT_R32_SFLOAT, VK_FORMAT_R32G32_SFLOAT,
                                   VK_FORMAT_R32G32B32_SFLOAT, VK_FORMAT_R32G32B32A32_SFLOAT};
  attributes.push_back({location, binding, kFormats[components], offset});
}

/// Up to eight distances are two inputs; the second of them repeats the first where there is nothing more.
void VertexInput::addDistances(uint32_t location, uint32_t binding, uint32_t distances) {
  addBinding(binding, distances);
  addAttribute(location, binding, std::min(distances, 4U));
  if (distances > 4) {
    addAttribute(location + 1, binding, distances - 4, 16);
  } else {
    addAttribute(location + 1, binding, distances);
  }
}

VertexInput::VertexInput(const PipelineKey& key) {
  addBinding(kPositionBinding, 4);
  addAttribute(0, kPositionBinding, 4);
  for (uint32_t i = 1; i <= key.varyings; ++i) {
    addBinding(i, key.components[i - 1]);
    addAttribute(i, i, key.components[i - 1]);
  }
  if (key.extras.any()) {  // that shader has all inputs; the fragment shader does not ask for these
    for (uint32_t i = key.varyings + 1; i <= kMaxVaryingsPerPass; ++i) addAttribute(i, kPositionBinding, 4);
  }
  if (key.extras.pointSize) {
    addBinding(kPointSizeBinding, 1);
    addAttribute(7, kPointSizeBinding, 1);
  }
  if (key.extras.clipDistances) addDistances(8, kClipDistanceBinding, key.clipDistances);
  if (key.extras.cullDistances) addDistances(10, kCullDistanceBinding, key.cullDistances);
  info.sType = VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO;
  info.vertexBindingDescriptionCount = static_cast<uint32_t>(bindings.size());
  info.pVertexBindingDescriptions = bindings.data();
  info.vertexAttributeDescriptionCount = static_cast<uint32_t>(attributes.size());
  info.pVertexAttributeDescriptions = attributes.data();
}

RasterState::RasterState(const PipelineKey& key) {
  info.sType = VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO;
  info.depthClampEnable = key.depthClamp;
  info.polygonMode = static_cast<VkPolygonMode>(key.polygonMode);
  info.lineWidth = 1;  // dynamic
  const auto chain = [this](auto& structure, VkStructureType type) {
    structure.sType = type;
    structure.pNext = info.pNext;
    info.pNext = &structure;
  };
  if (key.provokingVertexMode == ProvokingVertexMode::LAST_VERTEX) {
    chain(provoking, VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_PROVOKING_VERTEX_STATE_CREATE_INFO_EXT);
    provoking.provokingVertexMode = VK_PROVOKING_VERTEX_MODE_LAST_VERTEX_EXT;
  }
  if (key.depthClipStated) {
    chain(depthClip, VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_DEPTH_CLIP_STATE_CREATE_INFO_EXT);
    depthClip.depthClipEnable = key.depthClip;
  }
  if (key.lineMode != LineRasterizationMode::DEFAULT || key.stippled) {
    chain(lines, VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_LINE_STATE_CREATE_INFO_EXT);
    lines.lineRasterizationMode = static_cast<VkLineRasterizationModeEXT>(key.lineMode);
    lines.stippledLineEnable = key.stippled;
    lines.lineStippleFactor = 1;  // dynamic, as the pattern
  }
}

MultisampleState::MultisampleState(const PipelineKey& key) : mask(~key.sampleMask) {
  info.sType = VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO;
  info.rasterizationSamples = static_cast<VkSampleCountFlagBits>(key.samples);
  info.sampleShadingEnable = key.sampleShading;
  info.minSampleShading = key.minSampleShading;
  info.pSampleMask = key.sampleMask != 0 ? &mask : nullptr;
  info.alphaToCoverageEnable = key.alphaToCoverage;
  if (key.sampleLocations.empty()) return;
  // [vk:primsrast-samplelocations]
  for (const SampleLocation2D& at : key.sampleLocations) locations.push_back({at[0], at[1]});
  custom.sType = VK_STRUCTURE_TYPE_PIPELINE_SAMPLE_LOCATIONS_STATE_CREATE_INFO_EXT;
  custom.sampleLocationsEnable = VK_TRUE;
  custom.sampleLocationsInfo.sType = VK_STRUCTURE_TYPE_SAMPLE_LOCATIONS_INFO_EXT;
  custom.sampleLocationsInfo.sampleLocationsPerPixel = info.rasterizationSamples;
  custom.sampleLocationsInfo.sampleLocationGridSize = {key.sampleLocationGridWidth, key.sampleLocationGridHeight};
  custom.sampleLocationsInfo.sampleLocationsCount = static_cast<uint32_t>(locations.size());
  custom.sampleLocationsInfo.pSampleLocations = locations.data();
  info.pNext = &custom;
}

ColorOutput::ColorOutput(const PipelineKey& key) {
  const uint32_t first = key.alphaFirst ? 1 : 0;
  if (key.alphaFirst) add(varyingFormat(key.components[0]));
  if (key.primitives != PrimitiveSource::None) {
    add(kPrimitiveFormat);
    add(kCountFormat, /*adds=*/true);
  }
  for (uint32_t i = first; i < key.varyings; ++i) add(varyingFormat(key.components[i]));
  if (key.observes) add(varyingFormat(builtInComponents(key.builtIn)));
  info.sType = VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO;
  info.attachmentCount = static_cast<uint32_t>(blends.size());
  info.pAttachments = blends.data();
}

void ColorOutput::add(VkFormat format, bool adds) {
  formats.push_back(format);
  VkPipelineColorBlendAttachmentState blend{};
  blend.colorWriteMask =
      VK_COLOR_COMPONENT_R_BIT | VK_COLOR_COMPONENT_G_BIT | VK_COLOR_COMPONENT_B_BIT | VK_COLOR_COMPONENT_A_BIT;
  if (adds) {
    blend.blendEnable = VK_TRUE;
    blend.srcColorBlendFactor = blend.dstColorBlendFactor = VK_BLEND_FACTOR_ONE;
    blend.srcAlphaBlendFactor = blend.dstAlphaBlendFactor = VK_BLEND_FACTOR_ONE;
    blend.colorBlendOp = blend.alphaBlendOp = VK_BLEND_OP_ADD;
  }
  blends.push_back(blend);
}

}  // namespace rasterdiff::vkref
