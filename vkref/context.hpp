// The logical device with its queue and function table: what every other Vulkan object of this room is made from.
#pragma once

#include <volk.h>

#include <memory>

#include "scene/result.hpp"
#include "vkref/capabilities.hpp"

namespace rasterdiff::vkref {

struct Context {
  /// Enables exactly the features of `caps` that scenes can ask for. Error: NoDevice.
  [[nodiscard]] static Result<std::unique_ptr<Context>> create(VkPhysicalDevice physicalDevice, Capabilities caps);
  Context() = default;
  ~Context();
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  VkDevice device = VK_NULL_HANDLE;
  VkQueue queue = VK_NULL_HANDLE;
  VolkDeviceTable vk{};
  Capabilities caps;
  VkPhysicalDeviceMemoryProperties memory{};
};

}  // namespace rasterdiff::vkref
