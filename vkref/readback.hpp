// Brings every sample of the attachments to the host, in the layout of Plane.
#pragma once

#include <span>
#include <vector>

#include "scene/frame.hpp"
#include "vkref/attachments.hpp"
#include "vkref/depth_values.hpp"
#include "vkref/submission.hpp"
#include "vkref/unpack.hpp"

namespace rasterdiff::vkref {

/// What reading back works with. The buffers are leased while the device may use them.
struct ReadbackTools {
  const Context& context;
  Submission& submission;
  Pool<Buffer>& pool;
  Unpack& unpack;
  std::vector<Pool<Buffer>::Lease>& buffers;
};

/// What a scene was drawn into; `fetch` is how depths of several samples come.
struct DrawnScene {
  const Scene* scene = nullptr;
  const RenderPlan* plan = nullptr;
  const Attachments* attachments = nullptr;
  DepthFetch fetch = DepthFetch::Quotient;
};

/// Copies all attachments from the layouts that recordDraws leaves, by copies at one sample and of what was resolved, by
/// `unpack` at several: a frame for each of `drawn`. Adds to `cost`. Error: DeviceLost, TimedOut (the device may still use
/// attachments and buffers), NotOffered (memory, or a count of some scene that is too large to be exact).
[[nodiscard]] Result<std::vector<Frame>> readFrames(std::span<const DrawnScene> drawn, ReadbackTools& tools, RenderCost& cost);

/// Brings an image from its attachment layout to the one that its transfer reads.
[[nodiscard]] VkImageMemoryBarrier2 transferBarrier(const Image& image);
/// Makes what transfers wrote visible to the host.
void recordHostBarrier(const Context& context, VkCommandBuffer commands);

}  // namespace rasterdiff::vkref
