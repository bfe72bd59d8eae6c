// Resolve by averaging: the samples of a pixel become one value. [vk:VkResolveModeFlagBits]
#pragma once

#include <span>

#include "rasterizer/deliberate_error.hpp"
#include "rasterizer/fragment/linear_function.hpp"
#include "rasterizer/rule_counts.hpp"

namespace rasterdiff::rasterizer {

/// The mean of samples, where sample s is `values[s · stride]` and known within `bounds[s · stride]`, and what any order
/// of float32 sums, with a division or a product by 1 / n at either end, may make of it.
[[nodiscard]] Interpolated meanOf(std::span<const float> values, std::span<const Bounds> bounds, size_t stride);

/// Every component of every pixel. Counts pixels whose samples differ.
[[nodiscard]] VaryingPlane resolved(const VaryingPlane& plane, DeliberateError error, RuleCounts& counts);

}  // namespace rasterdiff::rasterizer
