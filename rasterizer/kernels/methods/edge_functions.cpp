// Three edge functions at every sample of the box, in floating-point pixels, with the top-left rule.
#include "rasterizer/kernels/methods/methods.hpp"

namespace rasterdiff::rasterizer::methods {
namespace {

template <class Real>
void draw(Triangles triangles, CoverageMask& mask) {
  for (const SnappedTriangle& given : triangles) {
    if (doubleArea(given) == 0) continue;
    const SnappedTriangle t = clockwise(given);
    const Box box = boxOf(t, mask);
    Real vx[3], vy[3];
    bool owns[3];
    for (size_t i = 0; i < 3; ++i) {
      vx[i] = static_cast<Real>(t.v[i].x) / Real{256}, vy[i] = static_cast<Real>(t.v[i].y) / Real{256};
      owns[i] = ownsTies(t.v[i], t.v[(i + 1) % 3]);
    }
    for (int32_t y = box.y0; y < box.y1; ++y)
      for (int32_t x = box.x0; x < box.x1; ++x)
        for (uint32_t s = 0; s < mask.samples(); ++s) {
          const Real px = static_cast<Real>(x) + static_cast<Real>(mask.locations()[s].x) / Real{16};
          const Real py = static_cast<Real>(y) + static_cast<Real>(mask.locations()[s].y) / Real{16};
          bool inside = true;
          for (size_t i = 0; i < 3; ++i) {
            const size_t j = (i + 1) % 3;
            const Real e = (vx[j] - vx[i]) * (py - vy[i]) - (vy[j] - vy[i]) * (px - vx[i]);
            inside = inside && (e > 0 || (e == 0 && owns[i]));
          }
          if (inside) setPixel(mask, x, y, s);
        }
  }
}

}  // namespace

void edgeFunctionsFloat(Triangles triangles, CoverageMask& mask) { draw<float>(triangles, mask); }
void edgeFunctionsDouble(Triangles triangles, CoverageMask& mask) { draw<double>(triangles, mask); }

}  // namespace rasterdiff::rasterizer::methods
