// The optional features that scenes can ask for: what a device offers of them, which is also what is enabled.
#pragma once

#include <volk.h>

#include <string>
#include <vector>

namespace rasterdiff::vkref {

struct Features {
  VkPhysicalDeviceFeatures2 core{};
  VkPhysicalDeviceVulkan12Features vulkan12{};
  VkPhysicalDeviceVulkan13Features vulkan13{};
  VkPhysicalDeviceProvokingVertexFeaturesEXT provokingVertex{};
  VkPhysicalDeviceDepthClipControlFeaturesEXT depthClipControl{};
  VkPhysicalDeviceDepthClipEnableFeaturesEXT depthClipEnable{};
  VkPhysicalDeviceLineRasterizationFeaturesEXT lines{};
  VkPhysicalDevicePrimitiveTopologyListRestartFeaturesEXT listRestart{};
  std::vector<const char*> extensions;  ///< that the structures above need, and the device offers

  Features();
  /// All structures whose extension is offered as a chain; good while this object stays where it is.
  [[nodiscard]] VkPhysicalDeviceFeatures2* chain();
};

/// What the device offers of the features that scenes can ask for; all others are false. `extensions` is sorted.
[[nodiscard]] Features featuresOf(VkPhysicalDevice physicalDevice, const std::vector<std::string>& extensions);

}  // namespace rasterdiff::vkref
