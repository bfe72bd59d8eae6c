// Tables over the few formats that attachments have.
#include "vkref/formats.hpp"

namespace rasterdiff::vkref {

VkFormat varyingFormat(uint32_t components) {
  return components == 1   ? VK_FORMAT_R32_SFLOAT
         : components == 2 ? VK_FORMAT_R32G32_SFLOAT
                           : VK_FORMAT_R32G32B32A32_SFLOAT;
}

bool isDepthFormat(VkFormat format) {
  return format >= VK_FORMAT_D16_UNORM && format <= VK_FORMAT_D32_SFLOAT_S8_UINT;
}

bool hasStencil(VkFormat format) {
  return format == VK_FORMAT_D24_UNORM_S8_UINT || format == VK_FORMAT_D32_SFLOAT_S8_UINT;
}

uint32_t unormDepthBits(VkFormat format) {
  if (format == VK_FORMAT_D16_UNORM) return 16;
  return format == VK_FORMAT_X8_D24_UNORM_PACK32 || format == VK_FORMAT_D24_UNORM_S8_UINT ? 24 : 0;
}

VkDeviceSize texelBytes(VkFormat format) {
  switch (format) {
    case VK_FORMAT_D16_UNORM:
      return 2;
    case VK_FORMAT_R32G32_SFLOAT:
    case VK_FORMAT_D32_SFLOAT_S8_UINT:
      return 8;
    case VK_FORMAT_R32G32B32A32_SFLOAT:
      return 16;
    default:
      return 4;
  }
}

VkDeviceSize copiedBytes(VkFormat format) {
  return format == VK_FORMAT_D32_SFLOAT_S8_UINT ? 4 : texelBytes(format);
}

VkImageAspectFlags aspectOf(VkFormat format) {
  return isDepthFormat(format) ? VK_IMAGE_ASPECT_DEPTH_BIT : VK_IMAGE_ASPECT_COLOR_BIT;
}

VkImageAspectFlags allAspectsOf(VkFormat format) {
  return hasStencil(format) ? VK_IMAGE_ASPECT_DEPTH_BIT | VK_IMAGE_ASPECT_STENCIL_BIT : aspectOf(format);
}

VkImageLayout attachmentLayout(VkFormat format) {
  if (!isDepthFormat(format)) return VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
  return hasStencil(format) ? VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL
                            : VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL;
}

VkImageUsageFlags attachmentUsage(VkFormat format, uint32_t samples) {
  const VkImageUsageFlags attachment = isDepthFormat(format)
                                           ? VkImageUsageFlags{VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT}
                                           : VkImageUsageFlags{VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT};
  return attachment | (samples == 1 ? VkImageUsageFlags{VK_IMAGE_USAGE_TRANSFER_SRC_BIT}
                                    : VkImageUsageFlags{VK_IMAGE_USAGE_SAMPLED_BIT});
}

}  // namespace rasterdiff::vkref
