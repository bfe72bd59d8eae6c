// Brings every sample of the attachments to the host, in the layout of Plane.
#pragma once

#include "scene/frame.hpp"
#include "vkref/attachments.hpp"
#include "vkref/depth_values.hpp"
#include "vkref/geometry.hpp"
#include "vkref/unpack.hpp"

namespace rasterdiff::vkref {

/// One plane in the readback buffer.
struct PlaneLocation {
  VkDeviceSize offset = 0;
  uint32_t stride = 1;  ///< 32-bit words a sample; may exceed the plane's components
};

struct Readback {
  Pool<Buffer>::Lease buffer;
  std::vector<PlaneLocation> color;     ///< as RenderPlan::color
  std::vector<PlaneLocation> resolved;  ///< as Attachments::resolved
  PlaneLocation depth, resolvedDepth;
};

/// Records the transfer of all attachments into one host-visible buffer, from the layouts that recordDraws leaves:
/// by copies at one sample and of what was resolved, by `unpack` at several. Adds to `cost`. Error: DeviceLost, NotOffered (memory).
[[nodiscard]] Result<Readback> recordReadback(const Context& context, VkCommandBuffer commands, const RenderPlan& plan,
                                              const Attachments& attachments, Pool<Buffer>& buffers, Unpack& unpack,
                                              RenderCost& cost);

/// Copies what a finished submission put into the buffer; `fetch` is how depths of several samples came there.
/// Error: NotOffered if a count is too large to be exact.
[[nodiscard]] Result<Frame> frameOf(const Scene& scene, const RenderPlan& plan, const Readback& readback,
                                    DepthFetch fetch);

/// Brings an image from its attachment layout to the one that its transfer reads.
[[nodiscard]] VkImageMemoryBarrier2 transferBarrier(const Image& image);
/// Makes what transfers wrote visible to the host.
void recordHostBarrier(const Context& context, VkCommandBuffer commands);

}  // namespace rasterdiff::vkref
