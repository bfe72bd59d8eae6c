// The formats of our attachments: what they hold, how they are used, how large they are.
#pragma once

#include <volk.h>

#include <array>
#include <cstdint>

#include "scene/vulkan_enums.hpp"

namespace rasterdiff::vkref {

inline constexpr VkFormat kPrimitiveFormat = VK_FORMAT_R32_UINT;
inline constexpr VkFormat kCountFormat = VK_FORMAT_R32_SFLOAT;
inline constexpr std::array kDepthFormats = {DepthFormat::D16_UNORM, DepthFormat::X8_D24_UNORM_PACK32,
                                             DepthFormat::D32_SFLOAT, DepthFormat::D24_UNORM_S8_UINT,
                                             DepthFormat::D32_SFLOAT_S8_UINT};

/// Format of a varying's or built-in's attachment, by components 1..4; three are stored as four.
[[nodiscard]] VkFormat varyingFormat(uint32_t components);
[[nodiscard]] bool isDepthFormat(VkFormat format);
[[nodiscard]] bool hasStencil(VkFormat format);
/// Bits of a depth that is stored as an unsigned normalized integer; 0 for one that is stored as a float.
[[nodiscard]] uint32_t unormDepthBits(VkFormat format);

/// Bytes of a texel, stencil included.
[[nodiscard]] VkDeviceSize texelBytes(VkFormat format);
/// Bytes a texel takes in a buffer that our aspect of an image is copied to. [vk:VkBufferImageCopy]
[[nodiscard]] VkDeviceSize copiedBytes(VkFormat format);

/// The aspect that we draw to and read; a depth format's stencil is never used.
[[nodiscard]] VkImageAspectFlags aspectOf(VkFormat format);
/// All aspects: layout transitions take them together.
[[nodiscard]] VkImageAspectFlags allAspectsOf(VkFormat format);
[[nodiscard]] VkImageLayout attachmentLayout(VkFormat format);
/// Usage of an attachment: read back by a copy at one sample, by a shader at several.
[[nodiscard]] VkImageUsageFlags attachmentUsage(VkFormat format, uint32_t samples);

}  // namespace rasterdiff::vkref
