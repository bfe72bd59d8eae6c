// From normalized device coordinates to pixels: offsets, fractions, flips, depth ranges. [vk:vertexpostproc-viewport]
#include <fmt/format.h>

#include "scene/catalogue/build.hpp"

namespace rasterdiff::families {
namespace {

/// The same clip-space shapes under any viewport: a triangle, and a square whose edges are on eighths.
Scene under(const Viewport& viewport, uint32_t samples = 1, uint32_t extent = 64) {
  Scene scene = square(extent, samples);
  scene.viewport = viewport;
  drawClip(scene, {{-0.875f, -0.75f, 0.25f, 1},
                   {0.75f, -0.5f, 0.5f, 1},
                   {-0.25f, 0.875f, 0.75f, 1},
                   {0.25f, 0.25f, 0.5f, 1},
                   {0.875f, 0.25f, 0.5f, 1},
                   {0.875f, 0.875f, 0.5f, 1},
                   {0.25f, 0.25f, 0.5f, 1},
                   {0.875f, 0.875f, 0.5f, 1},
                   {0.25f, 0.875f, 0.5f, 1}});
  return scene;
}

Scene withDepthRange(float minDepth, float maxDepth) {
  Scene scene = under({0, 0, 64, 64, minDepth, maxDepth});
  useDepth(scene, minDepth > maxDepth ? CompareOp::GREATER_OR_EQUAL : CompareOp::LESS_OR_EQUAL, true,
           minDepth > maxDepth ? 0.0f : 1.0f);
  return scene;
}

}  // namespace

void addViewport(Entries& entries) {
  Family family(entries, "viewport");
  const std::vector<std::string> rules{"R2"};
  family.add("offset", "the viewport starts inside the target", rules, [] { return under({13, 7, 32, 40, 0, 1}); });
  family.add("half-pixel", "the origin is at half a pixel: squares move onto centres", {"R2", "R15"}, [] {
    return under({0.5f, 0.5f, 64, 64, 0, 1});
  });
  for (int k : {1, 3, 255, 511}) {
    family.add(
        fmt::format("origin-{}-512ths", k), "the origin is off by steps of 1/512 pixel, half a grid step", rules,
        [k] {
          return under({static_cast<float>(k) / 512, -static_cast<float>(k) / 512, 64, 64, 0, 1}, 4);
        },
        k < 255 ? issue("dolphin-emu/dolphin", 10398) : issue("doitsujin/dxvk", 1864));
  }
  family.add("fractional-size", "width and height are no whole pixels", rules, [] {
    return under({3.25f, 2.75f, 50.3f, 41.7f, 0, 1});
  });
  family.add("not-power-of-two", "a size that float32 divides inexactly", rules, [] {
    return under({0, 0, 49, 27, 0, 1});
  });
  family.add("negative-height", "y is flipped", rules, [] { return under({0, 64, 64, -64, 0, 1}, 4); });
  family.add("negative-height-offset", "y is flipped about a fractional line", rules, [] {
    return under({4, 59.5f, 48, -50, 0, 1});
  });
  family.add("larger-than-target", "what lies outside of the target is not drawn", rules, [] {
    return under({-32, -32, 128, 128, 0, 1});
  });
  family.add("smaller-than-target", "nothing is drawn outside of the viewport: the volume ends there", {"R2", "R3"},
             [] {
               Scene scene = under({16, 16, 32, 32, 0, 1});
               drawClip(scene, {{-3, -0.25f, 0.5f, 1}, {3, -0.25f, 0.5f, 1}, {0, 3, 0.5f, 1}});
               return scene;
             });
  family.add("thin", "a viewport below one pixel high", rules, [] { return under({0, 10.25f, 64, 0.5f, 0, 1}); });
  family.add("fraction-4x", "at four samples the last pixel's left samples are inside of the viewport", {"R2", "R14"}, [] {
    return under({4.25f, 5.25f, 49.25f, 38.25f, 0, 1}, 4);
  });
  family.add("point-over-border", "the viewport does not cut points: their vertices are inside", {"R2", "R7", "R25"}, [] {
    Scene scene = square(32);
    usePoints(scene, 6);
    scene.viewport = {8, 8, 16, 16, 0, 1};
    draw(scene, {{9.5, 9.5}, {23.5, 16.5}, {16.5, 22.5}, {16.5, 14.5}});
    return scene;
  });
  family.add("line-over-border", "the viewport does not cut the width of lines: their ends are inside", {"R2", "R8", "R27"},
             [] {
               Scene scene = square(32);
               useLines(scene, LineRasterizationMode::RECTANGULAR, 5);
               scene.viewport = {8, 8, 16, 16, 0, 1};
               draw(scene, {{9.5, 8.5}, {22.5, 8.5}, {23.5, 10.5}, {22.5, 23.25}});
               return scene;
             });
  family.add("depth-half", "a depth range inside 0..1", {"R2", "R22"}, [] { return withDepthRange(0.25f, 0.5f); });
  family.add(
      "depth-reversed", "minDepth above maxDepth", {"R2", "R22", "R38"}, [] { return withDepthRange(1, 0); },
      "https://github.com/dolphin-emu/dolphin/issues/8244");
  family.add("depth-collapsed", "minDepth equals maxDepth: all depths are equal", {"R2", "R22", "R38"},
             [] { return withDepthRange(0.375f, 0.375f); });
}

}  // namespace rasterdiff::families
