// Compares a scene with the limits of a device, before anything is allocated.
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "scene/file/enum_names.hpp"
#include "vkref/memory.hpp"
#include "vkref/offered_state.hpp"
#include "vkref/plan.hpp"

namespace rasterdiff::vkref {
namespace {

Result<void> checkTarget(const RenderPlan& plan, const Capabilities& caps) {
  const Limits& limits = caps.limits;
  if (plan.width > limits.maxFramebufferWidth || plan.height > limits.maxFramebufferHeight) {
    return notOffered("target", fmt::format("{} × {} pixels, the device has at most {} × {}", plan.width, plan.height,
                                            limits.maxFramebufferWidth, limits.maxFramebufferHeight));
  }
  if (!std::has_single_bit(plan.samples) || !(limits.framebufferSampleCounts & plan.samples)) {
    return notOffered("target.samples", fmt::format("{} samples are not offered", plan.samples));
  }
  VkDeviceSize bytes = 0;
  const auto add = [&](VkFormat format, uint32_t samples) {
    bytes += Image::bytesOf({format, plan.width, plan.height, samples});
  };
  for (const AttachmentPlan& color : plan.color) add(color.format, plan.samples);
  for (uint32_t v = 0; v < plan.varyings && plan.resolve; ++v) add(plan.color[kFirstVarying + v].format, 1);
  if (plan.depth != VK_FORMAT_UNDEFINED) add(plan.depth, plan.samples);
  if (plan.depthResolve != VK_RESOLVE_MODE_NONE) add(plan.depth, 1);
  // Attachments and the buffer that they are read back into exist at the same time.
  if (bytes > caps.largestHeap / 2) {
    return notOffered("target", fmt::format("attachments of {} MiB and as much for reading back, the device has {} MiB",
                                            bytes >> 20, caps.largestHeap >> 20));
  }
  return {};
}

Result<void> checkDepthFormat(DepthFormat format, uint32_t samples, const Capabilities& caps) {
  const auto found = std::find(kDepthFormats.begin(), kDepthFormats.end(), format);
  const size_t index = static_cast<size_t>(found - kDepthFormats.begin());
  if (index < kDepthFormats.size() && (caps.depthSampleCounts[index] & samples)) return {};
  return notOffered("target.depthFormat", fmt::format("{} is not offered with {} sample{}", enumName(format), samples,
                                                      samples == 1 ? "" : "s"));
}

/// [vk:VkPipelineSampleLocationsStateCreateInfoEXT]
Result<void> checkSampleLocations(const Target& target, const SampleLocationsInfo& info, const Capabilities& caps) {
  const std::string where = "target.sampleLocations";
  if (caps.limits.sampleLocationSampleCounts == 0) return notOffered(where, "needs VK_EXT_sample_locations");
  if (!(caps.limits.sampleLocationSampleCounts & target.samples)) {
    return notOffered(where, fmt::format("not offered with {} samples", target.samples));
  }
  const VkExtent2D grid = caps.sampleLocationGrids[static_cast<size_t>(std::countr_zero(target.samples))];
  const auto divides = [](uint32_t extent, uint32_t largest) { return largest >= extent && largest % extent == 0; };
  if (!divides(info.gridWidth, grid.width) || !divides(info.gridHeight, grid.height)) {
    return notOffered(where + ".sampleLocationGridSize",
                      fmt::format("{} × {} does not divide the device's grid of {} × {}", info.gridWidth,
                                  info.gridHeight, grid.width, grid.height));
  }
  // Layout transitions of a depth image that was drawn with them would have to be told the locations.
  if (target.depthFormat) return notOffered(where, "custom sample locations are drawn without a depth attachment only");
  return {};
}

Result<void> checkViewport(const std::string& where, const Viewport& viewport, const Capabilities& caps) {
  const VkPhysicalDeviceLimits& vk = caps.vk;
  const float lowest = vk.viewportBoundsRange[0], highest = vk.viewportBoundsRange[1];
  const float bottom = viewport.y + viewport.height;
  const bool sized = viewport.width > 0 && viewport.width <= static_cast<float>(vk.maxViewportDimensions[0]) &&
                     std::abs(viewport.height) <= static_cast<float>(vk.maxViewportDimensions[1]);
  const bool placed = viewport.x >= lowest && viewport.x + viewport.width <= highest &&
                      std::min(viewport.y, bottom) >= lowest && std::max(viewport.y, bottom) <= highest;
  if (!sized || !placed) {
    return notOffered(where, fmt::format("larger than {} × {} or outside {}..{}", vk.maxViewportDimensions[0],
                                              vk.maxViewportDimensions[1], lowest, highest));
  }
  return {};
}

}  // namespace

Result<void> checkOffered(const Scene& scene, const RenderPlan& plan, const Capabilities& caps) {
  if (const Result<void> target = checkTarget(plan, caps); !target) return target;
  if (scene.target.depthFormat) {
    const Result<void> depth = checkDepthFormat(*scene.target.depthFormat, plan.samples, caps);
    if (!depth) return depth;
  }
  if (scene.target.depthResolveMode && !(caps.depthResolveModes & static_cast<VkResolveModeFlags>(plan.depthResolve))) {
    return notOffered("target.depthResolveMode", fmt::format("{} is not offered", enumName(*scene.target.depthResolveMode)));
  }
  if (scene.target.sampleLocations) {
    const Result<void> locations = checkSampleLocations(scene.target, *scene.target.sampleLocations, caps);
    if (!locations) return locations;
  }
  if (const Result<void> viewport = checkViewport("viewport", scene.viewport, caps); !viewport) return viewport;
  for (size_t i = 0; i < scene.furtherViewports.size(); ++i) {
    const Viewport& further = scene.furtherViewports[i].viewport;
    const Result<void> viewport = checkViewport(fmt::format("furtherViewports[{}].viewport", i), further, caps);
    if (!viewport) return viewport;
  }
  for (size_t i = 0; i < scene.draws.size() && !caps.core().fullDrawIndexUint32; ++i) {
    const bool indexed = scene.draws[i].indices.has_value();
    if (indexed && scene.draws[i].positions.size() > size_t{caps.vk.maxDrawIndexedIndexValue} + 1) {
      return notOffered(fmt::format("draws[{}].indices", i),
                        fmt::format("indices above {} are not offered", caps.vk.maxDrawIndexedIndexValue));
    }
  }
  if (const Result<void> state = checkState(scene, caps); !state) return state;
  return checkShaders(scene, plan, caps);
}

}  // namespace rasterdiff::vkref
