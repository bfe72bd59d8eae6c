// Compares state and shader inputs with features and extensions; only what a scene really uses has to be offered.
#include "vkref/offered_state.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "scene/primitive_class.hpp"

namespace rasterdiff::vkref {
namespace {

/// A feature that a scene uses, and the field that uses it.
struct Need {
  bool used = false;
  VkBool32 offered = VK_FALSE;
  const char* where = "";
  const char* what = "";
};

Result<void> checkNeeds(std::initializer_list<Need> needs) {
  for (const Need& need : needs) {
    if (need.used && !need.offered) return notOffered(need.where, need.what);
  }
  return {};
}

Result<void> checkLines(const State& state, const Capabilities& caps) {
  if (!drawsLines(state)) return {};
  using enum LineRasterizationMode;
  const VkPhysicalDeviceLineRasterizationFeaturesEXT& lines = caps.features.lines;
  const LineRasterizationMode mode = state.lineRasterizationMode;
  const char* const kMode = "state.lineRasterizationMode";
  const char* const kStipple = "state.stippledLineEnable";
  return checkNeeds({
      {state.lineWidth != 1, caps.core().wideLines, "state.lineWidth", "other widths than 1 need wideLines"},
      {mode == RECTANGULAR, lines.rectangularLines, kMode, "needs rectangularLines of VK_EXT_line_rasterization"},
      {mode == BRESENHAM, lines.bresenhamLines, kMode, "needs bresenhamLines of VK_EXT_line_rasterization"},
      {mode == RECTANGULAR_SMOOTH, lines.smoothLines, kMode, "needs smoothLines of VK_EXT_line_rasterization"},
      // [vk:VkPipelineRasterizationLineStateCreateInfo] the default mode is rectangular where lines are strict
      {state.stippledLineEnable && mode == DEFAULT, lines.stippledRectangularLines && caps.limits.strictLines,
       kStipple, "needs stippledRectangularLines of VK_EXT_line_rasterization, and strictLines"},
      {state.stippledLineEnable && mode == RECTANGULAR, lines.stippledRectangularLines, kStipple,
       "needs stippledRectangularLines of VK_EXT_line_rasterization"},
      {state.stippledLineEnable && mode == BRESENHAM, lines.stippledBresenhamLines, kStipple,
       "needs stippledBresenhamLines of VK_EXT_line_rasterization"},
      {state.stippledLineEnable && mode == RECTANGULAR_SMOOTH, lines.stippledSmoothLines, kStipple,
       "needs stippledSmoothLines of VK_EXT_line_rasterization"},
  });
}

Result<void> checkPoints(const Scene& scene, const Capabilities& caps) {
  if (!drawsPoints(scene.state) || caps.core().largePoints) return {};
  for (size_t i = 0; i < scene.draws.size(); ++i) {
    const std::vector<float>& sizes = scene.draws[i].pointSizes;
    const bool ones = std::all_of(sizes.begin(), sizes.end(), [](float size) { return size == 1; });
    if (!ones) return notOffered(fmt::format("draws[{}].pointSizes", i), "other sizes than 1 need largePoints");
    if (sizes.empty() && scene.state.pointSize != 1) {
      return notOffered("state.pointSize", "other sizes than 1 need largePoints");
    }
  }
  return {};
}

/// A restart index in a list needs a feature; an enabled restart that no index asks for does not.
Result<void> checkRestart(const Scene& scene, const Capabilities& caps) {
  const bool restarts = scene.state.primitiveRestartEnable && isList(scene.state.topology);
  if (!restarts || caps.features.listRestart.primitiveTopologyListRestart) return {};
  for (size_t i = 0; i < scene.draws.size(); ++i) {
    const auto& indices = scene.draws[i].indices;
    if (indices && std::find(indices->begin(), indices->end(), kRestartIndex) != indices->end()) {
      return notOffered(fmt::format("draws[{}].indices", i),
                        "a restart in a list needs VK_EXT_primitive_topology_list_restart");
    }
  }
  return {};
}

/// [vk:VkGraphicsPipelineCreateInfo] lines that do not cover samples one by one exclude what works sample by sample.
Result<void> checkLineSamples(const Scene& scene, const RenderPlan& plan) {
  const State& state = scene.state;
  const bool whole = state.lineRasterizationMode == LineRasterizationMode::BRESENHAM ||
                     state.lineRasterizationMode == LineRasterizationMode::RECTANGULAR_SMOOTH;
  const bool samples = state.alphaToCoverageEnable || state.sampleShadingEnable || plan.sampleShading;
  if (!drawsLines(state) || !whole || !samples) return {};
  return notOffered("state.lineRasterizationMode",
                    "BRESENHAM and RECTANGULAR_SMOOTH lines exclude alpha to coverage and sample shading in Vulkan");
}

Result<void> checkInterpolations(const Scene& scene, const Capabilities& caps) {
  const std::vector<Varying>& varyings = scene.draws.front().varyings;
  const Limits& limits = caps.limits;
  for (size_t i = 0; i < varyings.size(); ++i) {
    const Varying& varying = varyings[i];
    const std::string where = fmt::format("draws[0].varyings[{}]", i);
    const bool offset = varying.interpolation == Interpolation::offset;
    if ((offset || varying.interpolation == Interpolation::sample) && !caps.core().sampleRateShading) {
      return notOffered(where + ".interpolation", "needs sampleRateShading");
    }
    const auto inside = [&](float value) {
      return value >= limits.minInterpolationOffset && value <= limits.maxInterpolationOffset;
    };
    if (offset && !(inside(varying.offsetX) && inside(varying.offsetY))) {
      return notOffered(where + ".offset",
                        fmt::format("({}, {}) leaves minInterpolationOffset .. maxInterpolationOffset, {} .. {}",
                                    varying.offsetX, varying.offsetY, limits.minInterpolationOffset,
                                    limits.maxInterpolationOffset));
    }
  }
  return {};
}

}  // namespace

tl::unexpected<Error> notOffered(std::string where, std::string what) {
  return fail(ErrorCode::NotOffered, std::move(where), std::move(what), "`rasterdiff devices` shows the limits");
}

Result<void> checkState(const Scene& scene, const Capabilities& caps) {
  const State& state = scene.state;
  const bool depthClip = state.depthClipEnable.value_or(!state.depthClampEnable);
  const Result<void> needs = checkNeeds({
      {state.provokingVertexMode == ProvokingVertexMode::LAST_VERTEX, caps.limits.provokingVertexLast,
       "state.provokingVertexMode", "LAST_VERTEX needs VK_EXT_provoking_vertex"},
      {state.negativeOneToOne, caps.limits.depthClipControl, "state.negativeOneToOne",
       "needs VK_EXT_depth_clip_control"},
      {polygonModeOf(state) != PolygonMode::FILL, caps.core().fillModeNonSolid, "state.polygonMode",
       "needs fillModeNonSolid"},
      {state.depthClampEnable, caps.core().depthClamp, "state.depthClampEnable", "needs depthClamp"},
      {depthClip == state.depthClampEnable, caps.features.depthClipEnable.depthClipEnable, "state.depthClipEnable",
       "needs VK_EXT_depth_clip_enable where it is not the opposite of depthClampEnable"},
      {state.depthBiasEnable && state.depthBiasClamp != 0, caps.core().depthBiasClamp, "state.depthBiasClamp",
       "needs depthBiasClamp"},
      {state.sampleShadingEnable, caps.core().sampleRateShading, "state.sampleShadingEnable",
       "needs sampleRateShading"},
  });
  if (!needs) return needs;
  if (const Result<void> lines = checkLines(state, caps); !lines) return lines;
  if (const Result<void> points = checkPoints(scene, caps); !points) return points;
  return checkRestart(scene, caps);
}

Result<void> checkShaders(const Scene& scene, const RenderPlan& plan, const Capabilities& caps) {
  const Draw& draw = scene.draws.front();
  const Result<void> needs = checkNeeds({
      {draw.clipDistanceCount > 0, caps.core().shaderClipDistance, "draws[0].clipDistances",
       "needs shaderClipDistance"},
      {draw.cullDistanceCount > 0, caps.core().shaderCullDistance, "draws[0].cullDistances",
       "needs shaderCullDistance"},
      {draw.clipDistanceCount > 0, draw.clipDistanceCount <= caps.vk.maxClipDistances, "draws[0].clipDistances",
       "more than maxClipDistances"},
      {draw.cullDistanceCount > 0, draw.cullDistanceCount <= caps.vk.maxCullDistances, "draws[0].cullDistances",
       "more than maxCullDistances"},
      {draw.clipDistanceCount > 0 && draw.cullDistanceCount > 0,
       draw.clipDistanceCount + draw.cullDistanceCount <= caps.vk.maxCombinedClipAndCullDistances,
       "draws[0].cullDistances", "together with clipDistances more than maxCombinedClipAndCullDistances"},
      {plan.sampleShading, caps.core().sampleRateShading, "builtIns", "SampleId and SamplePosition need sampleRateShading"},
  });
  if (!needs) return needs;
  if (const Result<void> lines = checkLineSamples(scene, plan); !lines) return lines;
  return checkInterpolations(scene, caps);
}

}  // namespace rasterdiff::vkref
