// Depth formats: how a depth becomes what the attachment holds, and what else it may legally become.
#pragma once

#include "rasterizer/fragment/linear_function.hpp"
#include "scene/vulkan_enums.hpp"

namespace rasterdiff::rasterizer {

/// Bits n of a fixed-point format, whose values are k / (2^n - 1); 0 for float formats.
[[nodiscard]] constexpr uint32_t unormBits(DepthFormat format) {
  switch (format) {
    case DepthFormat::D16_UNORM: return 16;
    case DepthFormat::X8_D24_UNORM_PACK32:
    case DepthFormat::D24_UNORM_S8_UINT: return 24;
    case DepthFormat::D32_SFLOAT:
    case DepthFormat::D32_SFLOAT_S8_UINT: return 0;
  }
  return 0;
}

/// The float32 number nearest to k / (2^bits - 1): how a fixed-point depth is written down in a frame.
[[nodiscard]] inline float fromUnorm(double k, uint32_t bits) {
  return static_cast<float>(k / static_cast<double>((uint64_t{1} << bits) - 1));
}

/// `z` as stored. Fixed point: clamped to [0, 1] and rounded to nearest, where either neighbour is legal and a number on
/// the grid stays. [vk:fundamentals-fpfixedconv] Float formats hold any float32 number.
[[nodiscard]] Interpolated stored(const Interval& z, DepthFormat format);

/// What an attachment holds after it was cleared to `clearValue`.
[[nodiscard]] Interpolated clearedDepth(float clearValue, DepthFormat format);

}  // namespace rasterdiff::rasterizer
