// Conversions of stored depths; which transfer a plane came by is readback.cpp's business.
#include "vkref/depth_values.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "vkref/formats.hpp"

namespace rasterdiff::vkref {

// The quotient in double never lies on the middle between two floats: its bits repeat with period `bits`, so that no
// run of zeros or ones is long enough. Rounding twice is rounding once.
float unormDepth(uint32_t k, uint32_t bits) {
  return static_cast<float>(static_cast<double>(k) / static_cast<double>((1U << bits) - 1));
}

std::vector<float> copiedDepths(VkFormat format, const std::byte* from, size_t count) {
  std::vector<float> depths(count);
  const uint32_t bits = unormDepthBits(format);
  const size_t bytes = static_cast<size_t>(copiedBytes(format));
  if (bits == 0) {
    std::memcpy(depths.data(), from, count * bytes);
    return depths;
  }
  for (float& depth : depths) {
    uint32_t k = 0;  // [vk:VkBufferImageCopy] 24 bits lie in the low bits of a word whose high bits are undefined
    std::memcpy(&k, from, bytes);
    depth = unormDepth(k & ((1U << bits) - 1), bits);
    from += bytes;
  }
  return depths;
}

void restoreFetchedDepths(VkFormat format, std::vector<float>& depths) {
  const uint32_t bits = unormDepthBits(format);
  if (bits == 0) return;
  const double largest = (1U << bits) - 1;
  for (float& depth : depths) {
    const double k = std::clamp(std::round(static_cast<double>(depth) * largest), 0.0, largest);
    depth = unormDepth(static_cast<uint32_t>(k), bits);
  }
}

}  // namespace rasterdiff::vkref
