// The command pool, its one command buffer and its fence.
#include "vkref/submission.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "vkref/vk_error.hpp"
#include "vkref/vk_struct.hpp"

namespace rasterdiff::vkref {
namespace {

uint64_t nanoseconds(double seconds) {
  constexpr double kYear = 365.0 * 24 * 3600;  // far below 2^64 ns
  return static_cast<uint64_t>(std::clamp(seconds, 0.0, kYear) * 1e9);
}

}  // namespace

Result<std::unique_ptr<Submission>> Submission::create(const Context& context, double timeoutSeconds) {
  std::unique_ptr<Submission> self(new Submission(context));
  self->timeoutSeconds_ = timeoutSeconds;
  auto poolInfo = vkStruct<VkCommandPoolCreateInfo>(VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO);
  poolInfo.flags = VK_COMMAND_POOL_CREATE_TRANSIENT_BIT;
  poolInfo.queueFamilyIndex = context.caps.queueFamily;
  VkCommandPool pool = VK_NULL_HANDLE;
  VKREF_TRY(context.vk.vkCreateCommandPool(context.device, &poolInfo, nullptr, &pool));
  self->pool_ = OwnedCommandPool(context, pool);

  auto allocateInfo = vkStruct<VkCommandBufferAllocateInfo>(VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO);
  allocateInfo.commandPool = pool;
  allocateInfo.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
  allocateInfo.commandBufferCount = 1;
  VKREF_TRY(context.vk.vkAllocateCommandBuffers(context.device, &allocateInfo, &self->commands_));

  const auto fenceInfo = vkStruct<VkFenceCreateInfo>(VK_STRUCTURE_TYPE_FENCE_CREATE_INFO);
  VkFence fence = VK_NULL_HANDLE;
  VKREF_TRY(context.vk.vkCreateFence(context.device, &fenceInfo, nullptr, &fence));
  self->fence_ = OwnedFence(context, fence);
  return self;
}

Result<VkCommandBuffer> Submission::begin() {
  VKREF_TRY(context_.vk.vkResetCommandPool(context_.device, pool_.get(), 0));
  auto info = vkStruct<VkCommandBufferBeginInfo>(VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO);
  info.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
  VKREF_TRY(context_.vk.vkBeginCommandBuffer(commands_, &info));
  return commands_;
}

Result<void> Submission::run() {
  VKREF_TRY(context_.vk.vkEndCommandBuffer(commands_));
  auto commandInfo = vkStruct<VkCommandBufferSubmitInfo>(VK_STRUCTURE_TYPE_COMMAND_BUFFER_SUBMIT_INFO);
  commandInfo.commandBuffer = commands_;
  auto info = vkStruct<VkSubmitInfo2>(VK_STRUCTURE_TYPE_SUBMIT_INFO_2);
  info.commandBufferInfoCount = 1;
  info.pCommandBufferInfos = &commandInfo;
  VKREF_TRY(context_.vk.vkQueueSubmit2(context_.queue, 1, &info, fence_.get()));
  pending_ = true;

  const VkFence fence = fence_.get();
  const VkResult waited =
      context_.vk.vkWaitForFences(context_.device, 1, &fence, VK_TRUE, nanoseconds(timeoutSeconds_));
  if (waited == VK_TIMEOUT) {
    return fail(ErrorCode::TimedOut, context_.caps.driver.name,
                fmt::format("a submit did not finish within {} s", timeoutSeconds_),
                "give it longer with --timeout, or draw less");
  }
  if (waited < 0) return callFailed("vkWaitForFences", waited);
  VKREF_TRY(context_.vk.vkResetFences(context_.device, 1, &fence));
  pending_ = false;
  return {};
}

bool Submission::settle(double seconds) {
  if (!pending_) return true;
  const VkFence fence = fence_.get();
  return context_.vk.vkWaitForFences(context_.device, 1, &fence, VK_TRUE, nanoseconds(seconds)) != VK_TIMEOUT;
}

}  // namespace rasterdiff::vkref
