#include "rasterizer/fragment/value_freedoms.hpp"

#include <algorithm>

#include "rasterizer/fragment/sample_shading.hpp"
#include "rasterizer/lines/smooth_line.hpp"
#include "rasterizer/points/square_point.hpp"

namespace rasterdiff::rasterizer {
namespace {

Freedom ofDepth(const State& state) {
  if (state.depthBiasEnable) return Freedom::DepthBias;
  const bool clips = state.depthClipEnable.value_or(!state.depthClampEnable);
  return !clips && !state.depthClampEnable ? Freedom::UndefinedDepth : Freedom::None;
}

bool linesMayFollowTheMajorAxis(const State& state, const Limits& limits) {
  const bool lines = state.topology == PrimitiveTopology::LINE_LIST || state.topology == PrimitiveTopology::LINE_STRIP ||
                     state.polygonMode == PolygonMode::LINE;
  if (state.lineRasterizationMode == LineRasterizationMode::BRESENHAM) return lines && state.lineWidth >= 1.5F;
  return lines && state.lineRasterizationMode == LineRasterizationMode::DEFAULT && !limits.strictLines;
}

Freedom ofVarying(Interpolation interpolation, bool multisampled, bool byMajorAxis, bool smoothLine) {
  if (smoothLine) return Freedom::SmoothLine;
  switch (interpolation) {
    case Interpolation::smooth:
    case Interpolation::noperspective:
      if (multisampled) return Freedom::AttributePosition;
      break;
    case Interpolation::centroid:
      if (multisampled) return Freedom::CentroidPosition;
      break;
    case Interpolation::offset: return Freedom::OffsetRounding;
    case Interpolation::sample: break;
    case Interpolation::flat: return Freedom::None;
  }
  return byMajorAxis ? Freedom::LineInterpolation : Freedom::None;
}

bool somePointSizeIsFree(const Scene& scene, const Limits& limits) {
  const auto isFree = [&](float size) { return pointSize(size, limits).isFree(); };
  return std::ranges::any_of(scene.draws, [&](const Draw& draw) {
    return draw.pointSizes.empty() ? isFree(scene.state.pointSize) : std::ranges::any_of(draw.pointSizes, isFree);
  });
}

Freedom ofPointCoord(const Scene& scene, const Limits& limits) {
  if (scene.target.samples > 1) return Freedom::AttributePosition;
  return somePointSizeIsFree(scene, limits) ? Freedom::PointSizeStep : Freedom::None;
}

Freedom ofBuiltIn(BuiltIn builtIn, const Scene& scene, const Limits& limits, const SampleShading& shading) {
  switch (builtIn) {
    case BuiltIn::FragCoord:
      if (!shading.certain) return Freedom::SampleShadingRate;
      return scene.target.samples > 1 ? Freedom::AttributePosition : Freedom::None;
    case BuiltIn::PointCoord: return ofPointCoord(scene, limits);
    case BuiltIn::FrontFacing: return Freedom::NearZeroArea;
    case BuiltIn::SampleMask: return shading.certain ? Freedom::SnapRounding : Freedom::SampleShadingRate;
    case BuiltIn::SampleId:
    case BuiltIn::SamplePosition: return Freedom::None;
  }
  return Freedom::None;
}

}  // namespace

std::vector<Freedom> valueFreedoms(const Scene& scene, const Rules& rules) {
  const bool multisampled = scene.target.samples > 1;
  const auto ifOpen = [&rules](Freedom freedom) { return rules.openValues() ? freedom : Freedom::None; };
  std::vector<Freedom> freedoms;
  if (scene.target.depthFormat) freedoms.push_back(ifOpen(ofDepth(scene.state)));
  const size_t varyings = scene.draws.empty() ? 0 : scene.draws[0].varyings.size();
  const bool byMajorAxis = linesMayFollowTheMajorAxis(scene.state, rules.limits);
  const bool smoothLine = drawsSmoothLines(scene.state);
  for (size_t v = 0; v < varyings; ++v) {
    freedoms.push_back(ifOpen(ofVarying(scene.draws[0].varyings[v].interpolation, multisampled, byMajorAxis, smoothLine)));
  }
  const SampleShading shading = sampleShading(scene);
  for (const BuiltIn builtIn : scene.builtIns) freedoms.push_back(ifOpen(ofBuiltIn(builtIn, scene, rules.limits, shading)));
  for (size_t v = 0; scene.target.resolve && v < varyings; ++v) freedoms.push_back(Freedom::ResolveRounding);
  if (scene.target.depthResolveMode) {
    freedoms.push_back(scene.target.depthResolveMode == ResolveMode::AVERAGE ? Freedom::ResolveRounding : Freedom::None);
  }
  return freedoms;
}

}  // namespace rasterdiff::rasterizer
