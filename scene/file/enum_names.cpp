#include "scene/file/enum_names.hpp"

namespace rasterdiff {

template <>
std::span<const EnumName<PrimitiveTopology>> enumNames() {
  using enum PrimitiveTopology;
  static constexpr EnumName<PrimitiveTopology> kNames[] = {
      {"TRIANGLE_LIST", TRIANGLE_LIST}, {"TRIANGLE_STRIP", TRIANGLE_STRIP}, {"TRIANGLE_FAN", TRIANGLE_FAN}};
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
  static constexpr EnumName<DepthFormat> kNames[] = {{"D32_SFLOAT", DepthFormat::D32_SFLOAT}};
  return kNames;
}

template <>
std::span<const EnumName<Interpolation>> enumNames() {
  using enum Interpolation;
  static constexpr EnumName<Interpolation> kNames[] = {
      {"smooth", smooth}, {"noperspective", noperspective}, {"flat", flat}};
  return kNames;
}

}  // namespace rasterdiff
