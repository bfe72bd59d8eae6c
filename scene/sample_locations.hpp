// Vulkan's standard sample locations, in 1/16 pixel from the pixel's top-left corner. [vk:primsrast-multisampling]
#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace rasterdiff {

struct SampleLocation {
  uint8_t x, y;  ///< 1/16 pixel, 0..15  // Q0.4
  friend bool operator==(const SampleLocation&, const SampleLocation&) = default;
};

/// The table for 1, 2, 4, 8 or 16 samples; empty for any other count.
[[nodiscard]] std::span<const SampleLocation> standardSampleLocations(uint32_t samples);

}  // namespace rasterdiff
