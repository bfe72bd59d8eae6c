// Resolve by averaging: the samples of a pixel become one value. [vk:VkResolveModeFlagBits]
#pragma once

#include <span>

#include "rasterizer/fragment/linear_function.hpp"
#include "rasterizer/rule_counts.hpp"
#include "rasterizer/rules.hpp"

namespace rasterdiff::rasterizer {

/// The mean of samples, where sample s is `values[s · stride]` and known within `bounds[s · stride]`. Bounds of the result
/// are those of one arithmetic; for Any, of every order of float32 sums with a division or a product by 1 / n at either
/// end. [choice:resolve-arithmetic]
[[nodiscard]] Interpolated meanOf(std::span<const float> values, std::span<const Bounds> bounds, size_t stride,
                                  ResolveArithmetic arithmetic = ResolveArithmetic::Any);

/// Every component of every pixel. Counts pixels whose samples differ.
[[nodiscard]] VaryingPlane resolved(const VaryingPlane& plane, const Rules& rules, RuleCounts& counts);

}  // namespace rasterdiff::rasterizer
