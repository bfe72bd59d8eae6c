// Vulkan's own enumerants, names and values unchanged, without a dependency on Vulkan's headers.
#pragma once

#include <cstdint>

namespace rasterdiff {

enum class PrimitiveTopology : uint32_t { TRIANGLE_LIST = 3, TRIANGLE_STRIP = 4, TRIANGLE_FAN = 5 };
enum class CullMode : uint32_t { NONE = 0, FRONT = 1, BACK = 2, FRONT_AND_BACK = 3 };
enum class FrontFace : uint32_t { COUNTER_CLOCKWISE = 0, CLOCKWISE = 1 };
enum class ProvokingVertexMode : uint32_t { FIRST_VERTEX = 0, LAST_VERTEX = 1 };
enum class CompareOp : uint32_t {
  NEVER = 0, LESS = 1, EQUAL = 2, LESS_OR_EQUAL = 3, GREATER = 4, NOT_EQUAL = 5, GREATER_OR_EQUAL = 6, ALWAYS = 7
};
enum class DepthFormat : uint32_t { D32_SFLOAT = 126 };

/// VkPointClippingBehavior, as the device advertises it.
enum class PointClippingBehavior : uint32_t { ALL_CLIP_PLANES = 0, USER_CLIP_PLANES_ONLY = 1 };

/// How a fragment shader input is interpolated; `smooth` is Vulkan's undecorated, perspective-correct default.
enum class Interpolation : uint32_t { smooth = 0, noperspective = 1, flat = 2 };

}  // namespace rasterdiff
