// Pipeline state: facing, polygon mode, depth, lines, points, samples.
#include <algorithm>
#include <array>

#include "harness/hunt/ingredients.hpp"

namespace rasterdiff::harness::hunt {
namespace {

void culling(Kitchen& k) {
  k.scene.state.cullMode = static_cast<CullMode>(k.random.below(k.random.chance(10) ? 4 : 3));
  k.scene.state.frontFace = static_cast<FrontFace>(k.random.below(2));
}

void polygonMode(Kitchen& k) { k.scene.state.polygonMode = static_cast<PolygonMode>(k.random.below(3)); }

void provoking(Kitchen& k) {
  if (k.limits.provokingVertexLast) k.scene.state.provokingVertexMode = static_cast<ProvokingVertexMode>(k.random.below(2));
}

void depth(Kitchen& k) {
  using enum DepthFormat;
  State& state = k.scene.state;
  k.scene.target.depthFormat = oneOf(k.random, {D32_SFLOAT, D32_SFLOAT, D32_SFLOAT, D16_UNORM, D16_UNORM, X8_D24_UNORM_PACK32,
                                                D24_UNORM_S8_UINT, D32_SFLOAT_S8_UINT});
  k.scene.target.depthClearValue = oneOf(k.random, {1.0F, 1.0F, 1.0F, 0.0F, 0.5F});
  state.depthTestEnable = k.random.chance(80);
  state.depthWriteEnable = k.random.chance(80);
  state.depthCompareOp = static_cast<CompareOp>(k.random.below(8));
  if (k.random.chance(50)) state.depthCompareOp = CompareOp::LESS;
}

void depthBias(Kitchen& k) {
  if (!k.scene.target.depthFormat) depth(k);
  State& state = k.scene.state;
  state.depthBiasEnable = k.random.chance(85);
  state.depthBiasConstantFactor = oneOf(k.random, {0.0F, 1.0F, -1.0F, 2.0F, 1000.0F, -70000.0F});
  state.depthBiasSlopeFactor = oneOf(k.random, {0.0F, 0.0F, 1.0F, -1.0F, 0.5F, 100.0F});
  state.depthBiasClamp = oneOf(k.random, {0.0F, 0.0F, 0.0F, 0.001F, -0.001F});
}

/// Clamping and clipping of depth, and depths that it matters for.
void depthClip(Kitchen& k) {
  if (!k.scene.target.depthFormat && k.random.chance(60)) depth(k);
  if (k.random.chance(40)) {
    k.scene.viewport.minDepth = oneOf(k.random, {0.25F, 0.75F});
    k.scene.viewport.maxDepth = 1 - k.scene.viewport.minDepth;
  }
  const bool outside = k.random.chance(70);
  for (Draw& draw : k.scene.draws) {
    for (ClipPosition& p : draw.positions) {
      if (outside && k.random.chance(40)) p.z = oneOf(k.random, {-0.5F, -0.0625F, 1.25F, 1.0625F, 3.0F}) * p.w;
    }
  }
  k.scene.state.depthClampEnable = k.random.chance(50);
  k.scene.state.depthClipEnable.reset();
  if (k.random.chance(50)) k.scene.state.depthClipEnable = k.random.chance(50);
}

void clipControl(Kitchen& k) { k.scene.state.negativeOneToOne = k.limits.depthClipControl && k.random.chance(70); }

void lines(Kitchen& k) {
  using enum LineRasterizationMode;
  State& state = k.scene.state;
  const LineRasterizationMode mode = oneOf(k.random, {DEFAULT, RECTANGULAR, RECTANGULAR, BRESENHAM, BRESENHAM, RECTANGULAR_SMOOTH, RECTANGULAR_SMOOTH});
  const bool offered = mode == DEFAULT || (mode == RECTANGULAR  ? k.limits.rectangularLines
                                           : mode == BRESENHAM ? k.limits.bresenhamLines
                                                               : k.limits.smoothLines);
  state.lineRasterizationMode = offered ? mode : DEFAULT;
  state.lineWidth = oneOf(k.random, {1.0F, 1.0F, 1.0F, 2.0F, 3.0F, 1.5F, 5.25F, 17.0F});
  if (state.lineWidth > k.limits.lineWidthMax) state.lineWidth = 1;
}

void stipple(Kitchen& k) {
  State& state = k.scene.state;
  if (state.lineRasterizationMode == LineRasterizationMode::RECTANGULAR_SMOOTH) return;  // a feature of its own
  const bool offered = state.lineRasterizationMode == LineRasterizationMode::BRESENHAM ? k.limits.stippledBresenhamLines
                                                                                       : k.limits.stippledRectangularLines;
  state.stippledLineEnable = offered && k.random.chance(85);
  state.lineStippleFactor = oneOf(k.random, {1U, 1U, 1U, 2U, 3U, 7U});
  state.lineStipplePattern = oneOf<uint16_t>(k.random, {0xAAAA, 0x0F0F, 0x00FF, 0x8001, 0x7FFE, 0x1C47});
}

void pointSize(Kitchen& k) {
  const auto size = [&] {
    const float s = oneOf(k.random, {1.0F, 1.0F, 0.5F, 0.125F, 2.0F, 3.0F, 1.5F, 2.625F, 4.5F, 8.0F, 15.375F, 1.0625F});
    return s > k.limits.pointSizeMax ? 1.0F : s;
  };
  k.scene.state.pointSize = size();
  const bool own = k.random.chance(35);
  for (Draw& draw : k.scene.draws) {
    draw.pointSizes.clear();
    for (size_t v = 0; own && v < draw.positions.size(); ++v) draw.pointSizes.push_back(size());
  }
}

void samples(Kitchen& k) {
  uint32_t wanted = oneOf(k.random, {1U, 4U, 4U, 4U, 2U, 8U, 16U});
  if ((k.limits.framebufferSampleCounts & wanted) == 0) wanted = k.random.chance(70) ? 4 : 1;
  k.scene.target.samples = wanted;
}

/// A table of sixteenths for each pixel of a small grid, some of them beyond the range.
void sampleLocations(Kitchen& k) {
  Target& target = k.scene.target;
  target.sampleLocations.reset();
  if (target.samples == 1) samples(k);
  if (target.samples == 1 || (k.limits.sampleLocationSampleCounts & target.samples) == 0) return;
  SampleLocationsInfo info;
  info.gridWidth = std::min(oneOf(k.random, {1U, 1U, 2U, 4U}), k.limits.maxSampleLocationGridWidth);
  info.gridHeight = std::min(oneOf(k.random, {1U, 1U, 2U, 4U}), k.limits.maxSampleLocationGridHeight);
  const auto coordinate = [&] { return k.random.chance(10) ? oneOf(k.random, {-0.25F, 1.0F, 1.5F}) : static_cast<float>(k.random.below(16)) / 16; };
  const uint32_t count = target.samples * info.gridWidth * info.gridHeight;
  for (uint32_t i = 0; i < count; ++i) {
    const float x = coordinate(), y = coordinate();
    info.sampleLocations.push_back({x, y});
  }
  target.sampleLocations = std::move(info);
}

void sampleMask(Kitchen& k) {
  k.scene.state.sampleMask = k.random.chance(70) ? k.random.below(1U << k.scene.target.samples) : ~uint32_t{0};
}

/// Each draw with its own bits, all of them more often than by chance.
void shaderMask(Kitchen& k) {
  k.scene.state.shaderSampleMask = static_cast<ShaderSampleMask>(k.random.below(3));
  for (Draw& draw : k.scene.draws) {
    draw.shaderSampleMaskBits = k.random.chance(70) ? k.random.below(1U << k.scene.target.samples) : ~uint32_t{0};
  }
}

void sampleShading(Kitchen& k) {
  k.scene.state.sampleShadingEnable = k.random.chance(80);
  k.scene.state.minSampleShading = oneOf(k.random, {0.0F, 0.25F, 0.5F, 1.0F, 1.0F});
}

void alpha(Kitchen& k) {
  k.scene.state.alphaToCoverageEnable = k.random.chance(80);
  for (Draw& draw : k.scene.draws) {
    if (draw.varyings.empty() || draw.varyings.front().components != 4) return;
    std::vector<float>& values = draw.varyings.front().values;
    for (size_t i = 3; i < values.size(); i += 4) values[i] = oneOf(k.random, {0.0F, 1.0F, 1.0F, 0.5F, -1.0F, 2.0F});
  }
}

void resolve(Kitchen& k) { k.scene.target.resolve = k.random.chance(70); }

constexpr std::array kIngredients{
    Ingredient{"culling", culling},         Ingredient{"polygon-mode", polygonMode},
    Ingredient{"provoking", provoking},     Ingredient{"depth", depth},
    Ingredient{"depth-bias", depthBias},    Ingredient{"depth-clip", depthClip},
    Ingredient{"clip-control", clipControl}, Ingredient{"lines", lines},
    Ingredient{"stipple", stipple},         Ingredient{"point-size", pointSize},
    Ingredient{"samples", samples},         Ingredient{"sample-mask", sampleMask},
    Ingredient{"sample-shading", sampleShading}, Ingredient{"alpha", alpha},
    Ingredient{"resolve", resolve},         Ingredient{"sample-locations", sampleLocations},
    Ingredient{"shader-mask", shaderMask},
};

}  // namespace

std::span<const Ingredient> stateIngredients() { return kIngredients; }

}  // namespace rasterdiff::harness::hunt
