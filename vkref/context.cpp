// Creates and destroys the logical device.
#include "vkref/context.hpp"

#include <fmt/format.h>

#include "vkref/vk_error.hpp"
#include "vkref/vk_struct.hpp"

namespace rasterdiff::vkref {

Result<std::unique_ptr<Context>> Context::create(VkPhysicalDevice physicalDevice, Capabilities caps) {
  const float priority = 1;
  auto queue = vkStruct<VkDeviceQueueCreateInfo>(VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO);
  queue.queueFamilyIndex = caps.queueFamily;
  queue.queueCount = 1;
  queue.pQueuePriorities = &priority;
  auto info = vkStruct<VkDeviceCreateInfo>(VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO, caps.features.chain());
  info.queueCreateInfoCount = 1;
  info.pQueueCreateInfos = &queue;
  info.enabledExtensionCount = static_cast<uint32_t>(caps.features.extensions.size());
  info.ppEnabledExtensionNames = caps.features.extensions.data();

  auto self = std::make_unique<Context>();
  if (const VkResult result = vkCreateDevice(physicalDevice, &info, nullptr, &self->device); result != VK_SUCCESS) {
    self->device = VK_NULL_HANDLE;
    return fail(ErrorCode::NoDevice, caps.driver.deviceName,
                fmt::format("vkCreateDevice returned {}", resultName(result)));
  }
  volkLoadDeviceTable(&self->vk, self->device);
  self->vk.vkGetDeviceQueue(self->device, caps.queueFamily, 0, &self->queue);
  vkGetPhysicalDeviceMemoryProperties(physicalDevice, &self->memory);
  self->caps = std::move(caps);
  return self;
}

Context::~Context() {
  if (device) vk.vkDestroyDevice(device, nullptr);
}

}  // namespace rasterdiff::vkref
