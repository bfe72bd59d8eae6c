#include "rasterizer/kept_fragments.hpp"

#include <algorithm>

#include "rasterizer/depth/largest_depth.hpp"

namespace rasterdiff::rasterizer {
namespace {

using Matrix = std::array<std::array<float, 3>, 3>;

// A vertex on the grid, wherever it lies; pixels from the centre of the target's first pixel, which is exact in doubles.
struct Corner {
  double x = 0, y = 0;
  float w = 1, reciprocal = 1;
};

Corner cornerOf(const ClipPosition& p, const VertexStage& stage) {
  const float w = p.w == 0 ? 1.0F : p.w;
  return {snapAnywhere(stage.rules, stage.samples, p.x, w, stage.viewport.x).pixels - 0.5,
          snapAnywhere(stage.rules, stage.samples, p.y, w, stage.viewport.y).pixels - 0.5, p.w, 1.0F / w};
}

// Row i: what the value of vertex i adds to a, b and c of a plane through the three corners, divided by w.
Matrix planeMatrix(const Corner& first, double dx1, double dy1, double dx2, double dy2, float w1, float w2) {
  const float x1 = w1 * static_cast<float>(dx1), y1 = w1 * static_cast<float>(dy1);
  const float x2 = w2 * static_cast<float>(dx2), y2 = w2 * static_cast<float>(dy2);
  Matrix m{};
  m[0][2] = first.reciprocal;
  const float area = x1 * y2 - x2 * y1;
  if (area == 0) return m;
  const float scale = 1.0F / area, scaled = scale * first.reciprocal;
  m[0] = {(y1 * w2 - y2 * w1) * scaled, (x2 * w1 - x1 * w2) * scaled, first.reciprocal};
  m[1] = {y2 * scale, -x2 * scale, 0};
  m[2] = {-y1 * scale, x1 * scale, 0};
  return m;
}

// Which edge of its triangle a line runs along: the one between corners k and k + 1.
size_t edgeOf(const Figure& line) {
  for (size_t k = 0; k < 3; ++k) {
    const size_t opposite = (k + 2) % 3;
    if (line.a.smoothWeights[opposite] == 0 && line.b.smoothWeights[opposite] == 0) return k;
  }
  return 0;
}

size_t cornerOf(const Figure& point) {
  const auto& weights = point.a.smoothWeights;
  return static_cast<size_t>(std::ranges::max_element(weights) - weights.begin());
}

}  // namespace

bool leavesDistancesToFragments(const Rules& rules) { return !rules.open && rules.choices.clipDistances == ClipDistances::Fragments; }

KeptFragments::KeptFragments(const Primitive& primitive, const VertexStage& stage) {
  const std::array<size_t, 3> order = farthestFirst(primitive.clip);
  const auto at = [&](size_t i) { return cornerOf(primitive.clip[order[i]], stage); };
  const auto vertex = [&](size_t i) { return primitive.assembled.vertices[order[i]]; };
  const Corner a = at(0), b = at(1), c = at(2);
  x0_ = static_cast<float>(a.x);
  y0_ = static_cast<float>(a.y);
  add(*primitive.draw, {vertex(0), vertex(1), vertex(2)}, planeMatrix(a, b.x - a.x, b.y - a.y, c.x - a.x, c.y - a.y, b.w, c.w));
}

KeptFragments::KeptFragments(const Primitive& primitive, const Figure& figure, const VertexStage& stage) {
  const bool line = figure.kind == Figure::Kind::Line;
  const size_t k = primitive.assembled.count == 3 ? (line ? edgeOf(figure) : cornerOf(figure)) : 0;
  const size_t next = line ? (k + 1) % 3 : k;
  const Corner a = cornerOf(primitive.clip[k], stage), b = cornerOf(primitive.clip[next], stage);
  x0_ = static_cast<float>(a.x);
  y0_ = static_cast<float>(a.y);
  const double dx = b.x - a.x, dy = b.y - a.y;
  const uint32_t first = primitive.assembled.vertices[k], second = primitive.assembled.vertices[next];
  // A third corner beside the second end, with its values: they do not change across the line.
  add(*primitive.draw, {first, second, second}, planeMatrix(a, dx, dy, dx + dy, dy - dx, b.w, b.w));
}

void KeptFragments::add(const Draw& draw, const std::array<uint32_t, 3>& vertices, const Matrix& m) {
  for (uint32_t d = 0; d < draw.clipDistanceCount; ++d) {
    const auto value = [&](size_t i) { return draw.clipDistances[size_t{vertices[i]} * draw.clipDistanceCount + d]; };
    const auto sum = [&](size_t i) { return value(0) * m[0][i] + value(1) * m[1][i] + value(2) * m[2][i]; };
    planes_.push_back({sum(0), sum(1), sum(2)});
  }
  const auto ones = [&](size_t i) { return m[0][i] + m[1][i] + m[2][i]; };
  reciprocalW_ = {ones(0), ones(1), ones(2)};
}

bool KeptFragments::keeps(int32_t x, int32_t y) const {
  const float px = static_cast<float>(x) - x0_, py = static_cast<float>(y) - y0_;
  const float w = 1.0F / reciprocalW_.at(px, py);
  return std::ranges::all_of(planes_, [&](const Plane& plane) { return plane.at(px, py) * w >= 0; });
}

}  // namespace rasterdiff::rasterizer
