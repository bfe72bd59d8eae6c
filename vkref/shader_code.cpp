// The one file that includes the generated SPIR-V.
#include "vkref/shader_code.hpp"

#include "shaders/spirv.hpp"

namespace rasterdiff::vkref {

std::span<const uint32_t> vertexCode(PrimitiveSource source, uint32_t varyings, VertexExtras extras) {
  const bool numbered = source == PrimitiveSource::Vertex;
  if (!extras.any()) return numbered ? spirv::kVertexWithPrimitive[varyings] : spirv::kVertex[varyings];
  const size_t index = (extras.pointSize ? 1U : 0U) + (extras.clipDistances ? 2U : 0U) +
                       (extras.cullDistances ? 4U : 0U) + (extras.viewportIndex ? 8U : 0U);
  return numbered ? spirv::kVertexExtrasWithPrimitive[index] : spirv::kVertexExtras[index];
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

std::span<const uint32_t> builtInCode(BuiltIn builtIn, bool alpha) {
  const size_t index = static_cast<size_t>(builtIn);
  return alpha ? spirv::kBuiltInsWithAlpha[index] : spirv::kBuiltIns[index];
}

std::span<const uint32_t> unpackCode(bool unsignedIntegers) {
  return unsignedIntegers ? spirv::kUnpackUint : spirv::kUnpackFloat;
}

}  // namespace rasterdiff::vkref
