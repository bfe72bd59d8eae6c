#include "harness/export/amber_script.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "harness/export/amber_expectations.hpp"
#include "harness/export/amber_limits.hpp"
#include "harness/export/amber_shaders.hpp"
#include "harness/export/amber_text.hpp"
#include "harness/export/amber_vertices.hpp"
#include "harness/report/numbers.hpp"
#include "scene/file/enum_names.hpp"
#include "scene/primitive_class.hpp"

namespace rasterdiff::harness {
namespace {

std::string shader(std::string_view stage, std::string_view name, const std::string& source) {
  return fmt::format("SHADER {} {} GLSL\n{}END\n\n", stage, name, source);
}

std::string features(const Scene& scene) {
  const State& state = scene.state;
  std::string text;
  const auto need = [&text](bool needed, std::string_view name) {
    if (needed) text += fmt::format("DEVICE_FEATURE {}\n", name);
  };
  const bool anySize = std::ranges::any_of(scene.draws, [](const Draw& draw) { return !draw.pointSizes.empty(); });
  const bool sampled = std::ranges::any_of(scene.draws[0].varyings, [](const Varying& v) { return v.interpolation == Interpolation::sample; });
  need(state.polygonMode != PolygonMode::FILL, "fillModeNonSolid");
  need(drawsPoints(state) && (anySize || state.pointSize != 1), "largePoints");
  need(scene.draws[0].clipDistanceCount > 0, "shaderClipDistance");
  need(scene.draws[0].cullDistanceCount > 0, "shaderCullDistance");
  need(state.depthClampEnable, "depthClamp");
  need(state.depthBiasEnable && state.depthBiasClamp != 0, "depthBiasClamp");
  need(scene.target.samples > 1, "fragmentStoresAndAtomics");
  need(scene.target.samples == 1 && (sampled || state.sampleShadingEnable), "sampleRateShading");
  return text + "\n";
}

/// As Amber spells it: "less_or_equal".
std::string compareName(CompareOp op) {
  std::string name(enumName(op));
  std::ranges::transform(name, name.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return name;
}

std::string depthState(const State& state) {
  const auto onOff = [](bool on) { return on ? "on" : "off"; };
  std::string text = fmt::format("  DEPTH\n    TEST {}\n    WRITE {}\n    COMPARE_OP {}\n    CLAMP {}\n", onOff(state.depthTestEnable),
                                 onOff(state.depthWriteEnable), compareName(state.depthCompareOp), onOff(state.depthClampEnable));
  if (state.depthBiasEnable) {
    text += fmt::format("    BIAS constant {} clamp {} slope {}\n", amberFloat(state.depthBiasConstantFactor), amberFloat(state.depthBiasClamp),
                        amberFloat(state.depthBiasSlopeFactor));
  }
  return text + "  END\n";
}

/// Everything of a pipeline but its shaders, its size and what it writes to.
std::string pipelineBody(const Scene& scene, const AmberVertices& vertices) {
  const Viewport& v = scene.viewport;
  std::string text = fmt::format("  VIEWPORT {} {} SIZE {} {} MIN_DEPTH {} MAX_DEPTH {}\n", amberFloat(v.x), amberFloat(v.y), amberFloat(v.width), amberFloat(v.height),
                                 amberFloat(v.minDepth), amberFloat(v.maxDepth));
  if (scene.state.polygonMode == PolygonMode::LINE) text += "  POLYGON_MODE line\n";
  if (scene.state.polygonMode == PolygonMode::POINT) text += "  POLYGON_MODE point\n";
  if (scene.target.depthFormat) text += "  BIND BUFFER depth AS depth_stencil\n";
  if (scene.target.depthFormat || scene.state.depthClampEnable) text += depthState(scene.state);
  return text + vertices.bindings;
}

std::string run(const Scene& scene, std::string_view pipeline, const AmberVertices& vertices) {
  std::string text;
  if (scene.target.depthFormat) text += fmt::format("CLEAR_DEPTH {} {}\n", pipeline, amberFloat(scene.target.depthClearValue));
  return text + fmt::format("CLEAR {0}\nRUN {0} DRAW_ARRAY AS {1} START_IDX 0 COUNT {2}\n\n", pipeline, vertices.topology, vertices.count);
}

/// The size comes first: resolve targets that are bound before it keep the default one.
std::string pipeline(std::string_view name, const Target& target, const std::string& outputs, const std::string& body) {
  return fmt::format("PIPELINE graphics {0}_pipeline\n  ATTACH vertices\n  ATTACH {0}_shader\n  FRAMEBUFFER_SIZE {1} {2}\n{3}{4}END\n\n", name,
                     target.width, target.height, outputs, body);
}

std::string drawPixels(const Scene& scene, const AmberVertices& vertices) {
  const std::string body = pipelineBody(scene, vertices);
  std::string shaders = shader("fragment", "drawn_shader", amberPrimitiveShader()), buffers = "BUFFER drawn FORMAT R32_UINT\n";
  std::string pipelines = pipeline("drawn", scene.target, "  BIND BUFFER drawn AS color LOCATION 0\n", body);
  std::string runs = run(scene, "drawn_pipeline", vertices);
  for (size_t v = 0; v < scene.draws[0].varyings.size(); ++v) {
    const std::string name = fmt::format("drawn{}", v);
    shaders += shader("fragment", name + "_shader", amberVaryingShader(scene.draws[0].varyings[v], v));
    buffers += fmt::format("BUFFER {} FORMAT R32G32B32A32_SFLOAT\n", name);
    pipelines += pipeline(name, scene.target, fmt::format("  BIND BUFFER {} AS color LOCATION 0\n", name), body);
    runs += run(scene, name + "_pipeline", vertices);
  }
  if (scene.target.depthFormat) buffers += fmt::format("BUFFER depth FORMAT {}\n", enumName(*scene.target.depthFormat));
  return shaders + buffers + "\n" + vertices.buffers + pipelines + runs;
}

std::string drawMasks(const Scene& scene, const AmberVertices& vertices) {
  const Target& target = scene.target;
  const uint64_t words = uint64_t{target.width} * target.height * primitiveCount(scene);
  const std::string image = fmt::format("FORMAT R8G8B8A8_UNORM DIM_2D WIDTH {} HEIGHT {}", target.width, target.height);
  Scene colourOnly = scene;
  colourOnly.target.depthFormat.reset();
  return shader("fragment", "masks_shader", amberMaskShader(target)) +
         fmt::format("IMAGE colour {0} SAMPLES {1}\nIMAGE resolved {0}\nBUFFER masks DATA_TYPE uint32 SIZE {2} FILL 0\n\n", image, target.samples, words) +
         vertices.buffers +
         pipeline("masks", target, "  BIND BUFFER colour AS color LOCATION 0\n  BIND BUFFER resolved AS resolve\n  BIND BUFFER masks AS storage DESCRIPTOR_SET 0 BINDING 0\n",
                  pipelineBody(colourOnly, vertices)) +
         run(colourOnly, "masks_pipeline", vertices);
}

std::string head(const Scene& scene, const AmberExpectations& expected, std::string_view origin, std::string_view rules) {
  std::string text = fmt::format("#!amber\n# {}\n# Made by: {}\n# Expected under: {}\n# {} demanded, {} left open by the rules", oneLine(scene.name), oneLine(origin),
                                 oneLine(rules), counted(expected.expected, "sample"), grouped(expected.free));
  text += expected.values > 0 ? fmt::format("; {} in an interval.\n", counted(expected.values, "value")) : ".\n";
  if (scene.target.samples > 1) {
    text += "# masks[(primitive - 1) * width * height + y * width + x]: the samples that a primitive covers. Values are not compared.\n";
  } else {
    text += "# drawn: the last primitive of each pixel, from 1; drawnN: varying N. Depths, and how often a pixel is drawn, are not compared.\n";
  }
  if (!isList(scene.state.topology) || scene.draws.size() > 1) text += "# Strips, fans and several draws are one list here.\n";
  return text + "# Only what Amber can say is here: one draw of a list, default lines, no culling, whole scissor, all samples.\n\n";
}

}  // namespace

Result<AmberScript> amberScript(const Scene& scene, const rasterizer::Rules& rules, std::string_view origin) {
  if (Result<void> valid = validate(scene); !valid) return tl::unexpected(valid.error());
  if (Result<void> sayable = sayableInAmber(scene); !sayable) return tl::unexpected(sayable.error());
  const bool masks = scene.target.samples > 1;
  const AmberVertices vertices = amberVertices(scene);
  if (vertices.count == 0) return tl::unexpected(Error{ErrorCode::BadInput, "draws", "nothing is drawn", ""});
  const Result<AmberExpectations> expected = masks ? expectedMasks(scene, rules) : expectedPixels(scene, rules);
  if (!expected) return tl::unexpected(expected.error());
  AmberScript script;
  script.expected = expected->expected;
  script.free = expected->free;
  script.values = expected->values;
  const std::string rulesText = rules.open ? "the Vulkan specification" : "the profile " + rules.name;
  script.text = head(scene, *expected, origin, rulesText) + features(scene) + shader("vertex", "vertices", amberVertexShader(scene)) +
                (masks ? drawMasks(scene, vertices) : drawPixels(scene, vertices)) + expected->commands;
  return script;
}

}  // namespace rasterdiff::harness
