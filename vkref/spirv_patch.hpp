// Small changes to compiled fragment shaders, so that one module serves every mix of interpolations and outputs.
#pragma once

#include <compare>
#include <cstdint>
#include <span>
#include <vector>

#include "scene/vulkan_enums.hpp"

namespace rasterdiff::vkref {

/// How one input of a fragment shader is interpolated.
struct InputInterpolation {
  Interpolation mode = Interpolation::smooth;
  float offsetX = 0, offsetY = 0;  ///< pixels, for Interpolation::offset
  friend auto operator<=>(const InputInterpolation&, const InputInterpolation&) = default;
};

/// A copy of `module` in which the input variable at location i is interpolated as interpolations[i]: by a decoration
/// (`smooth`: none), or, for `offset`, by interpolateAtOffset instead of a load. The capabilities that this takes are
/// declared. Inputs beyond `interpolations` are left alone.
[[nodiscard]] std::vector<uint32_t> withInterpolations(std::span<const uint32_t> module,
                                                       std::span<const InputInterpolation> interpolations);

/// A copy of `module` in which the output at `location` has moved to location 0 and those before it one further.
[[nodiscard]] std::vector<uint32_t> withOutputFirst(std::span<const uint32_t> module, uint32_t location);

}  // namespace rasterdiff::vkref
