#include "harness/export/amber_shaders.hpp"

#include <fmt/format.h>

#include "harness/export/amber_vertices.hpp"
#include "scene/primitive_class.hpp"

namespace rasterdiff::harness {
namespace {

std::string_view qualifier(Interpolation interpolation) {
  switch (interpolation) {
    case Interpolation::smooth:
    case Interpolation::offset: break;
    case Interpolation::noperspective: return "noperspective ";
    case Interpolation::flat: return "flat ";
    case Interpolation::centroid: return "centroid ";
    case Interpolation::sample: return "sample ";
  }
  return "";
}

std::string_view vectorOf(uint32_t components) {
  constexpr std::string_view kTypes[] = {"float", "vec2", "vec3", "vec4"};
  return kTypes[components - 1];
}

constexpr std::string_view kSwizzles[] = {".x", ".xy", ".xyz", ""};

std::string distance(uint32_t index) { return fmt::format("uintBitsToFloat(distances{}[{}])", index / 4, index % 4); }

}  // namespace

std::string amberVertexShader(const Scene& scene) {
  const Draw& draw = scene.draws.front();
  const uint32_t clip = draw.clipDistanceCount, cull = draw.cullDistanceCount;
  std::string inputs = fmt::format("layout(location = {}) in uvec4 position;\nlayout(location = {}) in uvec2 numbers;\n", kAmberPosition, kAmberNumbers);
  std::string outputs = "layout(location = 0) flat out uint primitive;\n";
  std::string built = "  vec4 gl_Position;\n", body;
  for (uint32_t i = 0; 4 * i < clip + cull; ++i) {
    inputs += fmt::format("layout(location = {}) in uvec4 distances{};\n", kAmberDistances + i, i);
  }
  if (drawsPoints(scene.state)) {
    built += "  float gl_PointSize;\n";
    body += "  gl_PointSize = uintBitsToFloat(numbers.y);\n";
  }
  if (clip > 0) built += fmt::format("  float gl_ClipDistance[{}];\n", clip);
  if (cull > 0) built += fmt::format("  float gl_CullDistance[{}];\n", cull);
  for (uint32_t i = 0; i < clip; ++i) body += fmt::format("  gl_ClipDistance[{}] = {};\n", i, distance(i));
  for (uint32_t i = 0; i < cull; ++i) body += fmt::format("  gl_CullDistance[{}] = {};\n", i, distance(clip + i));
  for (size_t v = 0; v < draw.varyings.size(); ++v) {
    const Varying& varying = draw.varyings[v];
    inputs += fmt::format("layout(location = {}) in uvec4 bits{};\n", kAmberVaryings + v, v);
    outputs += fmt::format("layout(location = {}) {}out {} given{};\n", 1 + v, qualifier(varying.interpolation), vectorOf(varying.components), v);
    body += fmt::format("  given{0} = uintBitsToFloat(bits{0}{1});\n", v, kSwizzles[varying.components - 1]);
  }
  return fmt::format(
      "#version 450\n{}{}out gl_PerVertex {{\n{}}};\n\nvoid main() {{\n  gl_Position = uintBitsToFloat(position);\n  primitive = numbers.x;\n{}}}\n",
      inputs, outputs, built, body);
}

std::string amberPrimitiveShader() {
  return "#version 450\nlayout(location = 0) flat in uint primitive;\nlayout(location = 0) out uint drawn;\n\nvoid main() { drawn = primitive; }\n";
}

std::string amberVaryingShader(const Varying& varying, size_t index) {
  std::string zeros;
  for (uint32_t c = varying.components; c < 4; ++c) zeros += ", 0.0";
  return fmt::format(
      "#version 450\nlayout(location = {}) {}in {} given;\nlayout(location = 0) out vec4 drawn;\n\nvoid main() {{\n  vec4 value = vec4(given{});\n"
      "  drawn = mix(value, vec4(uintBitsToFloat(0x7F7FFFFFu)), isnan(value));\n}}\n",
      1 + index, qualifier(varying.interpolation), vectorOf(varying.components), zeros);
}

std::string amberMaskShader(const Target& target) {
  return fmt::format(
      "#version 450\nlayout(location = 0) flat in uint primitive;\nlayout(location = 0) out vec4 colour;\nlayout(set = 0, binding = 0) buffer Masks {{ uint masks[]; }};\n\nvoid main() {{\n"
      "  uint pixel = uint(gl_FragCoord.y) * {0}u + uint(gl_FragCoord.x);\n"
      "  atomicOr(masks[(primitive - 1u) * {1}u + pixel], uint(gl_SampleMaskIn[0]));\n  colour = vec4(1.0);\n}}\n",
      target.width, uint64_t{target.width} * target.height);
}

}  // namespace rasterdiff::harness
