// Buffers and images with the memory behind them.
#pragma once

#include <cstddef>
#include <memory>

#include "vkref/owned.hpp"

namespace rasterdiff::vkref {

/// Host-visible, coherent, mapped for life; host-cached where the device offers it.
struct Buffer {
  struct Key {
    VkDeviceSize bytes = 0;
    VkBufferUsageFlags usage = 0;
    friend bool operator==(const Key&, const Key&) = default;
  };
  [[nodiscard]] static Result<std::unique_ptr<Buffer>> create(const Context& context, const Key& key);

  Key key;
  OwnedMemory memory;
  OwnedBuffer buffer;
  std::byte* mapped = nullptr;
};

/// A two-dimensional attachment with one view of all of it.
struct Image {
  struct Key {
    VkFormat format = VK_FORMAT_UNDEFINED;
    uint32_t width = 0, height = 0, samples = 1;
    friend bool operator==(const Key&, const Key&) = default;
  };
  [[nodiscard]] static Result<std::unique_ptr<Image>> create(const Context& context, const Key& key);
  /// Bytes of its texels, without a driver's padding.
  [[nodiscard]] static VkDeviceSize bytesOf(const Key& key);

  Key key;
  OwnedMemory memory;
  OwnedImage image;
  OwnedImageView view;
};

}  // namespace rasterdiff::vkref
