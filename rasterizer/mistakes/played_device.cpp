#include "rasterizer/mistakes/played_device.hpp"

namespace rasterdiff::rasterizer {

Limits playedDevice(DeliberateError error) {
  Limits limits;
  limits.viewportSubPixelBits = 8;
  limits.framebufferSampleCounts = 0x1F;
  limits.sampleLocationSampleCounts = 0x1E;
  limits.maxSampleLocationGridWidth = limits.maxSampleLocationGridHeight = 4;
  limits.smoothLines = true;
  limits.stippledRectangularLines = limits.stippledBresenhamLines = true;
  limits.lineWidthMax = 255;
  limits.lineWidthGranularity = 1.0F / 128;
  limits.pointSizeMin = 0;
  limits.pointSizeMax = 255;
  limits.pointSizeGranularity = 0.125F;
  limits.strictLines = error != DeliberateError::ParallelogramSquare;
  return limits;
}

}  // namespace rasterdiff::rasterizer
