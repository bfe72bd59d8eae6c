// Ways to draw a thin line, by name: the lecture's three versions as it gives them, and the two exact ones.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "rasterizer/methods/pixel_mask.hpp"
#include "scene/spaces.hpp"

namespace rasterdiff::rasterizer {

/// Bresenham in four cases of the slope m (lecture "The Bresenham Line Algorithm"): an error term ε in float32 decides
/// when the short coordinate steps. Draws both ends, from the smaller coordinate up. Made for ends on pixel centres;
/// others keep their fraction. A vertical line has no m and goes to the cases |m| > 1 with 1/m = 0.
[[nodiscard]] std::vector<PixelIndex> drawLineFourOctants(SubpixelPosition a, SubpixelPosition b);

/// "Nicer": one loop over the longer axis, the shorter coordinate computed at every pixel centre, both end pixels
/// drawn. Equal extents take x as the longer axis, which the lecture leaves open.
[[nodiscard]] std::vector<PixelIndex> drawLineLongAxis(SubpixelPosition a, SubpixelPosition b);

/// "Even nicer" with the simple half of the lecture's task: an end pixel goes if its end lies inside its open diamond.
[[nodiscard]] std::vector<PixelIndex> drawLineLongAxisTrimmed(SubpixelPosition a, SubpixelPosition b);

/// diamond_exit.hpp under each rule, from a to b. The first is the exact answer.
[[nodiscard]] std::vector<PixelIndex> drawLineDiamondVulkan(SubpixelPosition a, SubpixelPosition b);
[[nodiscard]] std::vector<PixelIndex> drawLineDiamondDirect3D11(SubpixelPosition a, SubpixelPosition b);

struct LineMethod {
  std::string_view name, what;
  std::vector<PixelIndex> (*draw)(SubpixelPosition a, SubpixelPosition b);
};

/// "four-octant", "long-axis", "long-axis-trimmed", "diamond-exit-vulkan", "diamond-exit-d3d11".
[[nodiscard]] std::span<const LineMethod> lineMethods();

}  // namespace rasterdiff::rasterizer
