// The one file that includes the generated SPIR-V.
#include "vkref/shader_code.hpp"

#include "shaders/spirv.hpp"

namespace rasterdiff::vkref {
namespace {

using Modules = std::span<const std::span<const uint32_t>>;

/// Fragment shaders that write the same to SampleMask.
struct FragmentTables {
  Modules plain, withBuiltin, withPrimitive;  ///< by number of varyings
  Modules builtIns, builtInsWithAlpha;        ///< by BuiltIn
};

constexpr FragmentTables kTables[] = {
    {spirv::kFragment, spirv::kFragmentWithBuiltin, spirv::kFragmentWithPrimitive, spirv::kBuiltIns,
     spirv::kBuiltInsWithAlpha},
    {spirv::kFragmentMaskConstant, spirv::kFragmentWithBuiltinMaskConstant, spirv::kFragmentWithPrimitiveMaskConstant,
     spirv::kBuiltInsMaskConstant, spirv::kBuiltInsWithAlphaMaskConstant},
    {spirv::kFragmentMaskShifted, spirv::kFragmentWithBuiltinMaskShifted, spirv::kFragmentWithPrimitiveMaskShifted,
     spirv::kBuiltInsMaskShifted, spirv::kBuiltInsWithAlphaMaskShifted},
};

const FragmentTables& tablesOf(ShaderSampleMask mask) { return kTables[static_cast<size_t>(mask)]; }

}  // namespace

std::span<const uint32_t> vertexCode(PrimitiveSource source, uint32_t varyings, VertexExtras extras) {
  const bool numbered = source == PrimitiveSource::Vertex;
  if (!extras.any()) return numbered ? spirv::kVertexWithPrimitive[varyings] : spirv::kVertex[varyings];
  const size_t index = (extras.pointSize ? 1U : 0U) + (extras.clipDistances ? 2U : 0U) +
                       (extras.cullDistances ? 4U : 0U) + (extras.viewportIndex ? 8U : 0U);
  return numbered ? spirv::kVertexExtrasWithPrimitive[index] : spirv::kVertexExtras[index];
}

std::span<const uint32_t> fragmentCode(PrimitiveSource source, uint32_t varyings, ShaderSampleMask mask) {
  const FragmentTables& tables = tablesOf(mask);
  switch (source) {
    case PrimitiveSource::Builtin:
      return tables.withBuiltin[varyings];
    case PrimitiveSource::Vertex:
      return tables.withPrimitive[varyings];
    case PrimitiveSource::None:
      break;
  }
  return tables.plain[varyings];
}

std::span<const uint32_t> builtInCode(BuiltIn builtIn, bool alpha, ShaderSampleMask mask) {
  const FragmentTables& tables = tablesOf(mask);
  const size_t index = static_cast<size_t>(builtIn);
  return alpha ? tables.builtInsWithAlpha[index] : tables.builtIns[index];
}

std::span<const uint32_t> unpackCode(bool unsignedIntegers) {
  return unsignedIntegers ? spirv::kUnpackUint : spirv::kUnpackFloat;
}

}  // namespace rasterdiff::vkref
