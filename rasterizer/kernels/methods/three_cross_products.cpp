// The point-in-triangle test of textbooks: inside if all three cross products have one sign, either one. Exact integers,
// but no rule for ties: both neighbours get a sample on their shared edge.
#include "rasterizer/kernels/methods/methods.hpp"

namespace rasterdiff::rasterizer::methods {
namespace {

int64_t cross(SubpixelPosition a, SubpixelPosition b, SubpixelPosition p) {
  return (int64_t{b.x} - a.x) * (int64_t{p.y} - a.y) - (int64_t{b.y} - a.y) * (int64_t{p.x} - a.x);
}

}  // namespace

void threeCrossProducts(Triangles triangles, CoverageMask& mask) {
  for (const SnappedTriangle& t : triangles) {
    const Box box = boxOf(t, mask);
    for (int32_t y = box.y0; y < box.y1; ++y)
      for (int32_t x = box.x0; x < box.x1; ++x)
        for (uint32_t s = 0; s < mask.samples(); ++s) {
          const SampleLocation at = mask.locations()[s];
          const SubpixelPosition p{x * kSubpixelOne + at.x * kSampleUnit, y * kSubpixelOne + at.y * kSampleUnit};
          const int64_t a = cross(t.v[0], t.v[1], p), b = cross(t.v[1], t.v[2], p), c = cross(t.v[2], t.v[0], p);
          if ((a >= 0 && b >= 0 && c >= 0) || (a <= 0 && b <= 0 && c <= 0)) setPixel(mask, x, y, s);
        }
  }
}

}  // namespace rasterdiff::rasterizer::methods
