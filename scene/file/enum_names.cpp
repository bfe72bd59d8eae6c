#include "scene/file/enum_names.hpp"

#include "scene/built_ins.hpp"

namespace rasterdiff {

template <>
std::span<const EnumName<PrimitiveTopology>> enumNames() {
  using enum PrimitiveTopology;
  static constexpr EnumName<PrimitiveTopology> kNames[] = {
      {"POINT_LIST", POINT_LIST},       {"LINE_LIST", LINE_LIST},           {"LINE_STRIP", LINE_STRIP},
      {"TRIANGLE_LIST", TRIANGLE_LIST}, {"TRIANGLE_STRIP", TRIANGLE_STRIP}, {"TRIANGLE_FAN", TRIANGLE_FAN}};
  return kNames;
}

template <>
std::span<const EnumName<PolygonMode>> enumNames() {
  using enum PolygonMode;
  static constexpr EnumName<PolygonMode> kNames[] = {{"FILL", FILL}, {"LINE", LINE}, {"POINT", POINT}};
  return kNames;
}

template <>
std::span<const EnumName<LineRasterizationMode>> enumNames() {
  using enum LineRasterizationMode;
  static constexpr EnumName<LineRasterizationMode> kNames[] = {{"DEFAULT", DEFAULT},
                                                               {"RECTANGULAR", RECTANGULAR},
                                                               {"BRESENHAM", BRESENHAM},
                                                               {"RECTANGULAR_SMOOTH", RECTANGULAR_SMOOTH}};
  return kNames;
}

template <>
std::span<const EnumName<CullMode>> enumNames() {
  using enum CullMode;
  static constexpr EnumName<CullMode> kNames[] = {
      {"NONE", NONE}, {"FRONT", FRONT}, {"BACK", BACK}, {"FRONT_AND_BACK", FRONT_AND_BACK}};
  return kNames;
}

template <>
std::span<const EnumName<FrontFace>> enumNames() {
  using enum FrontFace;
  static constexpr EnumName<FrontFace> kNames[] = {{"COUNTER_CLOCKWISE", COUNTER_CLOCKWISE}, {"CLOCKWISE", CLOCKWISE}};
  return kNames;
}

template <>
std::span<const EnumName<ProvokingVertexMode>> enumNames() {
  using enum ProvokingVertexMode;
  static constexpr EnumName<ProvokingVertexMode> kNames[] = {{"FIRST_VERTEX", FIRST_VERTEX},
                                                             {"LAST_VERTEX", LAST_VERTEX}};
  return kNames;
}

template <>
std::span<const EnumName<CompareOp>> enumNames() {
  using enum CompareOp;
  static constexpr EnumName<CompareOp> kNames[] = {{"NEVER", NEVER},
                                                   {"LESS", LESS},
                                                   {"EQUAL", EQUAL},
                                                   {"LESS_OR_EQUAL", LESS_OR_EQUAL},
                                                   {"GREATER", GREATER},
                                                   {"NOT_EQUAL", NOT_EQUAL},
                                                   {"GREATER_OR_EQUAL", GREATER_OR_EQUAL},
                                                   {"ALWAYS", ALWAYS}};
  return kNames;
}

template <>
std::span<const EnumName<DepthFormat>> enumNames() {
  using enum DepthFormat;
  static constexpr EnumName<DepthFormat> kNames[] = {{"D16_UNORM", D16_UNORM},
                                                     {"X8_D24_UNORM_PACK32", X8_D24_UNORM_PACK32},
                                                     {"D32_SFLOAT", D32_SFLOAT},
                                                     {"D24_UNORM_S8_UINT", D24_UNORM_S8_UINT},
                                                     {"D32_SFLOAT_S8_UINT", D32_SFLOAT_S8_UINT}};
  return kNames;
}

template <>
std::span<const EnumName<ResolveMode>> enumNames() {
  using enum ResolveMode;
  static constexpr EnumName<ResolveMode> kNames[] = {{"SAMPLE_ZERO", SAMPLE_ZERO}, {"AVERAGE", AVERAGE}, {"MIN", MIN}, {"MAX", MAX}};
  return kNames;
}

template <>
std::span<const EnumName<ShaderSampleMask>> enumNames() {
  using enum ShaderSampleMask;
  static constexpr EnumName<ShaderSampleMask> kNames[] = {{"NONE", NONE}, {"CONSTANT", CONSTANT}, {"INPUT_SHIFTED", INPUT_SHIFTED}};
  return kNames;
}

template <>
std::span<const EnumName<Interpolation>> enumNames() {
  using enum Interpolation;
  static constexpr EnumName<Interpolation> kNames[] = {
      {"smooth", smooth},     {"noperspective", noperspective}, {"flat", flat},
      {"centroid", centroid}, {"sample", sample},               {"offset", offset}};
  return kNames;
}

template <>
std::span<const EnumName<BuiltIn>> enumNames() {
  using enum BuiltIn;
  static constexpr EnumName<BuiltIn> kNames[] = {
      {builtInName(FragCoord), FragCoord},   {builtInName(FrontFacing), FrontFacing},
      {builtInName(PointCoord), PointCoord}, {builtInName(SampleMask), SampleMask},
      {builtInName(SampleId), SampleId},     {builtInName(SamplePosition), SamplePosition}};
  return kNames;
}

}  // namespace rasterdiff
