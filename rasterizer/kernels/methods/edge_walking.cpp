// Edge walking: an upper and a lower trapezoid, whose left and right ends are stepped by the edges' slopes in float.
#include <cmath>

#include "rasterizer/kernels/methods/methods.hpp"

namespace rasterdiff::rasterizer::methods {
namespace {

struct Vertex {
  float x, y;  // pixels, from the sample's place in its pixel
};

/// Rows from `a` to `b` between the lines through (a, b) and (long0, long1).
void trapezoid(Vertex a, Vertex b, Vertex long0, Vertex long1, CoverageMask& mask, uint32_t s) {
  const int32_t first = std::max(0, static_cast<int32_t>(std::ceil(a.y)));
  const int32_t end = std::min(static_cast<int32_t>(mask.height()), static_cast<int32_t>(std::ceil(b.y)));
  if (first >= end) return;
  const float slope = (b.x - a.x) / (b.y - a.y), longSlope = (long1.x - long0.x) / (long1.y - long0.y);
  float x = a.x + (static_cast<float>(first) - a.y) * slope;
  float longX = long0.x + (static_cast<float>(first) - long0.y) * longSlope;
  for (int32_t y = first; y < end; ++y, x += slope, longX += longSlope) {
    const float width = static_cast<float>(mask.width());
    const auto left = static_cast<int32_t>(std::ceil(std::clamp(std::min(x, longX), 0.0f, width)));
    const auto right = static_cast<int32_t>(std::ceil(std::clamp(std::max(x, longX), 0.0f, width)));
    for (int32_t p = left; p < right; ++p) setPixel(mask, p, y, s);
  }
}

}  // namespace

void edgeWalking(Triangles triangles, CoverageMask& mask) {
  for (const SnappedTriangle& t : triangles)
    for (uint32_t s = 0; s < mask.samples(); ++s) {
      Vertex v[3];
      for (size_t i = 0; i < 3; ++i)
        v[i] = {static_cast<float>(t.v[i].x) / 256.0f - static_cast<float>(mask.locations()[s].x) / 16.0f,
                static_cast<float>(t.v[i].y) / 256.0f - static_cast<float>(mask.locations()[s].y) / 16.0f};
      std::sort(v, v + 3, [](Vertex a, Vertex b) { return a.y < b.y; });
      trapezoid(v[0], v[1], v[0], v[2], mask, s);
      trapezoid(v[1], v[2], v[0], v[2], mask, s);
    }
}

}  // namespace rasterdiff::rasterizer::methods
