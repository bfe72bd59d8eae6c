#include "harness/export/amber_limits.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "scene/primitive_class.hpp"

namespace rasterdiff::harness {
namespace {

constexpr uint64_t kMostNumbers = uint64_t{1} << 20;  // of the expectations: a script is text

Result<void> unsayable(std::string_view field, std::string_view why, std::string_view hint = "") {
  return fail(ErrorCode::BadInput, std::string(field), "Amber cannot say this: " + std::string(why), std::string(hint));
}

Result<void> checkState(const State& state) {
  const bool triangles = topologyClassOf(state.topology) == TopologyClass::Triangle;
  if (triangles && state.cullMode != CullMode::NONE) return unsayable("state.cullMode", "it draws both faces");
  if (drawsLines(state) && state.lineWidth != 1) return unsayable("state.lineWidth", "its lines are one pixel wide");
  if (drawsLines(state) && state.lineRasterizationMode != LineRasterizationMode::DEFAULT) {
    return unsayable("state.lineRasterizationMode", "its lines are DEFAULT");
  }
  if (state.stippledLineEnable) return unsayable("state.stippledLineEnable", "its lines are whole");
  if (state.negativeOneToOne) return unsayable("state.negativeOneToOne", "depths go from 0 to 1");
  if (state.depthClipEnable.has_value()) return unsayable("state.depthClipEnable", "it is always the opposite of depthClampEnable");
  if (state.shaderSampleMask != ShaderSampleMask::NONE) {
    return fail(ErrorCode::BadInput, "state.shaderSampleMask", "the shaders of an exported script write no sample mask");
  }
  if (state.alphaToCoverageEnable) return unsayable("state.alphaToCoverageEnable", "alpha keeps no samples");
  return {};
}

Result<void> checkTarget(const Scene& scene) {
  const Target& target = scene.target;
  const uint32_t all = (1U << target.samples) - 1;
  if ((scene.state.sampleMask & all) != all) return unsayable("state.sampleMask", "all samples are kept");
  if (scene.scissor) return unsayable("scissor", "the scissor is the whole target");
  if (!scene.furtherViewports.empty()) return unsayable("furtherViewports", "there is one viewport");
  if (target.sampleLocations) return unsayable("target.sampleLocations", "the standard ones are used");
  if (!scene.builtIns.empty()) return unsayable("builtIns", "this export writes varyings and primitives only", "leave builtIns out");
  if (target.samples == 1) return {};
  if (scene.state.depthTestEnable) {
    return unsayable("state.depthTestEnable", "what passes at several samples cannot be read", "draw it with one sample");
  }
  if (scene.state.sampleShadingEnable) return unsayable("state.sampleShadingEnable", "it changes the masks that are read");
  return {};
}

Result<void> checkVaryings(const Scene& scene) {
  if (scene.draws.empty() || scene.target.samples > 1) return {};
  const bool offset = std::ranges::any_of(scene.draws[0].varyings, [](const Varying& v) { return v.interpolation == Interpolation::offset; });
  return offset ? unsayable("varyings", "this export has no interpolateAtOffset", "leave varyings with an offset out") : Result<void>{};
}

Result<void> checkSize(const Scene& scene) {
  const uint64_t pixels = uint64_t{scene.target.width} * scene.target.height;
  const uint64_t primitives = primitiveCount(scene);
  uint64_t components = 1;
  if (!scene.draws.empty()) components += 8 * scene.draws[0].varyings.size();
  const uint64_t numbers = scene.target.samples > 1 ? pixels * primitives : pixels * components;
  if (numbers <= kMostNumbers && primitives <= kMostNumbers) return {};
  return fail(ErrorCode::BadInput, "target", fmt::format("{} expected numbers; a script holds {}", numbers, kMostNumbers),
              "a smaller target, fewer primitives or fewer varyings; rasterdiff hunt shrinks what it finds");
}

}  // namespace

Result<void> sayableInAmber(const Scene& scene) {
  for (const auto check : {checkTarget, checkVaryings, checkSize}) {
    if (Result<void> ok = check(scene); !ok) return ok;
  }
  return checkState(scene.state);
}

}  // namespace rasterdiff::harness
