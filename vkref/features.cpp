// Queries features structure by structure and keeps the ones that scenes can ask for.
#include "vkref/features.hpp"

#include <algorithm>
#include <array>

namespace rasterdiff::vkref {
namespace {

/// [vk:features] of Vulkan 1.0.
constexpr std::array kCoreFeatures = {
    &VkPhysicalDeviceFeatures::depthBiasClamp,     &VkPhysicalDeviceFeatures::depthClamp,
    &VkPhysicalDeviceFeatures::fillModeNonSolid,   &VkPhysicalDeviceFeatures::fullDrawIndexUint32,
    &VkPhysicalDeviceFeatures::geometryShader,     &VkPhysicalDeviceFeatures::independentBlend,
    &VkPhysicalDeviceFeatures::largePoints,        &VkPhysicalDeviceFeatures::multiViewport,
    &VkPhysicalDeviceFeatures::sampleRateShading,  &VkPhysicalDeviceFeatures::shaderClipDistance,
    &VkPhysicalDeviceFeatures::shaderCullDistance, &VkPhysicalDeviceFeatures::wideLines,
};

}  // namespace

Features::Features() {
  core.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2;
  vulkan12.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES;
  vulkan13.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES;
  provokingVertex.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROVOKING_VERTEX_FEATURES_EXT;
  depthClipControl.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DEPTH_CLIP_CONTROL_FEATURES_EXT;
  depthClipEnable.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DEPTH_CLIP_ENABLE_FEATURES_EXT;
  lines.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_LINE_RASTERIZATION_FEATURES_EXT;
  listRestart.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PRIMITIVE_TOPOLOGY_LIST_RESTART_FEATURES_EXT;
}

VkPhysicalDeviceFeatures2* Features::chain() {
  core.pNext = nullptr;
  const auto link = [this](auto& structure, const char* extension) {
    const auto same = [extension](std::string_view name) { return name == extension; };
    if (extension && std::none_of(extensions.begin(), extensions.end(), same)) return;
    structure.pNext = core.pNext;
    core.pNext = &structure;
  };
  link(vulkan12, nullptr);
  link(vulkan13, nullptr);
  link(provokingVertex, VK_EXT_PROVOKING_VERTEX_EXTENSION_NAME);
  link(depthClipControl, VK_EXT_DEPTH_CLIP_CONTROL_EXTENSION_NAME);
  link(depthClipEnable, VK_EXT_DEPTH_CLIP_ENABLE_EXTENSION_NAME);
  link(lines, VK_EXT_LINE_RASTERIZATION_EXTENSION_NAME);
  link(listRestart, VK_EXT_PRIMITIVE_TOPOLOGY_LIST_RESTART_EXTENSION_NAME);
  return &core;
}

Features featuresOf(VkPhysicalDevice physicalDevice, const std::vector<std::string>& extensions) {
  Features offered;
  for (const char* name : {VK_EXT_PROVOKING_VERTEX_EXTENSION_NAME, VK_EXT_DEPTH_CLIP_CONTROL_EXTENSION_NAME,
                           VK_EXT_DEPTH_CLIP_ENABLE_EXTENSION_NAME, VK_EXT_LINE_RASTERIZATION_EXTENSION_NAME,
                           VK_EXT_PRIMITIVE_TOPOLOGY_LIST_RESTART_EXTENSION_NAME, VK_EXT_SAMPLE_LOCATIONS_EXTENSION_NAME}) {
    if (std::binary_search(extensions.begin(), extensions.end(), name)) offered.extensions.push_back(name);
  }
  vkGetPhysicalDeviceFeatures2(physicalDevice, offered.chain());

  Features kept;
  kept.extensions = offered.extensions;
  for (const auto feature : kCoreFeatures) kept.core.features.*feature = offered.core.features.*feature;
  kept.vulkan12.shaderOutputViewportIndex = offered.vulkan12.shaderOutputViewportIndex;
  kept.vulkan13.dynamicRendering = offered.vulkan13.dynamicRendering;
  kept.vulkan13.synchronization2 = offered.vulkan13.synchronization2;
  kept.provokingVertex.provokingVertexLast = offered.provokingVertex.provokingVertexLast;
  kept.depthClipControl.depthClipControl = offered.depthClipControl.depthClipControl;
  kept.depthClipEnable.depthClipEnable = offered.depthClipEnable.depthClipEnable;
  kept.lines = offered.lines;
  kept.listRestart.primitiveTopologyListRestart = offered.listRestart.primitiveTopologyListRestart;
  return kept;
}

}  // namespace rasterdiff::vkref
