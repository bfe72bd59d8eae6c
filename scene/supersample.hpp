// Supersampling from outside a renderer: the scene n times as large, and the average of what comes out.
#pragma once

#include "scene/frame.hpp"
#include "scene/scene.hpp"

namespace rasterdiff {

/// The scene that a renderer draws for `target.supersample` = n: extents, viewports, scissors, line widths, point sizes
/// and stipple factor n times as large, depth slopes (per pixel) as steep as before, `supersample` 1. A valid scene
/// stays valid. Clip positions and interpolation offsets (of the smaller pixels) stay as they are.
[[nodiscard]] Scene supersampled(const Scene& scene);

/// Each value the mean of n × n pixels, sample by sample, summed in double; width and height are divided by n, and an
/// incomplete last row or column of blocks is left out. n = 0 gives an empty plane.
[[nodiscard]] Plane<float> boxAveraged(const Plane<float>& plane, uint32_t n);

}  // namespace rasterdiff
