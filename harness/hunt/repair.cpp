// What makes a scene of random parts one that can be drawn.
#include <algorithm>

#include "harness/hunt/ingredients.hpp"
#include "scene/primitive_class.hpp"

namespace rasterdiff::harness::hunt {
namespace {

void fillUp(std::vector<float>& values, size_t size, Prng& random) {
  while (values.size() < size) values.push_back(randomValue(random));
  values.resize(size);
}

void repairDraw(Draw& draw, const Scene& scene, Prng& random) {
  const Draw& first = scene.draws.front();
  const size_t vertices = draw.positions.size();
  if (&draw != &first) {
    const std::vector<Varying> own = draw.varyings;
    draw.varyings = first.varyings;
    for (size_t v = 0; v < std::min(own.size(), draw.varyings.size()); ++v) draw.varyings[v].values = own[v].values;
    draw.clipDistanceCount = first.clipDistanceCount;
    draw.cullDistanceCount = first.cullDistanceCount;
  }
  for (Varying& varying : draw.varyings) fillUp(varying.values, vertices * varying.components, random);
  fillUp(draw.clipDistances, vertices * draw.clipDistanceCount, random);
  fillUp(draw.cullDistances, vertices * draw.cullDistanceCount, random);
  if (!draw.pointSizes.empty()) draw.pointSizes.resize(vertices, 1.0F);
  draw.viewportIndex = std::min<uint32_t>(draw.viewportIndex, static_cast<uint32_t>(scene.furtherViewports.size()));
  if (!draw.indices) return;
  std::erase_if(*draw.indices, [&](uint32_t index) {
    return index >= vertices && !(index == kRestartIndex && scene.state.primitiveRestartEnable);
  });
}

}  // namespace

void repair(Scene& scene, Prng& random) {
  using enum PrimitiveTopology;
  State& state = scene.state;
  if (topologyClassOf(state.topology) != TopologyClass::Triangle) state.polygonMode = PolygonMode::FILL;
  if (isList(state.topology)) state.primitiveRestartEnable = false;
  if (!drawsLines(state)) state.stippledLineEnable = false;
  if (!scene.target.depthFormat) {
    state.depthTestEnable = state.depthWriteEnable = state.depthBiasEnable = false;
    scene.target.depthClearValue = 1;
  }
  std::erase_if(scene.draws, [](const Draw& draw) { return draw.positions.empty(); });
  if (scene.draws.empty()) return;
  for (Draw& draw : scene.draws) repairDraw(draw, scene, random);
  const std::vector<Varying>& varyings = scene.draws.front().varyings;
  const bool many = scene.target.samples > 1;
  if (!many || varyings.empty()) scene.target.resolve = false;
  if (!many || varyings.empty() || varyings.front().components != 4) state.alphaToCoverageEnable = false;
  if (const auto& custom = scene.target.sampleLocations) {
    const size_t wanted = size_t{scene.target.samples} * custom->gridWidth * custom->gridHeight;
    if (!many || custom->sampleLocations.size() != wanted) scene.target.sampleLocations.reset();
  }
  const bool points = state.topology == POINT_LIST || state.polygonMode == PolygonMode::POINT;
  if (!points) std::erase(scene.builtIns, BuiltIn::PointCoord);
  const bool lines = drawsLines(state);
  const bool smooth = state.lineRasterizationMode == LineRasterizationMode::RECTANGULAR_SMOOTH;
  if (smooth) state.stippledLineEnable = false;  // a feature of its own
  if (lines && (smooth || state.lineRasterizationMode == LineRasterizationMode::BRESENHAM)) {
    // [vk:VkGraphicsPipelineCreateInfo] such lines exclude what works sample by sample
    state.alphaToCoverageEnable = state.sampleShadingEnable = false;
  }
  const auto atSample = [](const Varying& varying) { return varying.interpolation == Interpolation::sample; };
  if (many && state.shaderSampleMask == ShaderSampleMask::INPUT_SHIFTED && std::ranges::any_of(varyings, atSample)) {
    state.shaderSampleMask = ShaderSampleMask::CONSTANT;  // what each invocation reads would not be stated
  }
  for (Draw& draw : scene.draws) {
    if (state.shaderSampleMask == ShaderSampleMask::NONE) draw.shaderSampleMaskBits = Draw{}.shaderSampleMaskBits;
  }
  const uint32_t bits = (uint32_t{1} << scene.target.samples) - 1;
  if ((state.sampleMask & bits) == bits) state.sampleMask = ~uint32_t{0};
}

}  // namespace rasterdiff::harness::hunt
