// The stipple counter s at the start of a line segment, with what a device may have made of it before.
// [vk:primsrast-lines-stipple]
#pragma once

#include <cstdint>

namespace rasterdiff::rasterizer {

struct StippleCounter {
  uint64_t s = 0;                    ///< nominal
  uint64_t lowest = 0, highest = 0;  ///< legal counters of devices that do not carry a remainder
  /// Length of the strip so far, for devices that carry the remainder of a rectangular line to the next segment.
  double carried = 0, uncertainty = 0;  ///< 1/256 pixel
  bool free = false;                    ///< a clipped line came before: any value is legal
};

}  // namespace rasterdiff::rasterizer
