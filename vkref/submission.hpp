// One command buffer at a time: recorded, submitted, and waited for no longer than a timeout.
#pragma once

#include "vkref/owned.hpp"

namespace rasterdiff::vkref {

class Submission {
 public:
  [[nodiscard]] static Result<std::unique_ptr<Submission>> create(const Context& context, double timeoutSeconds);

  /// An empty command buffer in the recording state; the one before has been executed. Error: DeviceLost.
  [[nodiscard]] Result<VkCommandBuffer> begin();
  /// Ends, submits and waits. Error: TimedOut, after which the work is still pending; DeviceLost.
  [[nodiscard]] Result<void> run();
  /// Waits for what a timeout left behind. False: it still runs, and nothing it uses may be destroyed.
  [[nodiscard]] bool settle(double seconds);

 private:
  explicit Submission(const Context& context) : context_(context) {}

  const Context& context_;
  double timeoutSeconds_ = 0;
  OwnedCommandPool pool_;
  OwnedFence fence_;
  VkCommandBuffer commands_ = VK_NULL_HANDLE;
  bool pending_ = false;
};

}  // namespace rasterdiff::vkref
