// Puts interpolation decorations on the inputs of a compiled fragment shader, so that one module serves every mix.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "scene/vulkan_enums.hpp"

namespace rasterdiff::vkref {

/// A copy of `module` in which the input variable at location i carries the decoration of interpolations[i]
/// (`smooth`: none). Inputs beyond `interpolations` are left alone.
[[nodiscard]] std::vector<uint32_t> withInterpolations(std::span<const uint32_t> module,
                                                       std::span<const Interpolation> interpolations);

}  // namespace rasterdiff::vkref
