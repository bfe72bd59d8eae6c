// Dynamic rendering of all draws, once a pass; what comes out is read by readback.cpp.
#include "vkref/commands.hpp"

#include "vkref/draw_state.hpp"
#include "vkref/vk_struct.hpp"

namespace rasterdiff::vkref {
namespace {

VkRenderingAttachmentInfo attachmentInfo(const Image& image) {
  auto info = vkStruct<VkRenderingAttachmentInfo>(VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO);
  info.imageView = image.view.get();
  info.imageLayout = attachmentLayout(image.key.format);
  info.loadOp = VK_ATTACHMENT_LOAD_OP_CLEAR;
  info.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
  return info;
}

/// The image that output `output` of a pass is resolved to; null for one that is not resolved.
const Image* resolvedImage(const RenderPlan& plan, const PassPlan& pass, const Attachments& attachments,
                           size_t output) {
  if (!resolves(plan, pass, output)) return nullptr;
  return attachments.resolved[pass.attachments[output] - kFirstVarying].get();
}

/// Contents from before are given up; a pass that comes after another one waits for its use of the same attachments.
void recordFirstUse(const Context& context, VkCommandBuffer commands, const RenderPlan& plan, const PassPlan& pass,
                    const Attachments& attachments) {
  std::vector<VkImageMemoryBarrier2> barriers;
  const auto add = [&barriers](const Image& image, VkPipelineStageFlags2 stages, VkAccessFlags2 written,
                               VkAccessFlags2 accessed) {
    barriers.push_back(imageBarrier(image, stages, written, VK_IMAGE_LAYOUT_UNDEFINED, stages, accessed,
                                    attachmentLayout(image.key.format)));
  };
  for (size_t output = 0; output < pass.attachments.size(); ++output) {
    const Image* images[] = {attachments.color[pass.attachments[output]].get(),
                             resolvedImage(plan, pass, attachments, output)};
    for (const Image* image : images) {
      if (!image) continue;
      add(*image, VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT, VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT,
          kColorAccess);
    }
  }
  if (attachments.depth) {
    add(*attachments.depth, kDepthStages, VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT, kDepthAccess);
  }
  // [vk:renderpass-resolve-operations] resolving depth is a colour attachment's write too.
  if (attachments.resolvedDepth && pass.primitives) {
    add(*attachments.resolvedDepth, kDepthStages | VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT,
        VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT, kDepthAccess | VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT);
  }
  recordBarriers(context, commands, barriers);
}

void beginRendering(const Context& context, VkCommandBuffer commands, const Scene& scene, const RenderPlan& plan,
                    const PassPlan& pass, const Attachments& attachments) {
  std::vector<VkRenderingAttachmentInfo> color;
  for (size_t output = 0; output < pass.attachments.size(); ++output) {
    VkRenderingAttachmentInfo& attachment =
        color.emplace_back(attachmentInfo(*attachments.color[pass.attachments[output]]));
    if (const Image* resolved = resolvedImage(plan, pass, attachments, output)) {
      attachment.resolveMode = VK_RESOLVE_MODE_AVERAGE_BIT;
      attachment.resolveImageView = resolved->view.get();
      attachment.resolveImageLayout = attachmentLayout(resolved->key.format);
    }
  }
  VkRenderingAttachmentInfo depth{};
  auto info = vkStruct<VkRenderingInfo>(VK_STRUCTURE_TYPE_RENDERING_INFO);
  info.renderArea = {{0, 0}, {scene.target.width, scene.target.height}};
  info.layerCount = 1;
  info.colorAttachmentCount = static_cast<uint32_t>(color.size());
  info.pColorAttachments = color.data();
  if (attachments.depth) {
    depth = attachmentInfo(*attachments.depth);
    depth.clearValue.depthStencil.depth = scene.target.depthClearValue;
    if (attachments.resolvedDepth && pass.primitives) {
      depth.resolveMode = plan.depthResolve;
      depth.resolveImageView = attachments.resolvedDepth->view.get();
      depth.resolveImageLayout = attachmentLayout(plan.depth);
    }
    info.pDepthAttachment = &depth;
  }
  context.vk.vkCmdBeginRendering(commands, &info);
}

}  // namespace

VkImageMemoryBarrier2 imageBarrier(const Image& image, VkPipelineStageFlags2 srcStage, VkAccessFlags2 srcAccess,
                                   VkImageLayout oldLayout, VkPipelineStageFlags2 dstStage, VkAccessFlags2 dstAccess,
                                   VkImageLayout newLayout) {
  auto barrier = vkStruct<VkImageMemoryBarrier2>(VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2);
  barrier.srcStageMask = srcStage;
  barrier.srcAccessMask = srcAccess;
  barrier.dstStageMask = dstStage;
  barrier.dstAccessMask = dstAccess;
  barrier.oldLayout = oldLayout;
  barrier.newLayout = newLayout;
  barrier.srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
  barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
  barrier.image = image.image.get();
  barrier.subresourceRange = {allAspectsOf(image.key.format), 0, 1, 0, 1};
  return barrier;
}

void recordBarriers(const Context& context, VkCommandBuffer commands,
                    const std::vector<VkImageMemoryBarrier2>& barriers) {
  auto info = vkStruct<VkDependencyInfo>(VK_STRUCTURE_TYPE_DEPENDENCY_INFO);
  info.imageMemoryBarrierCount = static_cast<uint32_t>(barriers.size());
  info.pImageMemoryBarriers = barriers.data();
  context.vk.vkCmdPipelineBarrier2(commands, &info);
}

Result<void> recordDraws(const Context& context, VkCommandBuffer commands, const Scene& scene, const RenderPlan& plan,
                         const Attachments& attachments, const Geometry& geometry, PrimitiveSource primitives,
                         PipelineCache& pipelines) {
  for (const PassPlan& pass : plan.passes) {
    const Result<VkPipeline> pipeline = pipelines.get(pipelineKey(scene, plan, pass, primitives));
    if (!pipeline) return tl::unexpected(pipeline.error());
    recordFirstUse(context, commands, plan, pass, attachments);
    beginRendering(context, commands, scene, plan, pass, attachments);
    context.vk.vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, *pipeline);
    recordState(context, commands, scene, plan);
    recordGeometry(context, commands, scene, plan, pass, geometry, pipelines.layout());
    context.vk.vkCmdEndRendering(commands);
  }
  return {};
}

}  // namespace rasterdiff::vkref
