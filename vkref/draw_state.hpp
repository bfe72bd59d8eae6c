// What is set while drawing: dynamic state, buffers and push constants of draws.
#pragma once

#include "vkref/geometry.hpp"
#include "vkref/pipeline.hpp"

namespace rasterdiff::vkref {

/// Sets all dynamic state; with several viewports that draws choose themselves (no RenderPlan::viewportIndex), the
/// viewport is that of the first and recordDraw changes it.
void recordState(const Context& context, VkCommandBuffer commands, const Scene& scene, const RenderPlan& plan);

/// Draws all commands of `geometry` with the varyings of `pass`.
void recordGeometry(const Context& context, VkCommandBuffer commands, const Scene& scene, const RenderPlan& plan,
                    const PassPlan& pass, const Geometry& geometry, VkPipelineLayout layout);

}  // namespace rasterdiff::vkref
