// Asks a physical device for limits, features and formats, and refuses one that cannot run any scene.
#include "vkref/capabilities.hpp"
#include "vkref/vk_struct.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rasterdiff::vkref {
namespace {

constexpr std::array kColorFormats = {VK_FORMAT_R32_UINT, VK_FORMAT_R32_SFLOAT, VK_FORMAT_R32G32_SFLOAT,
                                      VK_FORMAT_R32G32B32A32_SFLOAT};

tl::unexpected<Error> lacks(std::string what) {
  return fail(ErrorCode::NoDevice, "device", std::move(what));
}

std::string versionText(uint32_t version) {
  return fmt::format("{}.{}.{}", VK_API_VERSION_MAJOR(version), VK_API_VERSION_MINOR(version),
                     VK_API_VERSION_PATCH(version));
}

/// Sample counts at which an image of `format` can be rendered to and read back; 0 if not even one.
VkSampleCountFlags sampleCountsOf(VkPhysicalDevice physicalDevice, VkFormat format) {
  const auto offered = [&](uint32_t samples) -> VkSampleCountFlags {
    VkImageFormatProperties properties{};
    const VkResult result = vkGetPhysicalDeviceImageFormatProperties(
        physicalDevice, format, VK_IMAGE_TYPE_2D, VK_IMAGE_TILING_OPTIMAL, attachmentUsage(format, samples), 0,
        &properties);
    return result == VK_SUCCESS ? properties.sampleCounts : 0;
  };
  const VkSampleCountFlags several = offered(2) & ~VkSampleCountFlags{VK_SAMPLE_COUNT_1_BIT};
  const VkSampleCountFlags one = offered(1) & VK_SAMPLE_COUNT_1_BIT;
  return one ? one | several : 0;
}

/// framebufferIntegerColorSampleCounts is left out: it states a minimum over all integer formats, and both lavapipe
/// and SwiftShader offer more for R32_UINT when they are asked for that format.
VkSampleCountFlags framebufferSampleCounts(VkPhysicalDevice physicalDevice, const VkPhysicalDeviceLimits& limits) {
  VkSampleCountFlags counts = limits.framebufferColorSampleCounts & limits.framebufferDepthSampleCounts;
  for (VkFormat format : kColorFormats) counts &= sampleCountsOf(physicalDevice, format);
  return counts & sampleCountsOf(physicalDevice, kDepthFormat);
}

Result<uint32_t> queueFamilyOf(VkPhysicalDevice physicalDevice) {
  uint32_t count = 0;
  vkGetPhysicalDeviceQueueFamilyProperties(physicalDevice, &count, nullptr);
  std::vector<VkQueueFamilyProperties> families(count);
  vkGetPhysicalDeviceQueueFamilyProperties(physicalDevice, &count, families.data());
  constexpr VkQueueFlags kNeeded = VK_QUEUE_GRAPHICS_BIT | VK_QUEUE_COMPUTE_BIT;
  for (uint32_t i = 0; i < count; ++i) {
    if ((families[i].queueFlags & kNeeded) == kNeeded) return i;
  }
  return lacks("no queue family for graphics and compute");
}

}  // namespace

VkFormat varyingFormat(uint32_t components) {
  return components == 1   ? VK_FORMAT_R32_SFLOAT
         : components == 2 ? VK_FORMAT_R32G32_SFLOAT
                           : VK_FORMAT_R32G32B32A32_SFLOAT;
}

uint32_t texelComponents(VkFormat format) {
  return format == VK_FORMAT_R32G32B32A32_SFLOAT ? 4 : format == VK_FORMAT_R32G32_SFLOAT ? 2 : 1;
}

VkImageUsageFlags attachmentUsage(VkFormat format, uint32_t samples) {
  const VkImageUsageFlags attachment = format == kDepthFormat
                                           ? VkImageUsageFlags{VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT}
                                           : VkImageUsageFlags{VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT};
  return attachment | (samples == 1 ? VkImageUsageFlags{VK_IMAGE_USAGE_TRANSFER_SRC_BIT}
                                    : VkImageUsageFlags{VK_IMAGE_USAGE_SAMPLED_BIT});
}

std::vector<std::string> extensionsOf(VkPhysicalDevice physicalDevice) {
  uint32_t count = 0;
  vkEnumerateDeviceExtensionProperties(physicalDevice, nullptr, &count, nullptr);
  std::vector<VkExtensionProperties> properties(count);
  vkEnumerateDeviceExtensionProperties(physicalDevice, nullptr, &count, properties.data());
  std::vector<std::string> names;
  for (const VkExtensionProperties& property : properties) names.emplace_back(property.extensionName);
  std::sort(names.begin(), names.end());
  return names;
}

