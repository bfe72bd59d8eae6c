// Command pools, each with its one command buffer and its fence.
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

Result<Submission::Slot> Submission::makeSlot() const {
  Slot slot;
  auto poolInfo = vkStruct<VkCommandPoolCreateInfo>(VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO);
  poolInfo.flags = VK_COMMAND_POOL_CREATE_TRANSIENT_BIT;
  poolInfo.queueFamilyIndex = context_.caps.queueFamily;
  VkCommandPool pool = VK_NULL_HANDLE;
  VKREF_TRY(context_.vk.vkCreateCommandPool(context_.device, &poolInfo, nullptr, &pool));
  slot.pool = OwnedCommandPool(context_, pool);

  auto allocateInfo = vkStruct<VkCommandBufferAllocateInfo>(VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO);
  allocateInfo.commandPool = pool;
  allocateInfo.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
  allocateInfo.commandBufferCount = 1;
  VKREF_TRY(context_.vk.vkAllocateCommandBuffers(context_.device, &allocateInfo, &slot.commands));

  const auto fenceInfo = vkStruct<VkFenceCreateInfo>(VK_STRUCTURE_TYPE_FENCE_CREATE_INFO);
  VkFence fence = VK_NULL_HANDLE;
  VKREF_TRY(context_.vk.vkCreateFence(context_.device, &fenceInfo, nullptr, &fence));
  slot.fence = OwnedFence(context_, fence);
  return slot;
}

Result<std::unique_ptr<Submission>> Submission::create(const Context& context, double timeoutSeconds) {
  std::unique_ptr<Submission> self(new Submission(context));
  self->timeoutSeconds_ = timeoutSeconds;
  for (Slot& slot : self->slots_) {
    Result<Slot> made = self->makeSlot();
    if (!made) return tl::unexpected(made.error());
    slot = std::move(*made);
  }
  return self;
}

Result<VkCommandBuffer> Submission::begin(size_t slot) {
  VKREF_TRY(context_.vk.vkResetCommandPool(context_.device, slots_[slot].pool.get(), 0));
  auto info = vkStruct<VkCommandBufferBeginInfo>(VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO);
  info.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
  VKREF_TRY(context_.vk.vkBeginCommandBuffer(slots_[slot].commands, &info));
  return slots_[slot].commands;
}

Result<void> Submission::submit(size_t slot) {
  VKREF_TRY(context_.vk.vkEndCommandBuffer(slots_[slot].commands));
  auto commandInfo = vkStruct<VkCommandBufferSubmitInfo>(VK_STRUCTURE_TYPE_COMMAND_BUFFER_SUBMIT_INFO);
  commandInfo.commandBuffer = slots_[slot].commands;
  auto info = vkStruct<VkSubmitInfo2>(VK_STRUCTURE_TYPE_SUBMIT_INFO_2);
  info.commandBufferInfoCount = 1;
  info.pCommandBufferInfos = &commandInfo;
  VKREF_TRY(context_.vk.vkQueueSubmit2(context_.queue, 1, &info, slots_[slot].fence.get()));
  slots_[slot].pending = true;
  return {};
}

Result<void> Submission::wait(size_t slot) {
  const VkFence fence = slots_[slot].fence.get();
  const VkResult waited =
      context_.vk.vkWaitForFences(context_.device, 1, &fence, VK_TRUE, nanoseconds(timeoutSeconds_));
  if (waited == VK_TIMEOUT) {
    return fail(ErrorCode::TimedOut, context_.caps.driver.name,
                fmt::format("a submit did not finish within {} s", timeoutSeconds_),
                "give it longer with --timeout, or draw less");
  }
  if (waited < 0) return callFailed("vkWaitForFences", waited);
  VKREF_TRY(context_.vk.vkResetFences(context_.device, 1, &fence));
  slots_[slot].pending = false;
  return {};
}

Result<void> Submission::run(size_t slot) {
  if (const Result<void> submitted = submit(slot); !submitted) return submitted;
  return wait(slot);
}

Result<void> Submission::drain() {
  for (size_t slot = 0; slot < kSlots; ++slot) {
    if (!slots_[slot].pending) continue;
    if (Result<void> waited = wait(slot); !waited) return waited;
  }
  return {};
}

bool Submission::settle(double seconds) {
  bool settled = true;
  for (const Slot& slot : slots_) {
    if (!slot.pending) continue;
    const VkFence fence = slot.fence.get();
    settled &= context_.vk.vkWaitForFences(context_.device, 1, &fence, VK_TRUE, nanoseconds(seconds)) != VK_TIMEOUT;
  }
  return settled;
}

}  // namespace rasterdiff::vkref
