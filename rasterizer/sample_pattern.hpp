// Where the samples of a pixel are, in 1/256 pixel. [vk:primsrast-multisampling] [choice:sample-locations]
#pragma once

#include <vector>

#include "rasterizer/rules.hpp"
#include "scene/spaces.hpp"

namespace rasterdiff::rasterizer {

/// Offsets from the pixel's top-left corner. Error: NotOffered for a count without standard locations.
[[nodiscard]] Result<std::vector<SubpixelPosition>> samplePattern(uint32_t samples, const Rules& rules);

}  // namespace rasterdiff::rasterizer
