// Records the render passes of a scene: clear, dynamic state, one draw command a draw.
#pragma once

#include "vkref/attachments.hpp"
#include "vkref/geometry.hpp"
#include "vkref/pipeline.hpp"

namespace rasterdiff::vkref {

/// Afterwards every attachment is in its attachment layout, with its writes not yet made visible to anyone.
/// Error: whatever making a pipeline gives.
[[nodiscard]] Result<void> recordDraws(const Context& context, VkCommandBuffer commands, const Scene& scene,
                                       const RenderPlan& plan, const Attachments& attachments,
                                       const Geometry& geometry, PrimitiveSource primitives,
                                       PipelineCache& pipelines);

/// A layout transition and memory dependency of a whole image.
[[nodiscard]] VkImageMemoryBarrier2 imageBarrier(const Image& image, VkPipelineStageFlags2 srcStage,
                                                 VkAccessFlags2 srcAccess, VkImageLayout oldLayout,
                                                 VkPipelineStageFlags2 dstStage, VkAccessFlags2 dstAccess,
                                                 VkImageLayout newLayout);
void recordBarriers(const Context& context, VkCommandBuffer commands,
                    const std::vector<VkImageMemoryBarrier2>& barriers);

inline constexpr VkPipelineStageFlags2 kDepthStages =
    VK_PIPELINE_STAGE_2_EARLY_FRAGMENT_TESTS_BIT | VK_PIPELINE_STAGE_2_LATE_FRAGMENT_TESTS_BIT;
inline constexpr VkAccessFlags2 kDepthAccess =
    VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_READ_BIT | VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT;
inline constexpr VkAccessFlags2 kColorAccess =
    VK_ACCESS_2_COLOR_ATTACHMENT_READ_BIT | VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT;

}  // namespace rasterdiff::vkref
