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
  return counts & sampleCountsOf(physicalDevice, VK_FORMAT_D32_SFLOAT);
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

/// The knobs that the reference has to know; sample counts are asked for format by format elsewhere.
Limits limitsOf(const Features& features, const VkPhysicalDeviceLimits& vk, VkPointClippingBehavior clipping) {
  Limits limits;
  limits.subPixelPrecisionBits = vk.subPixelPrecisionBits;
  limits.viewportSubPixelBits = vk.viewportSubPixelBits;
  limits.standardSampleLocations = vk.standardSampleLocations;
  limits.maxFramebufferWidth = std::min(vk.maxFramebufferWidth, vk.maxImageDimension2D);
  limits.maxFramebufferHeight = std::min(vk.maxFramebufferHeight, vk.maxImageDimension2D);
  limits.provokingVertexLast = features.provokingVertex.provokingVertexLast;
  limits.depthClipControl = features.depthClipControl.depthClipControl;
  limits.strictLines = vk.strictLines;
  limits.rectangularLines = features.lines.rectangularLines;
  limits.bresenhamLines = features.lines.bresenhamLines;
  limits.smoothLines = features.lines.smoothLines;
  limits.stippledRectangularLines = features.lines.stippledRectangularLines;
  limits.stippledBresenhamLines = features.lines.stippledBresenhamLines;
  const bool wide = features.core.features.wideLines, large = features.core.features.largePoints;
  limits.lineWidthMin = wide ? vk.lineWidthRange[0] : 1;
  limits.lineWidthMax = wide ? vk.lineWidthRange[1] : 1;
  limits.lineWidthGranularity = wide ? vk.lineWidthGranularity : 0;
  limits.pointSizeMin = large ? vk.pointSizeRange[0] : 1;
  limits.pointSizeMax = large ? vk.pointSizeRange[1] : 1;
  limits.pointSizeGranularity = large ? vk.pointSizeGranularity : 0;
  limits.pointClippingBehavior = static_cast<PointClippingBehavior>(clipping);
  limits.subPixelInterpolationOffsetBits = vk.subPixelInterpolationOffsetBits;
  limits.minInterpolationOffset = vk.minInterpolationOffset;
  limits.maxInterpolationOffset = vk.maxInterpolationOffset;
  return limits;
}

/// [vk:VkPhysicalDeviceSampleLocationsPropertiesEXT]
void inspectSampleLocations(VkPhysicalDevice physicalDevice, Capabilities& caps) {
  const auto& extensions = caps.features.extensions;
  const auto same = [](std::string_view name) { return name == VK_EXT_SAMPLE_LOCATIONS_EXTENSION_NAME; };
  if (std::none_of(extensions.begin(), extensions.end(), same)) return;
  auto offered = vkStruct<VkPhysicalDeviceSampleLocationsPropertiesEXT>(
      VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_SAMPLE_LOCATIONS_PROPERTIES_EXT);
  auto properties = vkStruct<VkPhysicalDeviceProperties2>(VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2, &offered);
  vkGetPhysicalDeviceProperties2(physicalDevice, &properties);
  Limits& limits = caps.limits;
  limits.sampleLocationSampleCounts = offered.sampleLocationSampleCounts;
  limits.maxSampleLocationGridWidth = offered.maxSampleLocationGridSize.width;
  limits.maxSampleLocationGridHeight = offered.maxSampleLocationGridSize.height;
  limits.sampleLocationCoordinateMin = offered.sampleLocationCoordinateRange[0];
  limits.sampleLocationCoordinateMax = offered.sampleLocationCoordinateRange[1];
  limits.sampleLocationSubPixelBits = offered.sampleLocationSubPixelBits;
  for (size_t i = 0; i < caps.sampleLocationGrids.size(); ++i) {
    const auto samples = static_cast<VkSampleCountFlagBits>(1U << i);
    if (!(limits.sampleLocationSampleCounts & (1U << i))) continue;
    auto grid = vkStruct<VkMultisamplePropertiesEXT>(VK_STRUCTURE_TYPE_MULTISAMPLE_PROPERTIES_EXT);
    vkGetPhysicalDeviceMultisamplePropertiesEXT(physicalDevice, samples, &grid);
    caps.sampleLocationGrids[i] = grid.maxSampleLocationGridSize;
  }
}

}  // namespace

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
  auto clipping = vkStruct<VkPhysicalDevicePointClippingProperties>(
      VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_POINT_CLIPPING_PROPERTIES, &driver);
  auto resolve = vkStruct<VkPhysicalDeviceDepthStencilResolveProperties>(
      VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DEPTH_STENCIL_RESOLVE_PROPERTIES, &clipping);
  auto properties = vkStruct<VkPhysicalDeviceProperties2>(VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2, &resolve);
  vkGetPhysicalDeviceProperties2(physicalDevice, &properties);
  caps.depthResolveModes = resolve.supportedDepthResolveModes;
  caps.driver = {driver.driverName, driver.driverInfo, base.deviceName, versionText(base.apiVersion), {}, {}};
  if (caps.driver.info.empty()) caps.driver.info = "driver version " + versionText(base.driverVersion);

  caps.features = featuresOf(physicalDevice, extensionsOf(physicalDevice));
  if (!caps.features.vulkan13.dynamicRendering) return lacks("dynamicRendering is not offered");
  if (!caps.features.vulkan13.synchronization2) return lacks("synchronization2 is not offered");
  if (!caps.core().independentBlend) return lacks("independentBlend is not offered");

  VkFormatProperties count{};
  vkGetPhysicalDeviceFormatProperties(physicalDevice, kCountFormat, &count);
  if (!(count.optimalTilingFeatures & VK_FORMAT_FEATURE_COLOR_ATTACHMENT_BLEND_BIT)) {
    return lacks("R32_SFLOAT attachments cannot be blended, so overdraw cannot be counted");
  }

  caps.limits = limitsOf(caps.features, base.limits, clipping.pointClippingBehavior);
  caps.limits.framebufferSampleCounts = framebufferSampleCounts(physicalDevice, base.limits);
  inspectSampleLocations(physicalDevice, caps);
  for (size_t i = 0; i < kDepthFormats.size(); ++i) {
    caps.depthSampleCounts[i] = sampleCountsOf(physicalDevice, static_cast<VkFormat>(kDepthFormats[i]));
  }
  if (!(caps.limits.framebufferSampleCounts & VK_SAMPLE_COUNT_1_BIT)) {
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
