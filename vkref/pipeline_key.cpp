// Reduces a scene's state to what a pipeline cannot leave open, so that scenes which differ in nothing else share one.
#include "vkref/pipeline_key.hpp"

namespace rasterdiff::vkref {
namespace {

VertexExtras extrasOf(const Scene& scene, const RenderPlan& plan) {
  const Draw& draw = scene.draws.front();
  return {drawsPoints(scene.state), draw.clipDistanceCount > 0, draw.cullDistanceCount > 0, plan.viewportIndex};
}

}  // namespace

PipelineKey pipelineKey(const Scene& scene, const RenderPlan& plan, const PassPlan& pass, PrimitiveSource primitives) {
  const State& state = scene.state;
  const Draw& draw = scene.draws.front();
  PipelineKey key;
  key.samples = plan.samples;
  key.depth = plan.depth;
  key.negativeOneToOne = state.negativeOneToOne;
  key.provokingVertexMode = state.provokingVertexMode;
  key.primitives = pass.primitives ? primitives : PrimitiveSource::None;
  key.varyings = static_cast<uint32_t>(pass.varyings.size());
  for (uint32_t i = 0; i < key.varyings; ++i) {
    const Varying& varying = draw.varyings[pass.varyings[i]];
    key.interpolations[i].mode = varying.interpolation;
    if (varying.interpolation == Interpolation::offset) {
      key.interpolations[i].offsetX = varying.offsetX;
      key.interpolations[i].offsetY = varying.offsetY;
    }
    key.components[i] = varying.components;
  }

  key.topology = topologyClassOf(state.topology);
  key.polygonMode = polygonModeOf(state);
  key.depthClamp = state.depthClampEnable;
  key.depthClip = state.depthClipEnable.value_or(!state.depthClampEnable);
  key.depthClipStated = key.depthClip == state.depthClampEnable;
  if (drawsLines(state)) {
    key.lineMode = state.lineRasterizationMode;
    key.stippled = state.stippledLineEnable;
  }
  const uint32_t all = plan.samples >= 32 ? ~0U : (1U << plan.samples) - 1;
  key.sampleMask = ~state.sampleMask & all;
  key.sampleShading = state.sampleShadingEnable || plan.sampleShading;
  if (key.sampleShading) key.minSampleShading = plan.sampleShading ? 1 : state.minSampleShading;
  key.alphaToCoverage = state.alphaToCoverageEnable;
  key.alphaFirst = plan.alphaFirst;
  key.shaderSampleMask = state.shaderSampleMask;
  if (const auto& custom = scene.target.sampleLocations) {
    for (const SampleLocationEXT& location : custom->sampleLocations) key.sampleLocations.push_back({location.x, location.y});
    key.sampleLocationGridWidth = custom->gridWidth;
    key.sampleLocationGridHeight = custom->gridHeight;
  }
  key.extras = extrasOf(scene, plan);
  key.clipDistances = draw.clipDistanceCount;
  key.cullDistances = draw.cullDistanceCount;
  if (plan.viewportIndex) key.viewports = 1 + static_cast<uint32_t>(scene.furtherViewports.size());
  key.observes = pass.builtIn.has_value();
  key.builtIn = pass.builtIn.value_or(BuiltIn{});
  return key;
}

}  // namespace rasterdiff::vkref
