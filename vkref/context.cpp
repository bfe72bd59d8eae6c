// Creates and destroys the logical device.
#include "vkref/context.hpp"

#include <fmt/format.h>

#include "vkref/vk_error.hpp"
#include "vkref/vk_struct.hpp"

namespace rasterdiff::vkref {

Result<std::unique_ptr<Context>> Context::create(VkPhysicalDevice physicalDevice, Capabilities caps) {
  std::vector<const char*> extensions;
  auto features13 = vkStruct<VkPhysicalDeviceVulkan13Features>(VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES);
  features13.dynamicRendering = VK_TRUE;
  features13.synchronization2 = VK_TRUE;
  auto features = vkStruct<VkPhysicalDeviceFeatures2>(VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2, &features13);
  features.features.independentBlend = VK_TRUE;
  features.features.geometryShader = caps.geometryShader;
  features.features.fullDrawIndexUint32 = caps.fullDrawIndexUint32;

  auto provoking = vkStruct<VkPhysicalDeviceProvokingVertexFeaturesEXT>(
      VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROVOKING_VERTEX_FEATURES_EXT);
  auto clip = vkStruct<VkPhysicalDeviceDepthClipControlFeaturesEXT>(
      VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DEPTH_CLIP_CONTROL_FEATURES_EXT);
  if (caps.limits.provokingVertexLast) {
    extensions.push_back(VK_EXT_PROVOKING_VERTEX_EXTENSION_NAME);
    provoking.provokingVertexLast = VK_TRUE;
    provoking.pNext = features.pNext;
    features.pNext = &provoking;
  }
  if (caps.limits.depthClipControl) {
    extensions.push_back(VK_EXT_DEPTH_CLIP_CONTROL_EXTENSION_NAME);
    clip.depthClipControl = VK_TRUE;
    clip.pNext = features.pNext;
    features.pNext = &clip;
  }

  const float priority = 1;
  auto queue = vkStruct<VkDeviceQueueCreateInfo>(VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO);
  queue.queueFamilyIndex = caps.queueFamily;
  queue.queueCount = 1;
  queue.pQueuePriorities = &priority;
  auto info = vkStruct<VkDeviceCreateInfo>(VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO, &features);
  info.queueCreateInfoCount = 1;
  info.pQueueCreateInfos = &queue;
  info.enabledExtensionCount = static_cast<uint32_t>(extensions.size());
  info.ppEnabledExtensionNames = extensions.data();

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
