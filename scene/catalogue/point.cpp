// Points: squares around the unrounded vertex, of every size. [vk:primsrast-points]
#include <cmath>

#include "scene/catalogue/build.hpp"

namespace rasterdiff::families {
namespace {

/// Rows of eight points; the fraction of a pixel moves by `step` from one to the next.
Scene sized(const std::vector<float>& sizes, double pitch, double step, uint32_t samples) {
  Scene scene = square(64, samples);
  usePoints(scene);
  std::vector<Px> v;
  for (size_t i = 0; i < sizes.size(); ++i) {
    const double column = static_cast<double>(i % 8), row = std::floor(static_cast<double>(i) / 8);
    v.push_back({pitch * (column + 0.5) + step * static_cast<double>(i),
                 pitch * (row + 0.5) + 3 * step * static_cast<double>(i)});
  }
  draw(scene, v).pointSizes = sizes;
  return scene;
}

std::vector<float> sizes(float first, float step, int count) {
  std::vector<float> result;
  for (int i = 0; i < count; ++i) result.push_back(first + step * static_cast<float>(i));
  return result;
}

Scene onSamples(float size, uint32_t samples) {
  Scene scene = square(32, samples);
  usePoints(scene, size);
  std::vector<Px> v;
  for (int i = 0; i < 16; ++i) v.push_back({4 + 8.0 * (i % 4) + (i & 1) * 0.5, 4 + 8.0 * (i / 4) + (i & 2) * 0.25});
  draw(scene, v);
  return scene;
}

}  // namespace

void addPoint(Entries& entries) {
  Family family(entries, "point");
  const std::vector<std::string> rules{"R25"};
  family.add("default-size", "without any size a point is one pixel wide", {"R25", "R26"}, [] {
    Scene scene = square(32);
    usePoints(scene);
    draw(scene, {{4.5, 4.5}, {12.25, 4.75}, {20, 5}, {28.9375, 5.0625}, {5, 20.5}, {13.5, 21}});
    return scene;
  });
  family.add("small-sizes-1x", "a quarter of a pixel to two pixels, in eighths", rules,
             [] { return sized(sizes(0.25f, 0.125f, 16), 8, 1.0 / 16, 1); });
  family.add("small-sizes-4x", "a quarter of a pixel to two pixels over four samples", rules,
             [] { return sized(sizes(0.25f, 0.125f, 16), 8, 1.0 / 16, 4); });
  family.add("fractions", "sizes of any fraction are rounded to the advertised granularity", {"R25", "R51"},
             [] { return sized(sizes(0.9f, 0.07f, 40), 8, 1.0 / 16, 4); });
  family.add("even-odd", "whole sizes at a pixel's centre and corner cover their size, once", rules, [] {
    Scene scene = square(64);
    usePoints(scene);
    std::vector<Px> v;
    for (int i = 0; i < 12; ++i) v.push_back({8 + 16.0 * (i % 4) + (i & 1) * 0.5, 10 + 20.0 * (i / 4) + (i & 1) * 0.5});
    draw(scene, v).pointSizes = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12};
    return scene;
  });
  family.add("tie-on-edge-1x", "the edges of the square run through pixel centres", {"R15", "R25"},
             [] { return onSamples(3, 1); });
  family.add("tie-on-edge-4x", "the edges of the square run through samples", {"R15", "R25"},
             [] { return onSamples(3.25f, 4); });
  family.add("large", "64 pixels wide, partly outside of the target", rules, [] {
    Scene scene = square(64, 4);
    usePoints(scene);
    draw(scene, {{10.3, 12.7}, {58.1, 50.2}}).pointSizes = {64, 63.5f};
    return scene;
  });
  for (const uint32_t samples : {1u, 4u}) {
    family.add(samples == 1 ? "to-255-1x" : "to-255-4x", "sizes up to 255 pixels in eighths, around centres at fractions", {"R25", "R50", "R51"},
               [samples] {
                 Scene scene = square(256, samples);
                 usePoints(scene);
                 draw(scene, {{128.5, 128.5}, {119.0625, 136.9375}, {138.5, 117.25}, {128, 128}, {117.9375, 121.5}, {129.3, 126.7},
                              {4.5, 251.5}, {158.0625, 8.5}, {78.5, 178.75}})
                     .pointSizes = {255, 254.875f, 200.125f, 192, 160.5f, 128, 127.875f, 100.625f, 65};
                 return scene;
               });
  }
  family.add("beyond-range", "a size beyond those that devices advertise", {"R25", "R51"}, [] {
    Scene scene = target(16, 384);
    usePoints(scene, 5000);
    draw(scene, {{8, 192}});
    return scene;
  });
  family.add("off-grid", "the centre is not rounded to the subpixel grid, nor to a pixel", rules,
             [] { return sized(sizes(2.5f, 0.0f, 64), 8, 0.01171875 / 4, 1); });
  family.add("perspective", "the size is in pixels, whatever w is", rules, [] {
    Scene scene = square(64);
    usePoints(scene, 6);
    draw(scene, {{8.25, 8.5, 0.5, 0.25}, {24.5, 8.25, 0.5, 1}, {40.75, 8.5, 0.5, 3}, {56.5, 8.5, 0.5, 1000}});
    addVarying(scene, "flat", Interpolation::flat, 1);
    return scene;
  });
  for (const uint32_t samples : {1u, 4u}) {
    family.add(samples == 1 ? "coord-1x" : "coord-4x", "PointCoord runs from 0 to 1 over the square, y down", rules,
               [samples] {
                 Scene scene = square(64, samples);
                 usePoints(scene);
                 draw(scene, {{8.5, 8.5}, {24.25, 9.75}, {44, 20}, {20.3, 44.6}}).pointSizes = {1, 4.5f, 16, 33};
                 scene.builtIns = {BuiltIn::PointCoord};
                 return scene;
               });
  }
  family.add("overlap", "later points replace earlier ones", {"R25", "R50"}, [] {
    Scene scene = square(32);
    usePoints(scene, 9);
    draw(scene, {{10, 10}, {12.5, 11}, {15, 14.25}, {11.75, 16}, {12, 12}});
    return scene;
  });
}

}  // namespace rasterdiff::families
