// What every coverage kernel takes: a triangle after snapping, three integer positions and nothing else.
#pragma once

#include <array>

#include "scene/spaces.hpp"

namespace rasterdiff::rasterizer {

/// Three vertices in 1/256 pixel, y down, in either winding (both are drawn). Zero area covers nothing.
struct SnappedTriangle {
  std::array<SubpixelPosition, 3> v;
  friend bool operator==(const SnappedTriangle&, const SnappedTriangle&) = default;
};

/// A sample's offset from its pixel's corner, in 1/256 pixel (a location is given in 1/16 pixel).
inline constexpr int32_t kSampleUnit = kSubpixelOne / 16;

}  // namespace rasterdiff::rasterizer
