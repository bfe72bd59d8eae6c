// What is set while drawing: dynamic state, buffers and push constants of draws.
#pragma once

#include "vkref/geometry.hpp"
#include "vkref/pipeline.hpp"

namespace rasterdiff::vkref {

/// Sets all dynamic state but the topology; where the vertex shader does not choose viewports, that of viewport 0.
void recordState(const Context& context, VkCommandBuffer commands, const Scene& scene, const RenderPlan& plan);

/// Draws all commands of `geometry` with the varyings of `pass`, each in its viewport.
void recordGeometry(const Context& context, VkCommandBuffer commands, const Scene& scene, const RenderPlan& plan,
                    const PassPlan& pass, const Geometry& geometry, VkPipelineLayout layout);

}  // namespace rasterdiff::vkref
