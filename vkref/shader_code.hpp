// The SPIR-V modules that are compiled into the program, by what a pass needs.
#pragma once

#include <cstdint>
#include <span>

namespace rasterdiff::vkref {

/// Where a fragment takes its primitive's number from.
enum class PrimitiveSource : uint8_t {
  None,     ///< the pass writes varyings only
  Builtin,  ///< gl_PrimitiveID
  Vertex,   ///< a flat output of the provoking vertex
};

[[nodiscard]] std::span<const uint32_t> vertexCode(PrimitiveSource source, uint32_t varyings);
[[nodiscard]] std::span<const uint32_t> fragmentCode(PrimitiveSource source, uint32_t varyings);
[[nodiscard]] std::span<const uint32_t> unpackCode(bool unsignedIntegers);

}  // namespace rasterdiff::vkref
