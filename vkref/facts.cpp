// Limits, features, extensions and formats that a bug report about rasterization should state.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "vkref/capabilities.hpp"
#include "vkref/vk_struct.hpp"

namespace rasterdiff::vkref {
namespace {

using Facts = std::vector<std::pair<std::string, std::string>>;

std::string yesNo(bool value) { return value ? "yes" : "no"; }

/// "1, 4"
std::string countsText(VkSampleCountFlags counts) {
  std::string text;
  for (uint32_t samples = 1; samples <= 64; samples *= 2) {
    if (counts & samples) text += fmt::format("{}{}", text.empty() ? "" : ", ", samples);
  }
  return text.empty() ? "none" : text;
}

void addLimits(const VkPhysicalDeviceLimits& limits, Facts& facts) {
  const auto add = [&facts](const char* name, std::string value) { facts.emplace_back(name, std::move(value)); };
  add("subPixelPrecisionBits", fmt::format("{}", limits.subPixelPrecisionBits));
  add("viewportSubPixelBits", fmt::format("{}", limits.viewportSubPixelBits));
  add("subPixelInterpolationOffsetBits", fmt::format("{}", limits.subPixelInterpolationOffsetBits));
  add("interpolationOffset", fmt::format("{}..{}", limits.minInterpolationOffset, limits.maxInterpolationOffset));
  add("maxFramebuffer", fmt::format("{} × {}", limits.maxFramebufferWidth, limits.maxFramebufferHeight));
  add("maxViewportDimensions",
      fmt::format("{} × {}", limits.maxViewportDimensions[0], limits.maxViewportDimensions[1]));
  add("viewportBoundsRange", fmt::format("{}..{}", limits.viewportBoundsRange[0], limits.viewportBoundsRange[1]));
  add("maxViewports", fmt::format("{}", limits.maxViewports));
  add("maxColorAttachments", fmt::format("{}", limits.maxColorAttachments));
  add("maxClipDistances", fmt::format("{}", limits.maxClipDistances));
  add("maxCullDistances", fmt::format("{}", limits.maxCullDistances));
  add("standardSampleLocations", yesNo(limits.standardSampleLocations));
  add("strictLines", yesNo(limits.strictLines));
  add("lineWidthRange", fmt::format("{}..{}", limits.lineWidthRange[0], limits.lineWidthRange[1]));
  add("lineWidthGranularity", fmt::format("{}", limits.lineWidthGranularity));
  add("pointSizeRange", fmt::format("{}..{}", limits.pointSizeRange[0], limits.pointSizeRange[1]));
  add("pointSizeGranularity", fmt::format("{}", limits.pointSizeGranularity));
  add("maxStorageBufferRange", fmt::format("{}", limits.maxStorageBufferRange));
}

void addFeatures(VkPhysicalDevice physicalDevice, const std::vector<std::string>& extensions, Facts& facts) {
  const bool lines = std::binary_search(extensions.begin(), extensions.end(), VK_EXT_LINE_RASTERIZATION_EXTENSION_NAME);
  auto line = vkStruct<VkPhysicalDeviceLineRasterizationFeaturesEXT>(
      VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_LINE_RASTERIZATION_FEATURES_EXT);
  auto features = vkStruct<VkPhysicalDeviceFeatures2>(
      VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2, lines ? &line : nullptr);
  vkGetPhysicalDeviceFeatures2(physicalDevice, &features);
  const VkPhysicalDeviceFeatures& core = features.features;
  const std::pair<const char*, VkBool32> named[] = {
      {"geometryShader", core.geometryShader},
      {"fillModeNonSolid", core.fillModeNonSolid},
      {"wideLines", core.wideLines},
      {"largePoints", core.largePoints},
      {"depthClamp", core.depthClamp},
      {"depthBiasClamp", core.depthBiasClamp},
      {"depthBounds", core.depthBounds},
      {"alphaToOne", core.alphaToOne},
      {"multiViewport", core.multiViewport},
      {"sampleRateShading", core.sampleRateShading},
      {"shaderClipDistance", core.shaderClipDistance},
      {"shaderCullDistance", core.shaderCullDistance},
      {"shaderFloat64", core.shaderFloat64},
      {"fragmentStoresAndAtomics", core.fragmentStoresAndAtomics},
      {"fullDrawIndexUint32", core.fullDrawIndexUint32},
      {"rectangularLines", line.rectangularLines},
      {"bresenhamLines", line.bresenhamLines},
      {"smoothLines", line.smoothLines},
      {"stippledRectangularLines", line.stippledRectangularLines},
      {"stippledBresenhamLines", line.stippledBresenhamLines},
      {"stippledSmoothLines", line.stippledSmoothLines},
  };
  for (const auto& [name, offered] : named) facts.emplace_back(name, yesNo(offered));
}

void addExtensions(const std::vector<std::string>& extensions, Facts& facts) {
  constexpr const char* kNames[] = {
      VK_EXT_CONSERVATIVE_RASTERIZATION_EXTENSION_NAME, VK_EXT_DEPTH_CLIP_CONTROL_EXTENSION_NAME,
      VK_EXT_DEPTH_CLIP_ENABLE_EXTENSION_NAME,          VK_EXT_DEPTH_RANGE_UNRESTRICTED_EXTENSION_NAME,
      VK_EXT_EXTENDED_DYNAMIC_STATE_3_EXTENSION_NAME,   VK_EXT_LINE_RASTERIZATION_EXTENSION_NAME,
      VK_EXT_PROVOKING_VERTEX_EXTENSION_NAME,           VK_EXT_SAMPLE_LOCATIONS_EXTENSION_NAME,
      VK_KHR_FRAGMENT_SHADER_BARYCENTRIC_EXTENSION_NAME, VK_KHR_FRAGMENT_SHADING_RATE_EXTENSION_NAME,
  };
  for (const char* name : kNames) {
    facts.emplace_back(name, yesNo(std::binary_search(extensions.begin(), extensions.end(), name)));
  }
}

void addFormats(VkPhysicalDevice physicalDevice, Facts& facts) {
  const std::pair<const char*, VkFormat> formats[] = {
      {"R32_UINT", VK_FORMAT_R32_UINT},
      {"R32_SFLOAT", VK_FORMAT_R32_SFLOAT},
      {"R32G32_SFLOAT", VK_FORMAT_R32G32_SFLOAT},
      {"R32G32B32A32_SFLOAT", VK_FORMAT_R32G32B32A32_SFLOAT},
      {"D16_UNORM", VK_FORMAT_D16_UNORM},
      {"X8_D24_UNORM_PACK32", VK_FORMAT_X8_D24_UNORM_PACK32},
      {"D32_SFLOAT", VK_FORMAT_D32_SFLOAT},
      {"D24_UNORM_S8_UINT", VK_FORMAT_D24_UNORM_S8_UINT},
      {"D32_SFLOAT_S8_UINT", VK_FORMAT_D32_SFLOAT_S8_UINT},
  };
  for (const auto& [name, format] : formats) {
    const bool depth = format >= VK_FORMAT_D16_UNORM && format <= VK_FORMAT_D32_SFLOAT_S8_UINT;
    VkImageFormatProperties properties{};
    const VkResult result = vkGetPhysicalDeviceImageFormatProperties(
        physicalDevice, format, VK_IMAGE_TYPE_2D, VK_IMAGE_TILING_OPTIMAL,
        depth ? VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT : VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT, 0, &properties);
    facts.emplace_back(fmt::format("samples of {}", name),
                       countsText(result == VK_SUCCESS ? properties.sampleCounts : 0));
  }
}

}  // namespace

Facts factsOf(VkPhysicalDevice physicalDevice) {
  Facts facts;
  VkPhysicalDeviceProperties properties{};
  vkGetPhysicalDeviceProperties(physicalDevice, &properties);
  addLimits(properties.limits, facts);
  const std::vector<std::string> extensions = extensionsOf(physicalDevice);
  addFeatures(physicalDevice, extensions, facts);
  addExtensions(extensions, facts);
  addFormats(physicalDevice, facts);
  std::error_code error;
  const bool settings = std::filesystem::exists("SwiftShader.ini", error);
  if (settings && std::string_view(properties.deviceName).starts_with("SwiftShader")) {
    facts.emplace_back("SwiftShader.ini", "in the current folder: it changes how this driver works");
  }
  return facts;
}

}  // namespace rasterdiff::vkref
