// The one file that includes the generated SPIR-V.
#include "vkref/shader_code.hpp"

#include "shaders/spirv.hpp"

namespace rasterdiff::vkref {

std::span<const uint32_t> vertexCode(PrimitiveSource source, uint32_t varyings) {
  return source == PrimitiveSource::Vertex ? spirv::kVertexWithPrimitive[varyings] : spirv::kVertex[varyings];
}

std::span<const uint32_t> fragmentCode(PrimitiveSource source, uint32_t varyings) {
  switch (source) {
    case PrimitiveSource::Builtin:
      return spirv::kFragmentWithBuiltin[varyings];
    case PrimitiveSource::Vertex:
      return spirv::kFragmentWithPrimitive[varyings];
    case PrimitiveSource::None:
      break;
  }
  return spirv::kFragment[varyings];
}

std::span<const uint32_t> unpackCode(bool unsignedIntegers) {
  return unsignedIntegers ? spirv::kUnpackUint : spirv::kUnpackFloat;
}

}  // namespace rasterdiff::vkref
