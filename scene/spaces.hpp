// Coordinate spaces as types, so that a mix-up does not compile. Conversions live with the stage that performs them.
#pragma once

#include <cstdint>

namespace rasterdiff {

/// Clip space, as a vertex shader writes it: homogeneous, float32.
struct ClipPosition {
  float x = 0, y = 0, z = 0, w = 1;
  friend bool operator==(const ClipPosition&, const ClipPosition&) = default;
};

/// Framebuffer space in pixels, y down, origin at the top-left corner of pixel (0, 0). Depth in z.
struct FramebufferPosition {
  double x = 0, y = 0, z = 0;
};

/// Framebuffer space on the reference's grid of 1/256 pixel.  // Q23.8, |v| < 2^31
/// A device with fewer subpixel bits uses a subset of this grid.
struct SubpixelPosition {
  int32_t x = 0, y = 0;
  friend bool operator==(const SubpixelPosition&, const SubpixelPosition&) = default;
};

inline constexpr int kSubpixelBits = 8;
inline constexpr int32_t kSubpixelOne = 1 << kSubpixelBits;

}  // namespace rasterdiff
