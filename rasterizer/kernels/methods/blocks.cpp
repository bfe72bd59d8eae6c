// Blocks of 8×8 pixels over a triangle's box. `blockParallel` evaluates all samples of every block; `hierarchical` first
// looks at a block's corners and leaves it out (wholly outside an edge) or fills it (inside all edges) where it can.
#include <array>

#include "rasterizer/kernels/methods/methods.hpp"

namespace rasterdiff::rasterizer::methods {
namespace {

constexpr int32_t kBlock = 8;

struct Edge {
  int64_t a, b, c;  // inside: a·x + b·y + c >= 0, ties folded into c; x, y in 1/256 pixel
};

std::array<Edge, 3> edgesOf(const SnappedTriangle& t) {
  std::array<Edge, 3> edges{};
  for (size_t i = 0; i < 3; ++i) {
    const SubpixelPosition p = t.v[i], q = t.v[(i + 1) % 3];
    const int64_t a = int64_t{p.y} - q.y, b = int64_t{q.x} - p.x;
    edges[i] = {a, b, -a * p.x - b * p.y - (ownsTies(p, q) ? 0 : 1)};
  }
  return edges;
}

enum class Whole { Out, In, Partly };

Whole classify(const std::array<Edge, 3>& edges, int32_t x, int32_t y) {
  const int64_t left = int64_t{x} * kSubpixelOne, top = int64_t{y} * kSubpixelOne, size = kBlock * kSubpixelOne;
  Whole result = Whole::In;
  for (const Edge& e : edges) {
    const int64_t corner = e.a * left + e.b * top + e.c;
    const int64_t most = corner + std::max<int64_t>(0, e.a * size) + std::max<int64_t>(0, e.b * size);
    const int64_t least = corner + std::min<int64_t>(0, e.a * size) + std::min<int64_t>(0, e.b * size);
    if (most < 0) return Whole::Out;
    if (least < 0) result = Whole::Partly;
  }
  return result;
}

template <bool kHierarchical>
void draw(Triangles triangles, CoverageMask& mask) {
  for (const SnappedTriangle& given : triangles) {
    if (doubleArea(given) == 0) continue;
    const SnappedTriangle t = clockwise(given);
    const auto edges = edgesOf(t);
    const Box box = boxOf(t, mask);
    for (int32_t by = box.y0 / kBlock * kBlock; by < box.y1; by += kBlock)
      for (int32_t bx = box.x0 / kBlock * kBlock; bx < box.x1; bx += kBlock) {
        const Whole whole = kHierarchical ? classify(edges, bx, by) : Whole::Partly;
        if (whole == Whole::Out) continue;
        for (int32_t y = by; y < std::min(by + kBlock, box.y1); ++y)
          for (int32_t x = bx; x < std::min(bx + kBlock, box.x1); ++x)
            for (uint32_t s = 0; s < mask.samples(); ++s) {
              const int64_t px = int64_t{x} * kSubpixelOne + mask.locations()[s].x * kSampleUnit;
              const int64_t py = int64_t{y} * kSubpixelOne + mask.locations()[s].y * kSampleUnit;
              const bool inside = whole == Whole::In || std::ranges::all_of(edges, [&](const Edge& e) {
                                    return e.a * px + e.b * py + e.c >= 0;
                                  });
              if (inside) setPixel(mask, x, y, s);
            }
      }
  }
}

}  // namespace

void blockParallel(Triangles triangles, CoverageMask& mask) { draw<false>(triangles, mask); }
void hierarchical(Triangles triangles, CoverageMask& mask) { draw<true>(triangles, mask); }

}  // namespace rasterdiff::rasterizer::methods
