// The SPIR-V modules that are compiled into the program, by what a pass needs.
#pragma once

#include <compare>
#include <cstdint>
#include <span>

#include "scene/vulkan_enums.hpp"

namespace rasterdiff::vkref {

/// Where a fragment takes its primitive's number from.
enum class PrimitiveSource : uint8_t {
  None,     ///< the pass writes no primitive numbers
  Builtin,  ///< gl_PrimitiveID
  Vertex,   ///< a flat output of the provoking vertex
};

/// What few scenes need of a vertex shader.
struct VertexExtras {
  bool pointSize = false, clipDistances = false, cullDistances = false, viewportIndex = false;
  [[nodiscard]] bool any() const { return pointSize || clipDistances || cullDistances || viewportIndex; }
  friend auto operator<=>(const VertexExtras&, const VertexExtras&) = default;
};

/// With any extras, the shader has all six varyings, whatever `varyings` is.
[[nodiscard]] std::span<const uint32_t> vertexCode(PrimitiveSource source, uint32_t varyings, VertexExtras extras);
[[nodiscard]] std::span<const uint32_t> fragmentCode(PrimitiveSource source, uint32_t varyings, ShaderSampleMask mask);
/// `alpha`: output 0 is input 0, output 1 the built-in; else output 0 is the built-in.
[[nodiscard]] std::span<const uint32_t> builtInCode(BuiltIn builtIn, bool alpha, ShaderSampleMask mask);
[[nodiscard]] std::span<const uint32_t> unpackCode(bool unsignedIntegers);

}  // namespace rasterdiff::vkref
