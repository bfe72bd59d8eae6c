// What the fast kernel could get wrong, as generators; the tests compare with the oracle.
#include "kernel_families.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rasterdiff::rasterizer::testing {
namespace {

SnappedTriangle within(Prng& random, int32_t x0, int32_t y0, int32_t x1, int32_t y1, int32_t grid) {
  SnappedTriangle t;
  for (SubpixelPosition& v : t.v)
    v = {random.between(x0 / grid, x1 / grid) * grid, random.between(y0 / grid, y1 / grid) * grid};
  return t;
}

SnappedTriangle sliver(Prng& random, int32_t w, int32_t h, double longest) {
  const double angle = random.between(0.0, 2 * std::numbers::pi), length = random.between(1.0, longest) * 256;
  const double thick = random.between(0.0, 1.2) * 256, apex = random.between(0.0, length);
  const double c = std::cos(angle), s = std::sin(angle), x = random.between(0, w), y = random.between(0, h);
  const auto at = [&](double dx, double dy) {
    return SubpixelPosition{static_cast<int32_t>(std::lround(x + dx)), static_cast<int32_t>(std::lround(y + dy))};
  };
  return {{at(0, 0), at(length * c, length * s), at(apex * c - thick * s, apex * s + thick * c)}};
}

}  // namespace

std::vector<Family> hardFamilies(int32_t width, int32_t height) {
  const int32_t w = width * kSubpixelOne, h = height * kSubpixelOne;
  const auto box = [=](int32_t size, int32_t grid) {
    return [=](Prng& random) {
      const int32_t x = random.between(-size, w), y = random.between(-size, h);
      return within(random, x, y, x + size, y + size, grid);
    };
  };
  return {
      {"ties on the grid of half a pixel", box(12 * 256, 128)},
      {"ties on the grid of 1/16 pixel", box(3 * 256, 16)},
      {"large ties on the grid of half a pixel", box(150 * 256, 128)},
      {"tiny", box(300, 1)},
      {"small", box(10 * 256, 1)},
      {"medium", box(90 * 256, 1)},
      {"large", [=](Prng& random) { return within(random, 0, 0, w, h, 1); }},
      {"large, off target", [=](Prng& random) { return within(random, -w, -h, 2 * w, 2 * h, 1); }},
      {"slivers", [=](Prng& random) { return sliver(random, w, h, 500); }},
      {"slivers inside the target",
       [=](Prng& random) {
         SnappedTriangle t;
         do t = sliver(random, w, h, height);
         while (std::ranges::any_of(t.v, [&](auto v) { return v.x < 0 || v.y < 0 || v.x > w || v.y > h; }));
         return t;
       }},
      {"high and narrow",
       [=](Prng& random) {
         const int32_t x = random.between(0, w), slope = random.between(-300, 300), thick = random.between(0, 1) != 0 ? 80 : 2000;
         SnappedTriangle t;
         for (SubpixelPosition& v : t.v) {
           v.y = random.between(-300, h + 300);
           v.x = std::clamp(x + v.y / 256 * slope + random.between(0, thick), 0, w);
         }
         return t;
       }},
      {"far away, to the fast range", [](Prng& random) { return within(random, -4194304, -4194304, 4194304, 4194304, 1); }},
      {"beyond the fast range",
       [](Prng& random) { return within(random, -400000000, -400000000, 400000000, 400000000, 1); }},
      {"horizontal edges",
       [=](Prng& random) {
         auto t = box(40 * 256, 64)(random);
         t.v[random.below(2)].y = t.v[2].y;
         return t;
       }},
      {"vertical edges",
       [=](Prng& random) {
         auto t = box(40 * 256, 64)(random);
         t.v[random.below(2)].x = t.v[2].x;
         return t;
       }},
      {"zero area",
       [=](Prng& random) {
         auto t = box(40 * 256, 2)(random);
         t.v[2] = {(t.v[0].x + t.v[1].x) / 2, (t.v[0].y + t.v[1].y) / 2};
         return t;
       }},
  };
}

}  // namespace rasterdiff::rasterizer::testing
