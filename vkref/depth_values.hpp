// Depths as attachments store them, turned into the floats of a Frame.
#pragma once

#include <volk.h>

#include <cstddef>
#include <cstdint>
#include <span>

namespace rasterdiff::vkref {

/// k / (2^bits - 1), rounded to the nearest float. [vk:fundamentals-fixedconv]
[[nodiscard]] float unormDepth(uint32_t k, uint32_t bits);

/// Texels that were copied to a buffer, depths.size() of copiedBytes(format) each.
void copyDepths(VkFormat format, const std::byte* from, std::span<float> depths);

/// The arithmetic of a fetch.
enum class DepthFetch : uint8_t {
  Quotient,    ///< unormDepth
  Reciprocal,  ///< k × (1 / (2^bits - 1)), each rounded to float: the two largest 24-bit integers both give 1
};

/// What a shader fetches where the integer k is stored.
[[nodiscard]] float fetchedDepth(DepthFetch fetch, uint32_t k, uint32_t bits);

/// Floats that a shader fetched: behind each of a format of integers, the integer is found again and converted anew. Where
/// two integers give the same float, the larger one is meant.
void restoreFetchedDepths(VkFormat format, DepthFetch fetch, std::span<float> depths);

}  // namespace rasterdiff::vkref
