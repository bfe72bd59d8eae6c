// Dynamic rendering of all draws, once a pass; what comes out is read by readback.cpp.
#include "vkref/commands.hpp"
#include "vkref/vk_struct.hpp"

namespace rasterdiff::vkref {
namespace {

VkRect2D scissorOf(const Scene& scene) {
  if (!scene.scissor) return {{0, 0}, {scene.target.width, scene.target.height}};
  return {{scene.scissor->x, scene.scissor->y}, {scene.scissor->width, scene.scissor->height}};
}

/// The push constants that number primitives by vertex: the provoking vertex of primitive p is firstProvoking + p.
/// [vk:drawing-primitive-topologies]
DrawConstants constantsOf(const State& state, const DrawCommand& draw) {
  const bool last = state.provokingVertexMode == ProvokingVertexMode::LAST_VERTEX;
  switch (state.topology) {
    case PrimitiveTopology::TRIANGLE_STRIP:
      return {draw.firstPrimitive, 1, last ? 2U : 0U};
    case PrimitiveTopology::TRIANGLE_FAN:
      return {draw.firstPrimitive, 1, last ? 2U : 1U};
    case PrimitiveTopology::TRIANGLE_LIST:
      break;
  }
  return {draw.firstPrimitive, 3, 0};
}

void recordState(const Context& context, VkCommandBuffer commands, const Scene& scene) {
  const VolkDeviceTable& vk = context.vk;
  const State& state = scene.state;
  const VkViewport viewport{scene.viewport.x,      scene.viewport.y,        scene.viewport.width,
                            scene.viewport.height, scene.viewport.minDepth, scene.viewport.maxDepth};
  const VkRect2D scissor = scissorOf(scene);
  vk.vkCmdSetViewport(commands, 0, 1, &viewport);
  vk.vkCmdSetScissor(commands, 0, 1, &scissor);
  vk.vkCmdSetCullMode(commands, static_cast<VkCullModeFlags>(state.cullMode));
  vk.vkCmdSetFrontFace(commands, static_cast<VkFrontFace>(state.frontFace));
  vk.vkCmdSetPrimitiveTopology(commands, static_cast<VkPrimitiveTopology>(state.topology));
  vk.vkCmdSetDepthTestEnable(commands, state.depthTestEnable);
  vk.vkCmdSetDepthWriteEnable(commands, state.depthWriteEnable);
  vk.vkCmdSetDepthCompareOp(commands, static_cast<VkCompareOp>(state.depthCompareOp));
}

void recordDraw(const Context& context, VkCommandBuffer commands, const State& state, const PassPlan& pass,
                VkBuffer buffer, const DrawCommand& draw, VkPipelineLayout layout) {
  std::array<VkBuffer, 1 + kMaxVaryingsPerPass> buffers{};
  std::array<VkDeviceSize, 1 + kMaxVaryingsPerPass> offsets{draw.positions};
  buffers.fill(buffer);
  for (uint32_t i = 0; i < pass.varyings; ++i) offsets[1 + i] = draw.varyings[pass.firstVarying + i];
  context.vk.vkCmdBindVertexBuffers(commands, 0, 1 + pass.varyings, buffers.data(), offsets.data());
  const DrawConstants constants = constantsOf(state, draw);
  context.vk.vkCmdPushConstants(commands, layout, VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT, 0,
                                sizeof(constants), &constants);
  if (draw.indexed) {
    context.vk.vkCmdBindIndexBuffer(commands, buffer, draw.indices, VK_INDEX_TYPE_UINT32);
    context.vk.vkCmdDrawIndexed(commands, draw.count, 1, 0, 0, 0);
  } else {
    context.vk.vkCmdDraw(commands, draw.count, 1, 0, 0);
  }
}

VkRenderingAttachmentInfo attachmentInfo(const Image& image, VkImageLayout layout) {
  auto info = vkStruct<VkRenderingAttachmentInfo>(VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO);
  info.imageView = image.view.get();
  info.imageLayout = layout;
  info.loadOp = VK_ATTACHMENT_LOAD_OP_CLEAR;
  info.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
  return info;
}

/// Contents from before are given up; a pass that comes after another one waits for its use of the depth attachment.
void recordFirstUse(const Context& context, VkCommandBuffer commands, const PassPlan& pass,
                    const Attachments& attachments) {
  std::vector<VkImageMemoryBarrier2> barriers;
  for (uint32_t i = 0; i < pass.attachments; ++i) {
    barriers.push_back(imageBarrier(*attachments.color[pass.firstAttachment + i],
                                    VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT, 0, VK_IMAGE_LAYOUT_UNDEFINED,
                                    VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT, kColorAccess,
                                    VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL));
  }
  if (attachments.depth) {
    barriers.push_back(imageBarrier(*attachments.depth, kDepthStages,
                                    VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT, VK_IMAGE_LAYOUT_UNDEFINED,
                                    kDepthStages, kDepthAccess, VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL));
  }
  recordBarriers(context, commands, barriers);
}

void beginRendering(const Context& context, VkCommandBuffer commands, const Scene& scene, const PassPlan& pass,
                    const Attachments& attachments) {
  std::vector<VkRenderingAttachmentInfo> color;
  for (uint32_t i = 0; i < pass.attachments; ++i) {
    color.push_back(attachmentInfo(*attachments.color[pass.firstAttachment + i],
                                   VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL));
  }
  VkRenderingAttachmentInfo depth{};
  auto info = vkStruct<VkRenderingInfo>(VK_STRUCTURE_TYPE_RENDERING_INFO);
  info.renderArea = {{0, 0}, {scene.target.width, scene.target.height}};
  info.layerCount = 1;
  info.colorAttachmentCount = static_cast<uint32_t>(color.size());
  info.pColorAttachments = color.data();
  if (attachments.depth) {
    depth = attachmentInfo(*attachments.depth, VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL);
    depth.clearValue.depthStencil.depth = scene.target.depthClearValue;
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
  barrier.subresourceRange = {aspectOf(image.key.format), 0, 1, 0, 1};
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
    recordFirstUse(context, commands, pass, attachments);
    beginRendering(context, commands, scene, pass, attachments);
    context.vk.vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, *pipeline);
    recordState(context, commands, scene);
    for (const DrawCommand& draw : geometry.draws) {
      recordDraw(context, commands, scene.state, pass, geometry.buffer->buffer.get(), draw, pipelines.layout());
    }
    context.vk.vkCmdEndRendering(commands);
  }
  return {};
}

}  // namespace rasterdiff::vkref
