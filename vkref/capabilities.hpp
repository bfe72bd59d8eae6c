// What a physical device offers, asked once: all that decides whether and how a scene can be drawn on it.
#pragma once

#include <volk.h>

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "scene/limits.hpp"
#include "scene/result.hpp"
#include "vkref/device.hpp"
#include "vkref/features.hpp"
#include "vkref/formats.hpp"

namespace rasterdiff::vkref {

struct Capabilities {
  VkPhysicalDeviceLimits vk{};  ///< as advertised
  Limits limits;
  DriverInfo driver;
  uint32_t queueFamily = 0;
  Features features;            ///< offered and enabled
  std::array<VkSampleCountFlags, kDepthFormats.size()> depthSampleCounts{};  ///< as kDepthFormats; 0: not offered
  VkResolveModeFlags depthResolveModes = 0;
  std::array<VkExtent2D, 5> sampleLocationGrids{};  ///< largest, for 1, 2, 4, 8 and 16 samples; 0 × 0: not offered
  VkDeviceSize largestHeap = 0;  ///< bytes

  [[nodiscard]] const VkPhysicalDeviceFeatures& core() const { return features.core.features; }
};

/// Error: NoDevice with what the device lacks.
[[nodiscard]] Result<Capabilities> inspect(VkPhysicalDevice physicalDevice);

/// Names of the extensions a device offers.
[[nodiscard]] std::vector<std::string> extensionsOf(VkPhysicalDevice physicalDevice);

/// Further limits and features for a bug report, name and value.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> factsOf(VkPhysicalDevice physicalDevice);

}  // namespace rasterdiff::vkref
