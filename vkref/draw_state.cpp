// Translates a scene's state into dynamic state, and its draws into bindings and draw commands.
#include "vkref/draw_state.hpp"

#include <algorithm>

#include "vkref/pipeline_state.hpp"

namespace rasterdiff::vkref {
namespace {

VkViewport viewportOf(const Viewport& viewport) {
  return {viewport.x, viewport.y, viewport.width, viewport.height, viewport.minDepth, viewport.maxDepth};
}

VkRect2D scissorOf(const std::optional<Rect2D>& scissor, const Target& target) {
  if (!scissor) return {{0, 0}, {target.width, target.height}};
  return {{scissor->x, scissor->y}, {scissor->width, scissor->height}};
}

void recordViewports(const Context& context, VkCommandBuffer commands, const Scene& scene) {
  std::vector<VkViewport> viewports = {viewportOf(scene.viewport)};
  std::vector<VkRect2D> scissors = {scissorOf(scene.scissor, scene.target)};
  for (const ViewportAndScissor& further : scene.furtherViewports) {
    viewports.push_back(viewportOf(further.viewport));
    scissors.push_back(scissorOf(further.scissor, scene.target));
  }
  const uint32_t count = static_cast<uint32_t>(viewports.size());
  context.vk.vkCmdSetViewport(commands, 0, count, viewports.data());
  context.vk.vkCmdSetScissor(commands, 0, count, scissors.data());
}

/// Viewport `index` of the scene as the only one.
void recordViewport(const Context& context, VkCommandBuffer commands, const Scene& scene, uint32_t index) {
  const ViewportAndScissor* further = index > 0 ? &scene.furtherViewports[index - 1] : nullptr;
  const VkViewport viewport = viewportOf(further ? further->viewport : scene.viewport);
  const VkRect2D scissor = scissorOf(further ? further->scissor : scene.scissor, scene.target);
  context.vk.vkCmdSetViewport(commands, 0, 1, &viewport);
  context.vk.vkCmdSetScissor(commands, 0, 1, &scissor);
}

/// The push constants that number primitives by vertex: the provoking vertex of primitive p of a strip or fan is
/// firstProvoking + p, that of a list lies among its own vertices. [vk:drawing-primitive-topologies]
DrawConstants constantsOf(PrimitiveTopology topology, ProvokingVertexMode mode, const DrawCommand& draw) {
  const bool last = mode == ProvokingVertexMode::LAST_VERTEX;
  const auto numbered = [&](uint32_t verticesPerPrimitive, uint32_t firstProvoking) {
    return DrawConstants{draw.firstPrimitive, verticesPerPrimitive, draw.firstVertex + firstProvoking,
                         draw.viewportIndex, draw.shaderSampleMaskBits};
  };
  switch (topology) {
    case PrimitiveTopology::POINT_LIST:
      return numbered(1, 0);
    case PrimitiveTopology::LINE_LIST:
      return numbered(2, 0);
    case PrimitiveTopology::LINE_STRIP:
      return numbered(1, last ? 1 : 0);
    case PrimitiveTopology::TRIANGLE_STRIP:
      return numbered(1, last ? 2 : 0);
    case PrimitiveTopology::TRIANGLE_FAN:
      return numbered(1, last ? 2 : 1);
    case PrimitiveTopology::TRIANGLE_LIST:
      break;
  }
  return numbered(3, 0);
}

void recordDraw(const Context& context, VkCommandBuffer commands, const Scene& scene, const PassPlan& pass,
                const Geometry& geometry, const DrawCommand& draw, VkPipelineLayout layout) {
  const VkBuffer buffer = geometry.buffer->buffer.get();
  const auto bind = [&](uint32_t binding, VkDeviceSize offset) {
    context.vk.vkCmdBindVertexBuffers(commands, binding, 1, &buffer, &offset);
  };
  bind(kPositionBinding, draw.positions);
  for (uint32_t i = 0; i < pass.varyings.size(); ++i) bind(1 + i, draw.varyings[pass.varyings[i]]);
  if (drawsPoints(scene.state)) bind(kPointSizeBinding, draw.pointSizes);
  if (scene.draws.front().clipDistanceCount > 0) bind(kClipDistanceBinding, draw.clipDistances);
  if (scene.draws.front().cullDistanceCount > 0) bind(kCullDistanceBinding, draw.cullDistances);
  const DrawConstants constants = constantsOf(geometry.topology, scene.state.provokingVertexMode, draw);
  context.vk.vkCmdPushConstants(commands, layout, VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT, 0,
                                sizeof(constants), &constants);
  if (draw.indexed) {
    context.vk.vkCmdBindIndexBuffer(commands, buffer, draw.indices, VK_INDEX_TYPE_UINT32);
    context.vk.vkCmdDrawIndexed(commands, draw.count, 1, 0, 0, 0);
  } else {
    context.vk.vkCmdDraw(commands, draw.count, 1, draw.firstVertex, 0);
  }
}

/// A list that no restart index ends leaves it off: enabling it there takes a feature.
bool restarts(const Scene& scene) {
  if (!scene.state.primitiveRestartEnable || !isList(scene.state.topology)) return scene.state.primitiveRestartEnable;
  return std::any_of(scene.draws.begin(), scene.draws.end(), [](const Draw& draw) {
    return draw.indices && std::find(draw.indices->begin(), draw.indices->end(), kRestartIndex) != draw.indices->end();
  });
}

}  // namespace

void recordState(const Context& context, VkCommandBuffer commands, const Scene& scene, const RenderPlan& plan) {
  const VolkDeviceTable& vk = context.vk;
  const State& state = scene.state;
  if (plan.viewportIndex) {
    recordViewports(context, commands, scene);
  } else {
    recordViewport(context, commands, scene, 0);
  }
  vk.vkCmdSetCullMode(commands, static_cast<VkCullModeFlags>(state.cullMode));
  vk.vkCmdSetFrontFace(commands, static_cast<VkFrontFace>(state.frontFace));
  vk.vkCmdSetPrimitiveRestartEnable(commands, restarts(scene));
  vk.vkCmdSetDepthTestEnable(commands, state.depthTestEnable);
  vk.vkCmdSetDepthWriteEnable(commands, state.depthWriteEnable);
  vk.vkCmdSetDepthCompareOp(commands, static_cast<VkCompareOp>(state.depthCompareOp));
  vk.vkCmdSetDepthBiasEnable(commands, state.depthBiasEnable);
  if (state.depthBiasEnable) {
    vk.vkCmdSetDepthBias(commands, state.depthBiasConstantFactor, state.depthBiasClamp, state.depthBiasSlopeFactor);
  } else {
    vk.vkCmdSetDepthBias(commands, 0, 0, 0);
  }
  vk.vkCmdSetLineWidth(commands, drawsLines(state) ? state.lineWidth : 1);
  if (drawsLines(state) && state.stippledLineEnable) {
    vk.vkCmdSetLineStippleEXT(commands, state.lineStippleFactor, state.lineStipplePattern);
  }
}

void recordGeometry(const Context& context, VkCommandBuffer commands, const Scene& scene, const RenderPlan& plan,
                    const PassPlan& pass, const Geometry& geometry, VkPipelineLayout layout) {
  context.vk.vkCmdSetPrimitiveTopology(commands, static_cast<VkPrimitiveTopology>(geometry.topology));
  uint32_t viewport = 0;
  for (const DrawCommand& draw : geometry.draws) {
    if (!plan.viewportIndex && draw.viewportIndex != viewport) {
      viewport = draw.viewportIndex;
      recordViewport(context, commands, scene, viewport);
    }
    recordDraw(context, commands, scene, pass, geometry, draw, layout);
  }
}

}  // namespace rasterdiff::vkref
