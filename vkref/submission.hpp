// A few command buffers: each is recorded, submitted, and waited for no longer than a timeout.
#pragma once

#include <array>

#include "vkref/owned.hpp"

namespace rasterdiff::vkref {

class Submission {
 public:
  static constexpr size_t kSlots = 4;  ///< some can be recorded while others are executed

  [[nodiscard]] static Result<std::unique_ptr<Submission>> create(const Context& context, double timeoutSeconds);

  /// An empty command buffer in the recording state; what the slot held before has been waited for. Error: DeviceLost.
  [[nodiscard]] Result<VkCommandBuffer> begin(size_t slot = 0);
  /// Ends and submits what was recorded. Error: DeviceLost.
  [[nodiscard]] Result<void> submit(size_t slot);
  /// Waits for what was submitted. Error: TimedOut, after which the work is still pending; DeviceLost.
  [[nodiscard]] Result<void> wait(size_t slot);
  /// Both.
  [[nodiscard]] Result<void> run(size_t slot = 0);
  /// Waits for whatever is pending, so that all slots can be used again. Errors as of wait().
  [[nodiscard]] Result<void> drain();
  /// Waits for what a timeout left behind. False: it still runs, and nothing it uses may be destroyed.
  [[nodiscard]] bool settle(double seconds);

 private:
  struct Slot {
    OwnedCommandPool pool;
    OwnedFence fence;
    VkCommandBuffer commands = VK_NULL_HANDLE;
    bool pending = false;
  };
  explicit Submission(const Context& context) : context_(context) {}
  [[nodiscard]] Result<Slot> makeSlot() const;

  const Context& context_;
  double timeoutSeconds_ = 0;
  std::array<Slot, kSlots> slots_;
};

}  // namespace rasterdiff::vkref
