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

namespace rasterdiff::vkref {

inline constexpr VkFormat kPrimitiveFormat = VK_FORMAT_R32_UINT;
inline constexpr VkFormat kCountFormat = VK_FORMAT_R32_SFLOAT;
inline constexpr VkFormat kDepthFormat = VK_FORMAT_D32_SFLOAT;

/// Format of a varying's attachment, by components 1..4; three are stored as four.
[[nodiscard]] VkFormat varyingFormat(uint32_t components);
/// Components that a texel of one of our formats holds, 4 bytes each.
[[nodiscard]] uint32_t texelComponents(VkFormat format);

/// Usage of an attachment: read back by a copy at one sample, by a shader at several.
[[nodiscard]] VkImageUsageFlags attachmentUsage(VkFormat format, uint32_t samples);

struct Capabilities {
  VkPhysicalDeviceLimits vk{};  ///< as advertised
  Limits limits;
  DriverInfo driver;
  uint32_t queueFamily = 0;
  bool geometryShader = false;       ///< gl_PrimitiveID exists in fragment shaders
  bool fullDrawIndexUint32 = false;
  VkDeviceSize largestHeap = 0;      ///< bytes
};

/// Error: NoDevice with what the device lacks.
[[nodiscard]] Result<Capabilities> inspect(VkPhysicalDevice physicalDevice);

/// Names of the extensions a device offers.
[[nodiscard]] std::vector<std::string> extensionsOf(VkPhysicalDevice physicalDevice);

/// Further limits and features for a bug report, name and value.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> factsOf(VkPhysicalDevice physicalDevice);

}  // namespace rasterdiff::vkref
