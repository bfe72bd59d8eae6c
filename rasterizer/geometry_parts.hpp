// The geometry of a scene by several threads: each has a part of the primitives, and all parts in a row are drawing order.
#pragma once

#include <span>

#include "rasterizer/geometry.hpp"

namespace rasterdiff::rasterizer {

/// forEachPrimitive on as many threads as there are visitors: visitor k sees the k-th part of all primitives, in drawing order, and
/// its decisions go to counts[k]. There are as many counts as visitors, at least one.
void forEachPrimitive(const Scene& scene, const Rules& rules, std::span<RuleCounts> counts, std::span<const PrimitiveVisitor> visitors);

}  // namespace rasterdiff::rasterizer
