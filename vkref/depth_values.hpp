// Depths as attachments store them, turned into the floats of a Frame.
#pragma once

#include <volk.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace rasterdiff::vkref {

/// k / (2^bits - 1), rounded to the nearest float. [vk:fundamentals-fixedconv]
[[nodiscard]] float unormDepth(uint32_t k, uint32_t bits);

/// Texels that were copied to a buffer: `count` of copiedBytes(format) each.
[[nodiscard]] std::vector<float> copiedDepths(VkFormat format, const std::byte* from, size_t count);

/// Floats that a shader fetched: behind each of a format of integers, the integer is found again and converted anew,
/// since a fetch need not round as it should.
void restoreFetchedDepths(VkFormat format, std::vector<float>& depths);

}  // namespace rasterdiff::vkref
