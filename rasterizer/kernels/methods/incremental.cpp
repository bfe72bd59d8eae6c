// Edge functions stepped by additions from sample to sample: in float, in double, and in fixed point with a sixteenth of
// a pixel (28.4), which drops four bits of every vertex.
#include <cmath>

#include "rasterizer/kernels/methods/methods.hpp"

namespace rasterdiff::rasterizer::methods {
namespace {

/// kUnits: of a coordinate to a pixel.
template <class Number, int32_t kUnits>
void draw(Triangles triangles, CoverageMask& mask) {
  for (const SnappedTriangle& given : triangles) {
    if (doubleArea(given) == 0) continue;
    const SnappedTriangle t = clockwise(given);
    const Box box = boxOf(t, mask);
    const auto coordinate = [](int32_t v) {
      if constexpr (kUnits == 1) return static_cast<Number>(v) / Number{256};
      else return static_cast<Number>((int64_t{v} + 8) >> 4);  // Q.8 → Q.4, nearest
    };
    for (uint32_t s = 0; s < mask.samples(); ++s) {
      const auto place = [&](int32_t pixel, uint8_t at) {
        return static_cast<Number>(pixel) * Number{kUnits} + static_cast<Number>(at) * Number{kUnits} / Number{16};
      };
      const Number px = place(box.x0, mask.locations()[s].x), py = place(box.y0, mask.locations()[s].y);
      Number row[3], stepX[3], stepY[3];
      bool owns[3];
      for (size_t i = 0; i < 3; ++i) {
        const SubpixelPosition a = t.v[i], b = t.v[(i + 1) % 3];
        const Number dx = coordinate(b.x) - coordinate(a.x), dy = coordinate(b.y) - coordinate(a.y);
        row[i] = dx * (py - coordinate(a.y)) - dy * (px - coordinate(a.x));
        stepX[i] = -dy * Number{kUnits}, stepY[i] = dx * Number{kUnits};
        owns[i] = ownsTies(a, b);
      }
      for (int32_t y = box.y0; y < box.y1; ++y) {
        Number e[3] = {row[0], row[1], row[2]};
        for (int32_t x = box.x0; x < box.x1; ++x) {
          bool inside = true;
          for (size_t i = 0; i < 3; ++i) {
            inside = inside && (e[i] > 0 || (e[i] == 0 && owns[i]));
            e[i] += stepX[i];
          }
          if (inside) setPixel(mask, x, y, s);
        }
        for (size_t i = 0; i < 3; ++i) row[i] += stepY[i];
      }
    }
  }
}

}  // namespace

void incrementalFloat(Triangles triangles, CoverageMask& mask) { draw<float, 1>(triangles, mask); }
void incrementalDouble(Triangles triangles, CoverageMask& mask) { draw<double, 1>(triangles, mask); }
// Q28.4 × Q28.4 → Q56.8: no overflow for any int32 vertex
void incrementalFixed(Triangles triangles, CoverageMask& mask) { draw<int64_t, 16>(triangles, mask); }

}  // namespace rasterdiff::rasterizer::methods
