// The knobs a device advertises that change what a right picture is (VkPhysicalDeviceLimits and extension properties).
#pragma once

#include <cstdint>

namespace rasterdiff {

struct Limits {
  uint32_t subPixelPrecisionBits = 8;   ///< [vk:limits-subPixelPrecisionBits] at least 4
  uint32_t viewportSubPixelBits = 0;
  uint32_t framebufferSampleCounts = 0x5;  ///< bit n set: n samples offered (1, 4, ...)
  bool standardSampleLocations = true;
  uint32_t maxFramebufferWidth = 16384, maxFramebufferHeight = 16384;
  bool provokingVertexLast = true;
  bool depthClipControl = true;
  friend bool operator==(const Limits&, const Limits&) = default;
};

}  // namespace rasterdiff
