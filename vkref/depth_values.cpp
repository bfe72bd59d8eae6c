// Conversions of stored depths; which transfer a plane came by is readback.cpp's business.
#include "vkref/depth_values.hpp"

#include <cmath>
#include <cstring>

#include "vkref/formats.hpp"

namespace rasterdiff::vkref {

// The quotient in double never lies on the middle between two floats: its bits repeat with period `bits`, so that no
// run of zeros or ones is long enough. Rounding twice is rounding once.
float unormDepth(uint32_t k, uint32_t bits) {
  return static_cast<float>(static_cast<double>(k) / static_cast<double>((1U << bits) - 1));
}

void copyDepths(VkFormat format, const std::byte* from, std::span<float> depths) {
  const uint32_t bits = unormDepthBits(format);
  const size_t bytes = static_cast<size_t>(copiedBytes(format));
  if (bits == 0) {
    std::memcpy(depths.data(), from, depths.size() * bytes);
    return;
  }
  for (float& depth : depths) {
    uint32_t k = 0;  // [vk:VkBufferImageCopy] 24 bits lie in the low bits of a word whose high bits are undefined
    std::memcpy(&k, from, bytes);
    depth = unormDepth(k & ((1U << bits) - 1), bits);
    from += bytes;
  }
}

float fetchedDepth(DepthFetch fetch, uint32_t k, uint32_t bits) {
  if (fetch == DepthFetch::Quotient) return unormDepth(k, bits);
  return static_cast<float>(k) * static_cast<float>(1.0 / ((1U << bits) - 1));
}

void restoreFetchedDepths(VkFormat format, DepthFetch fetch, std::span<float> depths) {
  const uint32_t bits = unormDepthBits(format);
  if (bits == 0) return;
  const int64_t largest = (int64_t{1} << bits) - 1;
  for (float& depth : depths) {
    const int64_t near = std::llround(static_cast<double>(depth) * static_cast<double>(largest));
    uint32_t best = 0;
    float error = 2;
    for (int64_t k = near - 2; k <= near + 2; ++k) {  // either arithmetic is off by less than two steps
      if (k < 0 || k > largest) continue;
      const float distance = std::abs(fetchedDepth(fetch, static_cast<uint32_t>(k), bits) - depth);
      if (distance > error) continue;
      best = static_cast<uint32_t>(k);
      error = distance;
    }
    depth = unormDepth(best, bits);
  }
}

}  // namespace rasterdiff::vkref
