// Ownership of device objects: a handle that destroys itself.
#pragma once

#include <volk.h>

#include <utility>

#include "vkref/context.hpp"

namespace rasterdiff::vkref {

/// `kDestroy` is the member of VolkDeviceTable that destroys a T.
template <class T, auto kDestroy>
class Owned {
 public:
  Owned() = default;
  Owned(const Context& context, T handle) : context_(&context), handle_(handle) {}
  Owned(Owned&& other) noexcept
      : context_(std::exchange(other.context_, nullptr)), handle_(std::exchange(other.handle_, T{})) {}
  Owned& operator=(Owned&& other) noexcept {
    std::swap(context_, other.context_);
    std::swap(handle_, other.handle_);
    return *this;
  }
  ~Owned() {
    if (handle_) (context_->vk.*kDestroy)(context_->device, handle_, nullptr);
  }

  [[nodiscard]] T get() const { return handle_; }
  explicit operator bool() const { return handle_ != T{}; }

 private:
  const Context* context_ = nullptr;
  T handle_{};
};

using OwnedBuffer = Owned<VkBuffer, &VolkDeviceTable::vkDestroyBuffer>;
using OwnedImage = Owned<VkImage, &VolkDeviceTable::vkDestroyImage>;
using OwnedImageView = Owned<VkImageView, &VolkDeviceTable::vkDestroyImageView>;
using OwnedMemory = Owned<VkDeviceMemory, &VolkDeviceTable::vkFreeMemory>;
using OwnedShaderModule = Owned<VkShaderModule, &VolkDeviceTable::vkDestroyShaderModule>;
using OwnedPipeline = Owned<VkPipeline, &VolkDeviceTable::vkDestroyPipeline>;
using OwnedPipelineLayout = Owned<VkPipelineLayout, &VolkDeviceTable::vkDestroyPipelineLayout>;
using OwnedPipelineCache = Owned<VkPipelineCache, &VolkDeviceTable::vkDestroyPipelineCache>;
using OwnedDescriptorSetLayout = Owned<VkDescriptorSetLayout, &VolkDeviceTable::vkDestroyDescriptorSetLayout>;
using OwnedDescriptorPool = Owned<VkDescriptorPool, &VolkDeviceTable::vkDestroyDescriptorPool>;
using OwnedCommandPool = Owned<VkCommandPool, &VolkDeviceTable::vkDestroyCommandPool>;
using OwnedFence = Owned<VkFence, &VolkDeviceTable::vkDestroyFence>;

}  // namespace rasterdiff::vkref
