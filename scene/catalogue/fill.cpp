// One triangle and its samples: which are inside, and ties on every kind of edge.
#include "scene/catalogue/build.hpp"

namespace rasterdiff::families {
namespace {

Scene triangle(uint32_t samples) {
  Scene scene = square(32, samples);
  draw(scene, {{3.25, 2.5}, {28.75, 9}, {11, 29.125}});
  return scene;
}

/// A right triangle in each orientation and winding, all edges through pixel centres.
Scene edgesThroughCentres() {
  Scene scene = square(64);
  std::vector<Px> v;
  for (int i = 0; i < 8; ++i) {
    const double x = 4.5 + 16 * (i % 4), y = 8.5 + 24 * (i / 4);
    const double dx = i & 1 ? -3 : 9, dy = i & 2 ? -5 : 9;
    const Px corner{x + (i & 1 ? 6 : 0), y + (i & 2 ? 5 : 0)};
    Px a{corner.x + dx, corner.y}, b{corner.x, corner.y + dy};
    if (i & 4) std::swap(a, b);
    v.insert(v.end(), {corner, a, b});
  }
  draw(scene, v);
  return scene;
}

/// Sixteen thin-ended triangles around a centre: edges in 32 directions, all from one sample to another.
Scene allEdgeDirections() {
  Scene scene = square(64);
  constexpr int kRim[16][2] = {{24, 0},  {24, 8},   {24, 24},   {8, 24},   {0, 24},  {-8, 24}, {-24, 24}, {-24, 8},
                               {-24, 0}, {-24, -8}, {-24, -24}, {-8, -24}, {0, -24}, {8, -24}, {24, -24}, {24, -8}};
  for (int i = 0; i < 16; ++i) {
    const auto *a = kRim[i], *b = kRim[(i + 1) % 16];
    draw(scene, {{32.5, 32.5}, {32.5 + a[0], 32.5 + a[1]}, {32.5 + b[0], 32.5 + b[1]}});
  }
  return scene;
}

/// A small triangle in each of 256 cells, moved by k steps of 1/`steps` pixel in x and 7k in y.
Scene steps(int stepsPerPixel, uint32_t samples) {
  Scene scene = square(64, samples);
  std::vector<Px> v;
  for (int i = 0; i < 256; ++i) {
    const double x = 4.0 * (i % 16) + static_cast<double>(i % stepsPerPixel) / stepsPerPixel;
    const double y = 4.0 * (i / 16) + static_cast<double>(i * 7 % stepsPerPixel) / stepsPerPixel;
    v.insert(v.end(), {{x, y}, {x + 2.5, y + 0.5}, {x + 0.5, y + 2.5}});
  }
  draw(scene, v);
  return scene;
}

Scene vertexOnSample(uint32_t samples) {
  Scene scene = square(64, samples);
  const double sx = samples == 4 ? 6 / 16.0 : 0.5, sy = samples == 4 ? 2 / 16.0 : 0.5;
  std::vector<Px> v;
  for (int i = 0; i < 8; ++i) {  // the vertex is the top, right, bottom, left one, in either winding
    const double x = 8 + 16 * (i % 4) + sx, y = 16 + 32 * (i / 4) + sy;
    constexpr double kTo[4][4] = {{-3, 5, 4, 6}, {-6, -3, -5, 4}, {4, -6, -3, -5}, {6, 3, 5, -4}};
    Px a{x + kTo[i % 4][0], y + kTo[i % 4][1]}, b{x + kTo[i % 4][2], y + kTo[i % 4][3]};
    if (i >= 4) std::swap(a, b);
    v.insert(v.end(), {{x, y}, a, b});
  }
  draw(scene, v);
  return scene;
}

}  // namespace

void addFill(Entries& entries) {
  Family family(entries, "fill");
  family.add("triangle-1x", "a plain triangle is filled at pixel centres", {"R14"}, [] { return triangle(1); });
  family.add("triangle-4x", "a plain triangle is filled at four samples a pixel", {"R14", "R17"},
             [] { return triangle(4); });
  family.add("shared-diagonal", "the two triangles of a quad share a diagonal that runs through samples",
             {"R14", "R15", "R17"}, [] {
               Scene scene = square(64, 4);
               draw(scene, rectangle(8.375, 8.125, 56.375, 56.125));
               return scene;
             });
  family.add("edges-through-centres",
             "horizontal, vertical and diagonal edges run through pixel centres in every orientation", {"R14", "R15"},
             edgesThroughCentres);
  family.add("all-edge-directions", "edges in 16 directions, each of them a shared tie", {"R14", "R15"},
             allEdgeDirections);
  family.add("vertex-on-sample-1x", "a vertex lies on a pixel centre as top, right, bottom or left corner",
             {"R14", "R15"}, [] { return vertexOnSample(1); });
  family.add("vertex-on-sample-4x", "a vertex lies on the first of four samples", {"R14", "R15", "R17"},
             [] { return vertexOnSample(4); });
  family.add(
      "sixteenth-steps", "positions move in steps of 1/16 pixel, which every device has to resolve", {"R14"},
      [] { return steps(16, 1); }, "https://github.com/xemu-project/xemu/issues/2183");
  family.add(
      "256th-steps-1x", "positions move in steps of 1/256 pixel: a 4-bit grid shows", {"R14"},
      [] { return steps(256, 1); }, "https://github.com/xemu-project/xemu/issues/2183");
  family.add("256th-steps-4x", "steps of 1/256 pixel at four samples", {"R14", "R17"}, [] { return steps(256, 4); });
  family.add("off-grid", "positions between grid points: the snap rounds", {"R14"}, [] { return steps(1000, 1); });
  family.add("whole-target", "one triangle covers every pixel of the target", {"R14"}, [] {
    Scene scene = square(32, 4);
    scene.viewport = {0, 0, 64, 64, 0, 1};
    draw(scene, {{0, 0}, {64, 0}, {0, 64}});
    return scene;
  });
  family.add("square-on-centres", "a square from centre to centre covers its size once, not one more", {"R14", "R15"},
             [] {
               Scene scene = square(16);
               draw(scene, rectangle(2.5, 3.5, 12.5, 13.5));
               return scene;
             });
  family.add("square-on-borders", "a square from pixel border to pixel border fills just these pixels", {"R14"}, [] {
    Scene scene = square(16, 4);
    draw(scene, rectangle(2, 3, 12, 13));
    return scene;
  });
  family.add("between-samples", "triangles that reach no sample cover nothing", {"R14"}, [] {
    Scene scene = square(16);
    draw(scene, {{4.53125, 4.5625}, {5.46875, 4.5625}, {5, 5.4375}, {8, 8}, {8.4375, 8}, {8, 8.4375}});
    return scene;
  });
  family.add("zero-area", "collinear and repeated vertices through samples cover nothing", {"R12", "R14"}, [] {
    Scene scene = square(32);
    draw(scene, {{2.5, 2.5},
                 {10.5, 10.5},
                 {20.5, 20.5},
                 {3.5, 8.5},
                 {29.5, 8.5},
                 {12.5, 8.5},
                 {5.5, 5.5},
                 {5.5, 5.5},
                 {25.5, 6.5},
                 {9.5, 9.5},
                 {9.5, 9.5},
                 {9.5, 9.5},
                 {16.5, 2.5},
                 {16.5, 30.5},
                 {16.5, 12.5}});
    return scene;
  });
  family.add("zero-area-after-snap", "triangles thinner than the grid collapse when they are snapped", {"R12", "R14"},
             [] {
               Scene scene = square(32);
               draw(scene, {{2.5, 4.5 - 0x1p-12},
                            {29.5, 4.5 + 0x1p-12},
                            {12.5, 4.5 + 0x1p-12},
                            {4.5 + 0x1p-11, 8.5},
                            {4.5 - 0x1p-11, 29.5},
                            {4.5, 16.5},
                            {8.5, 8.5 + 0x1p-11},
                            {28.5, 28.5 - 0x1p-11},
                            {18.5, 18.5 + 0x1p-12}});
               return scene;
             });
  family.add("one-sample", "a triangle around one pixel centre covers just that pixel", {"R14"}, [] {
    Scene scene = square(16);
    draw(scene, {{5.25, 5.25}, {5.875, 5.375}, {5.375, 5.875}});
    return scene;
  });
}

}  // namespace rasterdiff::families
