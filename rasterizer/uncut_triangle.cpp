#include "rasterizer/uncut_triangle.hpp"

#include <algorithm>
#include <cmath>

namespace rasterdiff::rasterizer {
namespace {

bool takesAllUncut(const Rules& rules) { return !rules.open && rules.choices.planePositions == PlanePositions::SnappedUncut; }

int32_t subpixels(double pixels) {
  return static_cast<int32_t>(std::clamp(pixels, -kGuardBand, kGuardBand) * kSubpixelOne);
}

// Steps are kept in 32 bits, and in float32 before: the largest of those below 2^31.
double saturated(double steps) { return std::clamp(steps, -0x1p31, 0x1.fffffep30); }

RasterVertex vertexOf(const ClipPosition& p, const VertexStage& stage) {
  RasterVertex vertex;
  const double clip[4] = {p.x, p.y, p.z, p.w};
  vertex.position = toFramebuffer(clip, stage.viewport);
  vertex.reciprocalW = 1.0 / p.w;
  vertex.depthError = depthErrorBound(p.z * stage.viewport.z.scale / p.w, stage.viewport.z.offset(), vertex.position.z);
  const double x = snapAnywhere(stage.rules, stage.samples, p.x, p.w, stage.viewport.x).pixels;
  const double y = snapAnywhere(stage.rules, stage.samples, p.y, p.w, stage.viewport.y).pixels;
  vertex.snapped = {subpixels(x), subpixels(y)};
  if (takesAllUncut(stage.rules)) {
    vertex.position.x = x;
    vertex.position.y = y;
    return vertex;
  }
  vertex.deviation = std::max(viewportArithmeticBound(p.x, p.w, stage.viewport.x), viewportArithmeticBound(p.y, p.w, stage.viewport.y)) +
                     stage.viewport.boundsUncertainty + std::ldexp(1.0, -gridBits(stage.rules));
  return vertex;
}

}  // namespace

std::optional<std::array<RasterVertex, 3>> uncutVertices(const std::array<ClipPosition, 3>& clip, const VertexStage& stage) {
  std::array<RasterVertex, 3> vertices;
  for (size_t i = 0; i < 3; ++i) {
    if (clip[i].w == 0 || (clip[i].w < 0 && !takesAllUncut(stage.rules))) return std::nullopt;
    vertices[i] = vertexOf(clip[i], stage);
    vertices[i].smoothWeights = vertices[i].linearWeights = {};
    vertices[i].smoothWeights[i] = vertices[i].linearWeights[i] = 1;
  }
  return vertices;
}

float clipDeterminant(const std::array<ClipPosition, 3>& clip) {
  const auto &a = clip[0], &b = clip[1], &c = clip[2];
  return -((a.y * b.x - a.x * b.y) * c.w + (a.x * c.y - a.y * c.x) * b.w + (c.x * b.y - b.x * c.y) * a.w);
}

template <class T>
T uncutDoubleArea(const std::array<ClipPosition, 3>& clip, const VertexStage& stage) {
  std::array<T, 3> x{}, y{};
  bool turned = false;
  for (size_t i = 0; i < 3; ++i) {
    const float w = clip[i].w == 0 ? 1.0F : clip[i].w;
    x[i] = static_cast<T>(saturated(snapAnywhere(stage.rules, stage.samples, clip[i].x, w, stage.viewport.x).steps));
    y[i] = static_cast<T>(saturated(snapAnywhere(stage.rules, stage.samples, clip[i].y, w, stage.viewport.y).steps));
    turned = turned != std::signbit(clip[i].w);
  }
  const T area = (y[0] - y[2]) * x[1] + (y[2] - y[1]) * x[0] + (y[1] - y[0]) * x[2];
  return turned ? area : -area;
}

template float uncutDoubleArea<float>(const std::array<ClipPosition, 3>&, const VertexStage&);
template double uncutDoubleArea<double>(const std::array<ClipPosition, 3>&, const VertexStage&);

}  // namespace rasterdiff::rasterizer
