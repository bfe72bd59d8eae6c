// Creates buffers and images and binds memory to them; reuse is the pool's business.
#include "vkref/memory.hpp"

#include <fmt/format.h>

#include "vkref/vk_error.hpp"
#include "vkref/vk_struct.hpp"

namespace rasterdiff::vkref {
namespace {

/// Index of the first memory type of `allowed` with all of `flags`; -1 if there is none.
int memoryType(const Context& context, uint32_t allowed, VkMemoryPropertyFlags flags) {
  for (uint32_t i = 0; i < context.memory.memoryTypeCount; ++i) {
    const bool fits = (context.memory.memoryTypes[i].propertyFlags & flags) == flags;
    if ((allowed & (1U << i)) && fits) return static_cast<int>(i);
  }
  return -1;
}

/// Allocates from the first of `preferences` that the device has.
Result<OwnedMemory> allocate(const Context& context, const VkMemoryRequirements& needs,
                             std::initializer_list<VkMemoryPropertyFlags> preferences) {
  int type = -1;
  for (auto it = preferences.begin(); type < 0 && it != preferences.end(); ++it) {
    type = memoryType(context, needs.memoryTypeBits, *it);
  }
  if (type < 0) return fail(ErrorCode::NotOffered, "memory", "the device has no memory of the type that is needed");
  auto info = vkStruct<VkMemoryAllocateInfo>(VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO);
  info.allocationSize = needs.size;
  info.memoryTypeIndex = static_cast<uint32_t>(type);
  VkDeviceMemory memory = VK_NULL_HANDLE;
  VKREF_TRY(context.vk.vkAllocateMemory(context.device, &info, nullptr, &memory));
  return OwnedMemory(context, memory);
}

}  // namespace

Result<std::unique_ptr<Buffer>> Buffer::create(const Context& context, const Key& key) {
  auto self = std::make_unique<Buffer>();
  self->key = key;
  auto info = vkStruct<VkBufferCreateInfo>(VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO);
  info.size = key.bytes;
  info.usage = key.usage;
  VkBuffer buffer = VK_NULL_HANDLE;
  VKREF_TRY(context.vk.vkCreateBuffer(context.device, &info, nullptr, &buffer));
  self->buffer = OwnedBuffer(context, buffer);

  VkMemoryRequirements needs{};
  context.vk.vkGetBufferMemoryRequirements(context.device, buffer, &needs);
  constexpr VkMemoryPropertyFlags kCoherent =
      VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
  Result<OwnedMemory> memory = allocate(context, needs, {kCoherent | VK_MEMORY_PROPERTY_HOST_CACHED_BIT, kCoherent});
  if (!memory) return tl::unexpected(memory.error());
  self->memory = std::move(*memory);
  VKREF_TRY(context.vk.vkBindBufferMemory(context.device, buffer, self->memory.get(), 0));
  void* mapped = nullptr;
  VKREF_TRY(context.vk.vkMapMemory(context.device, self->memory.get(), 0, VK_WHOLE_SIZE, 0, &mapped));
  self->mapped = static_cast<std::byte*>(mapped);
  return self;
}

VkDeviceSize Image::bytesOf(const Key& key) {
  return VkDeviceSize{key.width} * key.height * key.samples * texelBytes(key.format);
}

Result<std::unique_ptr<Image>> Image::create(const Context& context, const Key& key) {
  auto self = std::make_unique<Image>();
  self->key = key;
  auto info = vkStruct<VkImageCreateInfo>(VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO);
  info.imageType = VK_IMAGE_TYPE_2D;
  info.format = key.format;
  info.extent = {key.width, key.height, 1};
  info.mipLevels = 1;
  info.arrayLayers = 1;
  info.samples = static_cast<VkSampleCountFlagBits>(key.samples);
  info.tiling = VK_IMAGE_TILING_OPTIMAL;
  info.usage = attachmentUsage(key.format, key.samples);
  VkImage image = VK_NULL_HANDLE;
  VKREF_TRY(context.vk.vkCreateImage(context.device, &info, nullptr, &image));
  self->image = OwnedImage(context, image);

  VkMemoryRequirements needs{};
  context.vk.vkGetImageMemoryRequirements(context.device, image, &needs);
  Result<OwnedMemory> memory = allocate(context, needs, {VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT, 0});
  if (!memory) return tl::unexpected(memory.error());
  self->memory = std::move(*memory);
  VKREF_TRY(context.vk.vkBindImageMemory(context.device, image, self->memory.get(), 0));

  auto viewInfo = vkStruct<VkImageViewCreateInfo>(VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO);
  viewInfo.image = image;
  viewInfo.viewType = VK_IMAGE_VIEW_TYPE_2D;
  viewInfo.format = key.format;
  viewInfo.subresourceRange = {aspectOf(key.format), 0, 1, 0, 1};
  VkImageView view = VK_NULL_HANDLE;
  VKREF_TRY(context.vk.vkCreateImageView(context.device, &viewInfo, nullptr, &view));
  self->view = OwnedImageView(context, view);
  return self;
}

}  // namespace rasterdiff::vkref
