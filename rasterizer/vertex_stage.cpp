#include "rasterizer/vertex_stage.hpp"

#include <algorithm>
#include <cmath>

#include "rasterizer/target_area.hpp"

namespace rasterdiff::rasterizer {
namespace {

constexpr double kHalfUlp = 0x1p-24;  // relative rounding error of float32

double farthest(double pixels, const SnapRange& range) {
  const double low = range.lowest / double{kSubpixelOne}, high = range.highest / double{kSubpixelOne};
  return std::max(std::fabs(pixels - low), std::fabs(pixels - high));
}

// A clipper outside the vertex stage maps its vertices without fused operations.
ViewportArithmetic clippedArithmetic(const Choices& choices) {
  const bool ofVertices = choices.clipArithmetic == ClipArithmetic::Float32Weighted &&
                          choices.viewportArithmetic != ViewportArithmetic::Exact;
  return ofVertices ? choices.viewportArithmetic : ViewportArithmetic::Float32;
}

void shiftHalfPixel(RasterVertex& vertex) {
  vertex.snapped.x += kSubpixelOne / 2;
  vertex.position.x += 0.5;
}

// [vk:limits-viewportSubPixelBits] both bounds rounded to `bits`.
Viewport onGrid(Viewport viewport, uint32_t bits) {
  const auto round = [bits](float bound) {
    return std::ldexp(std::nearbyint(std::ldexp(bound, static_cast<int>(bits))), -static_cast<int>(bits));
  };
  const float right = round(viewport.x + viewport.width), bottom = round(viewport.y + viewport.height);
  viewport.x = round(viewport.x);
  viewport.y = round(viewport.y);
  viewport.width = right - viewport.x;
  viewport.height = bottom - viewport.y;
  return viewport;
}

// A deliberate error: w whose reciprocal has 12 bits.
ClipPosition withCoarseReciprocal(ClipPosition p) {
  int exponent = 0;
  const double fraction = std::frexp(1.0 / p.w, &exponent);  // 0.5 <= |fraction| < 1
  p.w = static_cast<float>(1 / std::ldexp(std::trunc(std::ldexp(fraction, 12)), exponent - 12));
  return p;
}

// Deliberate errors of rounding to the grid.
void mistakeSnap(RasterVertex& vertex, const ClipPosition& p, const VertexStage& stage) {
  const int bits = gridBits(stage.rules);
  const auto legal = [&](float coordinate, const ViewportAxis& axis) { return legalSnaps(coordinate, p.w, axis, bits, 0); };
  switch (stage.rules.error) {
    case DeliberateError::CeilingSnap:
      vertex.snapped = {legal(p.x, stage.viewport.x).highest, legal(p.y, stage.viewport.y).highest};
      break;
    case DeliberateError::FloorSnapY: vertex.snapped.y = legal(p.y, stage.viewport.y).lowest; break;
    case DeliberateError::SnapOneStepAside: vertex.snapped.y += 1 << (kSubpixelBits - bits); break;
    default: break;
  }
}

}  // namespace

double depthErrorBound(double scaled, double offset, double result) {
  return kHalfUlp * (3 * std::fabs(scaled) + std::fabs(offset) + std::fabs(result));
}

RasterVertex VertexStage::original(const ClipPosition& given) const {
  const ClipPosition p = rules.error == DeliberateError::ReciprocalCoarse ? withCoarseReciprocal(given) : given;
  RasterVertex vertex;
  const double clip[4] = {p.x, p.y, p.z, p.w};
  vertex.position = toFramebuffer(clip, viewport);
  vertex.reciprocalW = 1.0 / p.w;
  vertex.snapped = {snapUnder(rules, samples, p.x, p.w, viewport.x), snapUnder(rules, samples, p.y, p.w, viewport.y)};
  if (rules.error != DeliberateError::None) mistakeSnap(vertex, p, *this);
  vertex.lowest = vertex.highest = vertex.snapped;
  if (rules.error == DeliberateError::DepthUndivided) vertex.position.z = p.z * viewport.z.scale + viewport.z.offset();
  vertex.depthError = depthErrorBound(p.z * viewport.z.scale / p.w, viewport.z.offset(), vertex.position.z);

  const double errorX = viewportArithmeticBound(p.x, p.w, viewport.x);
  const double errorY = viewportArithmeticBound(p.y, p.w, viewport.y);
  vertex.deviation = std::max(errorX, errorY);
  if (rules.open) {
    const int bits = gridBits(rules);
    const SnapRange x = legalSnaps(p.x, p.w, viewport.x, bits, errorX + viewport.boundsUncertainty);
    const SnapRange y = legalSnaps(p.y, p.w, viewport.y, bits, errorY + viewport.boundsUncertainty);
    vertex.lowest = {x.lowest, y.lowest};
    vertex.highest = {x.highest, y.highest};
    vertex.deviation += std::max(farthest(vertex.position.x, x), farthest(vertex.position.y, y));
  }
  if (rules.error == DeliberateError::HalfPixelShift) shiftHalfPixel(vertex);
  return vertex;
}

RasterVertex VertexStage::clipped(const ClipVertex& clip) const {
  const std::array<double, 4>& p = clip.position;
  if (!clip.made) {
    RasterVertex vertex = original({static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2]),
                                    static_cast<float>(p[3])});
    vertex.smoothWeights = clip.smoothWeights;
    vertex.linearWeights = clip.linearWeights;
    return vertex;
  }
  RasterVertex vertex;
  vertex.made = true;
  vertex.smoothWeights = clip.smoothWeights;
  vertex.linearWeights = clip.linearWeights;
  vertex.position = toFramebuffer(p.data(), viewport);
  vertex.reciprocalW = 1.0 / p[3];

  // Deviation of a float32 clipper, carried through the division: (e_x + |ndc| e_w) / w · scale.
  const auto axisError = [&](size_t i, const ViewportAxis& axis) {
    const double ndc = p[i] / p[3];
    const double carried = (clip.error[i] + std::fabs(ndc) * clip.error[3]) / std::fabs(p[3]) * std::fabs(axis.scale);
    return carried + kHalfUlp * (3 * std::fabs(ndc * axis.scale) + std::fabs(axis.offset()) +
                                 2 * std::fabs(ndc * axis.scale + axis.offset()) + 1);
  };
  const double errorX = axisError(0, viewport.x), errorY = axisError(1, viewport.y);
  vertex.depthError = axisError(2, viewport.z);
  vertex.relativeWError = clip.error[3] / std::fabs(p[3]);
  vertex.deviation = std::max(errorX, errorY);

  if (rules.choices.clipArithmetic == ClipArithmetic::Exact) {
    vertex.snapped = {snapPosition(rules, samples, vertex.position.x), snapPosition(rules, samples, vertex.position.y)};
  } else {
    const ViewportArithmetic arithmetic = clippedArithmetic(rules.choices);
    const auto map = [&](size_t i, const ViewportAxis& axis) {
      return mapAndSnapFloat(rules, samples, static_cast<float>(p[i]), static_cast<float>(p[3]), axis, arithmetic);
    };
    vertex.snapped = {map(0, viewport.x), map(1, viewport.y)};
  }
  vertex.lowest = vertex.highest = vertex.snapped;
  if (rules.open) {
    const int bits = gridBits(rules);
    const SnapRange x = legalSnaps(vertex.position.x, bits, errorX + viewport.boundsUncertainty);
    const SnapRange y = legalSnaps(vertex.position.y, bits, errorY + viewport.boundsUncertainty);
    // One more grid step: a device that does not clip here has the uncut edge, whose far end was snapped instead.
    const int32_t step = 1 << (kSubpixelBits - bits);
    vertex.lowest = {x.lowest - step, y.lowest - step};
    vertex.highest = {x.highest + step, y.highest + step};
    vertex.deviation += std::max(farthest(vertex.position.x, x), farthest(vertex.position.y, y));
  }
  if (rules.error == DeliberateError::HalfPixelShift) shiftHalfPixel(vertex);
  return vertex;
}

VertexStage vertexStage(const Scene& scene, const Rules& rules, uint32_t index) {
  Viewport viewport = viewportOf(scene, index);
  if (rules.error == DeliberateError::ViewportFlipped && viewport.height < 0) {
    viewport.y += viewport.height;
    viewport.height = -viewport.height;
  }
  if (rules.variation && rules.variation->roundsViewport) viewport = onGrid(viewport, rules.limits.viewportSubPixelBits);
  return {rules, viewportTransform(viewport, scene.state.negativeOneToOne, rules.limits.viewportSubPixelBits),
          scene.target.samples};
}

}  // namespace rasterdiff::rasterizer
