// The greatest depth of a primitive: where the exponent of a float depth bias comes from. [vk:primsrast-depthbias-computation]
#pragma once

#include <array>
#include <span>

#include "rasterizer/fragment/linear_function.hpp"
#include "rasterizer/geometry.hpp"

namespace rasterdiff::rasterizer {

/// The greatest |z| of `vertices`, as far as their depths are known.
[[nodiscard]] Interval largestDepth(std::span<const RasterVertex* const> vertices);

/// The corners of a triangle in the order in which some devices take them: from the one of the smallest y, then of the largest
/// w; the others follow in turn.
[[nodiscard]] std::array<size_t, 3> farthestFirst(const std::array<ClipPosition, 3>& clip);

/// What a device takes for it that keeps the depth of one vertex of a triangle (farthestFirst) and the differences of the others
/// to it. [choice:depth-bias-exponent]
[[nodiscard]] Interval largestByFirstDifferences(const Primitive& primitive);

}  // namespace rasterdiff::rasterizer
