// Resolve of depth: the samples of a pixel become one, by any of four modes. [vk:VkResolveModeFlagBits]
#pragma once

#include <span>

#include "rasterizer/deliberate_error.hpp"
#include "rasterizer/fragment/linear_function.hpp"
#include "rasterizer/rule_counts.hpp"
#include "scene/frame.hpp"
#include "scene/vulkan_enums.hpp"

namespace rasterdiff::rasterizer {

/// What resolving the depths of one pixel with `mode` may give; AVERAGE of a fixed-point format may end on either neighbour.
[[nodiscard]] Interpolated resolvedDepth(std::span<const float> depths, std::span<const Bounds> bounds, ResolveMode mode,
                                         DepthFormat format);

/// A plane "depth" of one sample a pixel. Counts pixels whose samples differ.
[[nodiscard]] VaryingPlane resolvedDepth(const Plane<float>& depths, const Plane<Bounds>& bounds, ResolveMode mode,
                                         DepthFormat format, DeliberateError error, RuleCounts& counts);

}  // namespace rasterdiff::rasterizer
