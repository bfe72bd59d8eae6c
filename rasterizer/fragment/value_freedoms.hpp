// Which freedom, beside the evaluation in float32, widens the legal interval of each value plane of a scene: what a
// verdict of Allowed cites for values.
#pragma once

#include <vector>

#include "rasterizer/freedoms.hpp"
#include "rasterizer/rules.hpp"
#include "scene/scene.hpp"

namespace rasterdiff::rasterizer {

/// One freedom for each plane of Frame: depth (if there is one), varyings, built-ins, then resolved planes; None where
/// nothing but the evaluation is free.
[[nodiscard]] std::vector<Freedom> valueFreedoms(const Scene& scene, const Rules& rules);

}  // namespace rasterdiff::rasterizer
