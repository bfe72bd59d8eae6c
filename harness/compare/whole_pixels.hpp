// Bresenham lines cover all samples of a pixel or none, whichever pixels a device chooses: what the three-valued coverage
// of one sample cannot say. [vk:primsrast-lines-bresenham]
#pragma once

#include "scene/frame.hpp"
#include "scene/scene.hpp"

namespace rasterdiff::harness {

/// Is every primitive of the scene a Bresenham line, and does no test take single samples away?
[[nodiscard]] bool coversWholePixels(const Scene& scene);

/// Do all samples of the pixel that the sample mask keeps hold the same primitive, written as often?
[[nodiscard]] bool pixelIsWhole(const Scene& scene, const Frame& frame, uint32_t x, uint32_t y);

}  // namespace rasterdiff::harness
