// The GLSL of an Amber script.
#pragma once

#include <string>

#include "scene/scene.hpp"

namespace rasterdiff::harness {

/// Turns bits into floats; gives the number of the primitive at location 0 and varying v at location 1 + v.
[[nodiscard]] std::string amberVertexShader(const Scene& scene);

/// Writes the number of the primitive.
[[nodiscard]] std::string amberPrimitiveShader();

/// Writes a varying, zero in the components that it has not. NaN becomes the largest float, since it would pass every comparison.
[[nodiscard]] std::string amberVaryingShader(const Varying& varying, size_t index);

/// Collects the samples of each primitive at each pixel in a storage buffer: bit s of word
/// (primitive - 1) · width · height + y · width + x.
[[nodiscard]] std::string amberMaskShader(const Target& target);

}  // namespace rasterdiff::harness