Result<Capabilities> inspect(VkPhysicalDevice physicalDevice) {
  Capabilities caps;
  VkPhysicalDeviceProperties base{};
  vkGetPhysicalDeviceProperties(physicalDevice, &base);
  caps.vk = base.limits;
  if (base.apiVersion < VK_API_VERSION_1_3) {
    return lacks(fmt::format("{} offers Vulkan {}, 1.3 is needed", base.deviceName, versionText(base.apiVersion)));
  }
  auto driver = vkStruct<VkPhysicalDeviceDriverProperties>(VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DRIVER_PROPERTIES);
  auto properties = vkStruct<VkPhysicalDeviceProperties2>(VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2, &driver);
  vkGetPhysicalDeviceProperties2(physicalDevice, &properties);
  caps.driver = {driver.driverName, driver.driverInfo, base.deviceName, versionText(base.apiVersion), {}, {}};
  if (caps.driver.info.empty()) caps.driver.info = "driver version " + versionText(base.driverVersion);

  const std::vector<std::string> extensions = extensionsOf(physicalDevice);
  const auto has = [&](const char* name) { return std::binary_search(extensions.begin(), extensions.end(), name); };

  auto features13 = vkStruct<VkPhysicalDeviceVulkan13Features>(VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES);
  auto features = vkStruct<VkPhysicalDeviceFeatures2>(VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2, &features13);
  auto provoking = vkStruct<VkPhysicalDeviceProvokingVertexFeaturesEXT>(
      VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROVOKING_VERTEX_FEATURES_EXT);
  auto clip = vkStruct<VkPhysicalDeviceDepthClipControlFeaturesEXT>(
      VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DEPTH_CLIP_CONTROL_FEATURES_EXT);
  if (has(VK_EXT_PROVOKING_VERTEX_EXTENSION_NAME)) {
    provoking.pNext = features.pNext;
    features.pNext = &provoking;
  }
  if (has(VK_EXT_DEPTH_CLIP_CONTROL_EXTENSION_NAME)) {
    clip.pNext = features.pNext;
    features.pNext = &clip;
  }
  vkGetPhysicalDeviceFeatures2(physicalDevice, &features);
  if (!features13.dynamicRendering) return lacks("dynamicRendering is not offered");
  if (!features13.synchronization2) return lacks("synchronization2 is not offered");
  if (!features.features.independentBlend) return lacks("independentBlend is not offered");
  caps.geometryShader = features.features.geometryShader;
  caps.fullDrawIndexUint32 = features.features.fullDrawIndexUint32;

  VkFormatProperties count{};
  vkGetPhysicalDeviceFormatProperties(physicalDevice, kCountFormat, &count);
  if (!(count.optimalTilingFeatures & VK_FORMAT_FEATURE_COLOR_ATTACHMENT_BLEND_BIT)) {
    return lacks("R32_SFLOAT attachments cannot be blended, so overdraw cannot be counted");
  }

  Limits& limits = caps.limits;
  limits.subPixelPrecisionBits = base.limits.subPixelPrecisionBits;
  limits.viewportSubPixelBits = base.limits.viewportSubPixelBits;
  limits.framebufferSampleCounts = framebufferSampleCounts(physicalDevice, base.limits);
  limits.standardSampleLocations = base.limits.standardSampleLocations;
  limits.maxFramebufferWidth = std::min(base.limits.maxFramebufferWidth, base.limits.maxImageDimension2D);
  limits.maxFramebufferHeight = std::min(base.limits.maxFramebufferHeight, base.limits.maxImageDimension2D);
  limits.provokingVertexLast = provoking.provokingVertexLast;
  limits.depthClipControl = clip.depthClipControl;
  if (!(limits.framebufferSampleCounts & VK_SAMPLE_COUNT_1_BIT)) {
    return lacks("an attachment format (R32_UINT, R32/RG32/RGBA32_SFLOAT, D32_SFLOAT) is not offered");
  }

  const Result<uint32_t> family = queueFamilyOf(physicalDevice);
  if (!family) return tl::unexpected(family.error());
  caps.queueFamily = *family;
  VkPhysicalDeviceMemoryProperties memory{};
  vkGetPhysicalDeviceMemoryProperties(physicalDevice, &memory);
  for (uint32_t i = 0; i < memory.memoryHeapCount; ++i) {
    caps.largestHeap = std::max(caps.largestHeap, memory.memoryHeaps[i].size);
  }
  return caps;
}

}  // namespace rasterdiff::vkref
