// Compares a scene with the limits of a device, before anything is allocated.
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "vkref/memory.hpp"
#include "vkref/plan.hpp"

namespace rasterdiff::vkref {
namespace {

tl::unexpected<Error> notOffered(std::string where, std::string what) {
  return fail(ErrorCode::NotOffered, std::move(where), std::move(what), "`rasterdiff devices` shows the limits");
}

Result<void> checkTarget(const RenderPlan& plan, const Capabilities& caps) {
  const Limits& limits = caps.limits;
  if (plan.width > limits.maxFramebufferWidth || plan.height > limits.maxFramebufferHeight) {
    return notOffered("target", fmt::format("{} × {} pixels, the device has at most {} × {}", plan.width, plan.height,
                                            limits.maxFramebufferWidth, limits.maxFramebufferHeight));
  }
  if (!std::has_single_bit(plan.samples) || !(limits.framebufferSampleCounts & plan.samples)) {
    return notOffered("target.samples", fmt::format("{} samples are not offered", plan.samples));
  }
  VkDeviceSize bytes = plan.depth ? Image::texelBytes({kDepthFormat, plan.width, plan.height, plan.samples}) : 0;
  for (const AttachmentPlan& color : plan.color) {
    bytes += Image::texelBytes({color.format, plan.width, plan.height, plan.samples});
  }
  // Attachments and the buffer that they are read back into exist at the same time.
  if (bytes > caps.largestHeap / 2) {
    return notOffered("target", fmt::format("attachments of {} MiB and as much for reading back, the device has {} MiB",
                                            bytes >> 20, caps.largestHeap >> 20));
  }
  return {};
}

Result<void> checkViewport(const Viewport& viewport, const Capabilities& caps) {
  const VkPhysicalDeviceLimits& vk = caps.vk;
  const float lowest = vk.viewportBoundsRange[0], highest = vk.viewportBoundsRange[1];
  const float bottom = viewport.y + viewport.height;
  const bool sized = viewport.width > 0 && viewport.width <= static_cast<float>(vk.maxViewportDimensions[0]) &&
                     std::abs(viewport.height) <= static_cast<float>(vk.maxViewportDimensions[1]);
  const bool placed = viewport.x >= lowest && viewport.x + viewport.width <= highest &&
                      std::min(viewport.y, bottom) >= lowest && std::max(viewport.y, bottom) <= highest;
  if (!sized || !placed) {
    return notOffered("viewport", fmt::format("larger than {} × {} or outside {}..{}", vk.maxViewportDimensions[0],
                                              vk.maxViewportDimensions[1], lowest, highest));
  }
  return {};
}

}  // namespace

Result<void> checkOffered(const Scene& scene, const RenderPlan& plan, const Capabilities& caps) {
  if (const Result<void> target = checkTarget(plan, caps); !target) return target;
  if (const Result<void> viewport = checkViewport(scene.viewport, caps); !viewport) return viewport;
  const State& state = scene.state;
  if (state.provokingVertexMode == ProvokingVertexMode::LAST_VERTEX && !caps.limits.provokingVertexLast) {
    return notOffered("state.provokingVertexMode", "LAST_VERTEX needs VK_EXT_provoking_vertex");
  }
  if (state.negativeOneToOne && !caps.limits.depthClipControl) {
    return notOffered("state.negativeOneToOne", "needs VK_EXT_depth_clip_control");
  }
  for (size_t i = 0; i < scene.draws.size() && !caps.fullDrawIndexUint32; ++i) {
    const bool indexed = scene.draws[i].indices.has_value();
    if (indexed && scene.draws[i].positions.size() > size_t{caps.vk.maxDrawIndexedIndexValue} + 1) {
      return notOffered(fmt::format("draws[{}].indices", i),
                        fmt::format("indices above {} are not offered", caps.vk.maxDrawIndexedIndexValue));
    }
  }
  return {};
}

}  // namespace rasterdiff::vkref
