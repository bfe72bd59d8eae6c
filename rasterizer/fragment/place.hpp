// Where a fragment is, and where within it a value is evaluated.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "scene/spaces.hpp"

namespace rasterdiff::rasterizer {

/// One sample of one fragment.
struct FragmentPlace {
  int32_t x = 0, y = 0;    ///< pixel
  uint32_t sample = 0;
  uint32_t covered = 1;    ///< bit s: the fragment covers sample s [vk:primsrast-multisampling-coverage-mask]
};

/// A point of the screen in pixels.
struct Spot {
  double x = 0, y = 0;
};

/// Where a value is evaluated, and the corners of the region in which it may legally be evaluated instead (convex;
/// none: there and nowhere else). Extremes of linear functions and of their quotients are at corners.
struct EvaluationRegion {
  Spot nominal;
  std::span<const Spot> corners;
};

/// The same for one place or the pixel around it, with as many corners as the compiler knows: 0 or 4.
template <size_t kCorners>
struct PixelRegion {
  Spot nominal;
  std::array<Spot, kCorners> corners;
};

template <size_t kCorners>
[[nodiscard]] PixelRegion<kCorners> pixelRegion(const Spot& centre) {
  PixelRegion<kCorners> region{centre, {}};
  if constexpr (kCorners == 4) {
    const double left = centre.x - 0.5, right = centre.x + 0.5, top = centre.y - 0.5, bottom = centre.y + 0.5;
    region.corners = {{{left, top}, {right, top}, {left, bottom}, {right, bottom}}};
  }
  return region;
}

[[nodiscard]] inline Spot centreOf(const FragmentPlace& place) { return {place.x + 0.5, place.y + 0.5}; }

/// `pattern`: sample offsets in 1/256 pixel.
[[nodiscard]] inline Spot sampleOf(const FragmentPlace& place, uint32_t sample, std::span<const SubpixelPosition> pattern) {
  return {place.x + pattern[sample].x / double{kSubpixelOne}, place.y + pattern[sample].y / double{kSubpixelOne}};
}

}  // namespace rasterdiff::rasterizer
