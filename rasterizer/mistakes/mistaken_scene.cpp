#include "rasterizer/mistakes/mistaken_scene.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <tuple>

namespace rasterdiff::rasterizer {
namespace {

using enum DeliberateError;

void eachViewport(Scene& scene, const std::function<void(Viewport&)>& change) {
  change(scene.viewport);
  for (ViewportAndScissor& further : scene.furtherViewports) change(further.viewport);
}

void eachScissor(Scene& scene, const std::function<void(Rect2D&)>& change) {
  if (scene.scissor) change(*scene.scissor);
  for (ViewportAndScissor& further : scene.furtherViewports) {
    if (further.scissor) change(*further.scissor);
  }
}

void eachPointSize(Scene& scene, const std::function<float(float)>& changed) {
  scene.state.pointSize = changed(scene.state.pointSize);
  for (Draw& draw : scene.draws) {
    for (float& size : draw.pointSizes) size = changed(size);
  }
}

void eachVarying(Scene& scene, const std::function<void(Varying&)>& change) {
  for (Draw& draw : scene.draws) {
    for (Varying& varying : draw.varyings) change(varying);
  }
}

void keepFirstClipDistance(Draw& draw) {
  if (draw.clipDistanceCount < 2) return;
  for (size_t v = 0; v < draw.positions.size(); ++v) draw.clipDistances[v] = draw.clipDistances[v * draw.clipDistanceCount];
  draw.clipDistances.resize(draw.positions.size());
  draw.clipDistanceCount = 1;
}

CompareOp withEqualExchanged(CompareOp op) {
  switch (op) {
    case CompareOp::LESS: return CompareOp::LESS_OR_EQUAL;
    case CompareOp::LESS_OR_EQUAL: return CompareOp::LESS;
    case CompareOp::GREATER: return CompareOp::GREATER_OR_EQUAL;
    case CompareOp::GREATER_OR_EQUAL: return CompareOp::GREATER;
    default: return op;
  }
}

uint16_t reversed(uint16_t pattern) {
  unsigned result = 0;
  for (unsigned bit = 0; bit < 16; ++bit) result |= ((pattern >> bit) & 1U) << (15 - bit);
  return static_cast<uint16_t>(result);
}

/// The nearest number of 11 significant bits.
float halfPrecision(float value) {
  int exponent = 0;
  const float fraction = std::frexp(value, &exponent);  // 0.5 <= |fraction| < 1
  return std::ldexp(std::nearbyint(std::ldexp(fraction, 11)), exponent - 11);
}

void moveSixteenth(Viewport& viewport) { viewport.x += 0.0625F; }

bool mistakeViewport(Scene& scene, DeliberateError error) {
  switch (error) {
    case ViewportFractionDropped:
      eachViewport(scene, [](Viewport& v) { v.x = std::floor(v.x), v.y = std::floor(v.y); });
      return true;
    case ViewportHalfDropped:
      eachViewport(scene, [](Viewport& v) { v.x -= std::fmod(v.width, 2.0F) == 1 ? 0.5F : 0; });
      return true;
    case DepthRangeSorted:
      eachViewport(scene, [](Viewport& v) { std::tie(v.minDepth, v.maxDepth) = std::minmax({v.minDepth, v.maxDepth}); });
      return true;
    case DepthRangeIgnored:
      eachViewport(scene, [](Viewport& v) { v.minDepth = 0, v.maxDepth = 1; });
      return true;
    case MovedByDepthTest:
      if (scene.state.depthTestEnable) eachViewport(scene, moveSixteenth);
      return true;
    case MovedByScissor:
      if (scene.scissor) eachViewport(scene, moveSixteenth);
      return true;
    case ScissorLeft:
      eachScissor(scene, [](Rect2D& r) { --r.x, ++r.width; });
      return true;
    case ScissorShort:
      eachScissor(scene, [](Rect2D& r) { r.height -= r.height > 0 ? 1 : 0; });
      return true;
    case ScissorOfViewportZero:
      for (ViewportAndScissor& further : scene.furtherViewports) further.scissor = scene.scissor;
      return true;
    default: return false;
  }
}

bool mistakeState(State& state, DeliberateError error) {
  switch (error) {
    case DepthClipStateIgnored: state.depthClipEnable.reset(); return true;
    case CullBothAsBack:
      if (state.cullMode == CullMode::FRONT_AND_BACK) state.cullMode = CullMode::BACK;
      return true;
    case OutlineNotCulled:
      if (state.polygonMode != PolygonMode::FILL) state.cullMode = CullMode::NONE;
      return true;
    case PointModeEdges:
      if (state.polygonMode == PolygonMode::POINT) state.polygonMode = PolygonMode::LINE;
      return true;
    case DefaultPointSizeTwo:
      if (state.pointSize == 1) state.pointSize = 2;
      return true;
    case LineWidthWhole: state.lineWidth = std::max(1.0F, std::nearbyint(state.lineWidth)); return true;
    case StippleMsbFirst: state.lineStipplePattern = reversed(state.lineStipplePattern); return true;
    case StippleFactorIgnored: state.lineStippleFactor = 1; return true;
    case DepthBiasClampSign: state.depthBiasClamp = std::fabs(state.depthBiasClamp); return true;
    case CompareEqualExchanged: state.depthCompareOp = withEqualExchanged(state.depthCompareOp); return true;
    case DepthWriteWithoutTest:
      if (!state.depthTestEnable) state.depthCompareOp = CompareOp::ALWAYS;
      state.depthTestEnable = true;
      return true;
    case SampleShadingIgnored: state.sampleShadingEnable = false; return true;
    case AlphaToCoverageIgnored: state.alphaToCoverageEnable = false; return true;
    default: return false;
  }
}

bool mistakeDraws(Scene& scene, DeliberateError error) {
  switch (error) {
    case ShaderMaskOfFirstDraw:
      for (Draw& draw : scene.draws) draw.shaderSampleMaskBits = scene.draws.front().shaderSampleMaskBits;
      return true;
    case ClipDistanceFirstOnly:
      for (Draw& draw : scene.draws) keepFirstClipDistance(draw);
      return true;
    case CullDistanceZero:
      for (Draw& draw : scene.draws) {
        for (float& d : draw.cullDistances) d = d == 0 ? -std::numeric_limits<float>::min() : d;
      }
      return true;
    case PointSizeDoubled:
      eachPointSize(scene, [](float size) { return 2 * size; });
      return true;
    case PointSizeWhole:
      eachPointSize(scene, [](float size) { return std::max(1.0F, std::nearbyint(size)); });
      return true;
    case VaryingHalfPrecision:
      eachVarying(scene, [](Varying& varying) {
        if (varying.interpolation != Interpolation::flat) std::ranges::transform(varying.values, varying.values.begin(), halfPrecision);
      });
      return true;
    case OffsetIgnored:
      eachVarying(scene, [](Varying& varying) { varying.offsetX = varying.offsetY = 0; });
      return true;
    case OffsetCoarse:
      eachVarying(scene, [](Varying& varying) {
        varying.offsetX = std::nearbyint(varying.offsetX * 4) / 4;
        varying.offsetY = std::nearbyint(varying.offsetY * 4) / 4;
      });
      return true;
    default: return false;
  }
}

}  // namespace

std::optional<Scene> mistakenScene(const Scene& scene, DeliberateError error) {
  if (error == None) return std::nullopt;
  Scene mistaken = scene;
  if (mistakeViewport(mistaken, error) || mistakeState(mistaken.state, error) || mistakeDraws(mistaken, error)) return mistaken;
  return std::nullopt;
}

}  // namespace rasterdiff::rasterizer
