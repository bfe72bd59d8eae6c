// Vulkan's own enumerants, names and values unchanged, without a dependency on Vulkan's headers.
#pragma once

#include <cstdint>

namespace rasterdiff {

enum class PrimitiveTopology : uint32_t {
  POINT_LIST = 0, LINE_LIST = 1, LINE_STRIP = 2, TRIANGLE_LIST = 3, TRIANGLE_STRIP = 4, TRIANGLE_FAN = 5
};
enum class PolygonMode : uint32_t { FILL = 0, LINE = 1, POINT = 2 };
enum class LineRasterizationMode : uint32_t { DEFAULT = 0, RECTANGULAR = 1, BRESENHAM = 2, RECTANGULAR_SMOOTH = 3 };
enum class CullMode : uint32_t { NONE = 0, FRONT = 1, BACK = 2, FRONT_AND_BACK = 3 };
enum class FrontFace : uint32_t { COUNTER_CLOCKWISE = 0, CLOCKWISE = 1 };
enum class ProvokingVertexMode : uint32_t { FIRST_VERTEX = 0, LAST_VERTEX = 1 };
enum class CompareOp : uint32_t {
  NEVER = 0, LESS = 1, EQUAL = 2, LESS_OR_EQUAL = 3, GREATER = 4, NOT_EQUAL = 5, GREATER_OR_EQUAL = 6, ALWAYS = 7
};
enum class DepthFormat : uint32_t {
  D16_UNORM = 124, X8_D24_UNORM_PACK32 = 125, D32_SFLOAT = 126, D24_UNORM_S8_UINT = 129, D32_SFLOAT_S8_UINT = 130
};
enum class ResolveMode : uint32_t { SAMPLE_ZERO = 1, AVERAGE = 2, MIN = 4, MAX = 8 };

/// VkPointClippingBehavior, as the device advertises it.
enum class PointClippingBehavior : uint32_t { ALL_CLIP_PLANES = 0, USER_CLIP_PLANES_ONLY = 1 };

/// How a fragment shader input is interpolated; `smooth` is Vulkan's undecorated, perspective-correct default.
/// `offset` is interpolateAtOffset of an undecorated input, by Varying::offset pixels.
enum class Interpolation : uint32_t { smooth = 0, noperspective = 1, flat = 2, centroid = 3, sample = 4, offset = 5 };

/// What the fragment shader writes to SampleMask (SPIR-V's BuiltIn, as an output).
enum class ShaderSampleMask : uint32_t {
  NONE,           ///< nothing: it has no such output
  CONSTANT,       ///< its draw's shaderSampleMaskBits
  INPUT_SHIFTED,  ///< (the SampleMask that it reads << 1) & its draw's shaderSampleMaskBits
};

/// Fragment shader built-ins that a scene may observe: each becomes a plane of that name.
enum class BuiltIn : uint32_t { FragCoord, FrontFacing, PointCoord, SampleMask, SampleId, SamplePosition };

}  // namespace rasterdiff
