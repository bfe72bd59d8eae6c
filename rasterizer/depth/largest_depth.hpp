// The greatest depth of a primitive: where the exponent of a float depth bias comes from. [vk:primsrast-depthbias-computation]
#pragma once

#include <span>

#include "rasterizer/fragment/linear_function.hpp"
#include "rasterizer/geometry.hpp"

namespace rasterdiff::rasterizer {

/// The greatest |z| of `vertices`, as far as their depths are known.
[[nodiscard]] Interval largestDepth(std::span<const RasterVertex* const> vertices);

/// What a device takes for it that keeps the depth of one vertex of a triangle and the differences of the others to it: the
/// vertex is the one of the smallest y, then of the largest w. [choice:depth-bias-exponent]
[[nodiscard]] Interval largestByFirstDifferences(const Primitive& primitive);

}  // namespace rasterdiff::rasterizer
