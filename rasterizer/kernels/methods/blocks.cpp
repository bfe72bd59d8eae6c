// Blocks of pixels over a triangle's box. `blockParallel` evaluates all samples of every block of 8×8; `hierarchical` first
// looks at a block's corners and leaves it out (wholly outside an edge) or fills it (inside all edges) where it can;
// `blockHierarchy` does so from 64×64 down to 16×16 and 4×4, and evaluates samples only in the smallest.
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

Whole classify(const std::array<Edge, 3>& edges, int32_t x, int32_t y, int32_t block) {
  const int64_t left = int64_t{x} * kSubpixelOne, top = int64_t{y} * kSubpixelOne, size = int64_t{block} * kSubpixelOne;
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

/// The samples of a block within the box: all of them, or those inside all edges.
void fill(const std::array<Edge, 3>& edges, const Box& block, bool all, CoverageMask& mask) {
  for (int32_t y = block.y0; y < block.y1; ++y)
    for (int32_t x = block.x0; x < block.x1; ++x)
      for (uint32_t s = 0; s < mask.samples(); ++s) {
        const int64_t px = int64_t{x} * kSubpixelOne + mask.locations()[s].x * kSampleUnit;
        const int64_t py = int64_t{y} * kSubpixelOne + mask.locations()[s].y * kSampleUnit;
        const bool inside = all || std::ranges::all_of(edges, [&](const Edge& e) { return e.a * px + e.b * py + e.c >= 0; });
        if (inside) setPixel(mask, x, y, s);
      }
}

/// Calls visit(x, y, block) for the blocks of a size that meet `area`: a block's corner, and what of it lies in the area.
template <class Visit>
void eachBlock(const Box& area, int32_t size, const Visit& visit) {
  for (int32_t y = area.y0 / size * size; y < area.y1; y += size)
    for (int32_t x = area.x0 / size * size; x < area.x1; x += size) {
      visit(x, y, Box{std::max(x, area.x0), std::max(y, area.y0), std::min(x + size, area.x1), std::min(y + size, area.y1)});
    }
}

/// Blocks are left out, filled, or handed to `partly`.
template <class Partly>
void classifyBlocks(const std::array<Edge, 3>& edges, const Box& area, int32_t size, CoverageMask& mask, const Partly& partly) {
  eachBlock(area, size, [&](int32_t x, int32_t y, const Box& block) {
    const Whole whole = classify(edges, x, y, size);
    if (whole == Whole::In) fill(edges, block, true, mask);
    if (whole == Whole::Partly) partly(block);
  });
}

template <class Draw>
void eachTriangle(Triangles triangles, CoverageMask& mask, const Draw& draw) {
  for (const SnappedTriangle& given : triangles) {
    if (doubleArea(given) == 0) continue;
    const SnappedTriangle t = clockwise(given);
    draw(edgesOf(t), boxOf(t, mask));
  }
}

}  // namespace

void blockParallel(Triangles triangles, CoverageMask& mask) {
  eachTriangle(triangles, mask, [&](const auto& edges, const Box& box) {
    eachBlock(box, kBlock, [&](int32_t, int32_t, const Box& block) { fill(edges, block, false, mask); });
  });
}

void hierarchical(Triangles triangles, CoverageMask& mask) {
  eachTriangle(triangles, mask, [&](const auto& edges, const Box& box) {
    classifyBlocks(edges, box, kBlock, mask, [&](const Box& block) { fill(edges, block, false, mask); });
  });
}

void blockHierarchy(Triangles triangles, CoverageMask& mask) {
  eachTriangle(triangles, mask, [&](const auto& edges, const Box& box) {
    classifyBlocks(edges, box, 64, mask, [&](const Box& large) {
      classifyBlocks(edges, large, 16, mask, [&](const Box& medium) {
        classifyBlocks(edges, medium, 4, mask, [&](const Box& small) { fill(edges, small, false, mask); });
      });
    });
  });
}

}  // namespace rasterdiff::rasterizer::methods
