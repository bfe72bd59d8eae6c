// The knobs a device advertises that change what a right picture is (VkPhysicalDeviceLimits and extension properties).
#pragma once

#include <cstdint>

#include "scene/vulkan_enums.hpp"

namespace rasterdiff {

struct Limits {
  uint32_t subPixelPrecisionBits = 8;   ///< [vk:limits-subPixelPrecisionBits] at least 4
  uint32_t viewportSubPixelBits = 0;
  uint32_t framebufferSampleCounts = 0x5;  ///< bit n set: n samples offered (1, 4, ...)
  bool standardSampleLocations = true;
  uint32_t sampleLocationSampleCounts = 0;  ///< bit n set: custom locations for n samples
  uint32_t maxSampleLocationGridWidth = 1, maxSampleLocationGridHeight = 1;
  float sampleLocationCoordinateMin = 0, sampleLocationCoordinateMax = 0.9375F;  ///< sampleLocationCoordinateRange
  uint32_t sampleLocationSubPixelBits = 4;
  uint32_t maxFramebufferWidth = 16384, maxFramebufferHeight = 16384;
  bool provokingVertexLast = true;
  bool depthClipControl = true;
  bool strictLines = true;
  bool rectangularLines = true, bresenhamLines = true, smoothLines = false;
  bool stippledRectangularLines = false, stippledBresenhamLines = false;
  float lineWidthMin = 1, lineWidthMax = 1, lineWidthGranularity = 0;
  float pointSizeMin = 1, pointSizeMax = 1, pointSizeGranularity = 0;
  PointClippingBehavior pointClippingBehavior = PointClippingBehavior::ALL_CLIP_PLANES;
  uint32_t subPixelInterpolationOffsetBits = 4;
  float minInterpolationOffset = -0.5F, maxInterpolationOffset = 0.4375F;
  friend bool operator==(const Limits&, const Limits&) = default;
};

}  // namespace rasterdiff
