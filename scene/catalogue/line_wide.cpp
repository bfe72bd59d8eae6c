// Lines of other widths than one: rectangles, and columns of Bresenham fragments.
#include <fmt/format.h>

#include "scene/catalogue/build.hpp"

namespace rasterdiff::families {
namespace {

Scene wide(LineRasterizationMode mode, float width, uint32_t samples) {
  Scene scene = square(64, samples);
  useLines(scene, mode, width);
  draw(scene, {{10.5, 10.25}, {54.5, 18.5}, {50.25, 30.5}, {14.5, 30.5}, {12.5, 52.5}, {20.75, 40}, {44.5, 40.5}, {56.5, 52.5}});
  return scene;
}

/// One line in each octant and along each axis, shorter than most are wide, across one another: their numbers and the
/// last of them are compared at every sample.
Scene octants(LineRasterizationMode mode, float width, uint32_t samples) {
  Scene scene = square(256, samples);
  useLines(scene, mode, width);
  draw(scene, {{74.25, 121.5}, {165.75, 121.5}, {119.125, 65.25}, {148.5, 98.0625}, {138.5, 59.75}, {159.3, 128.7},
               {128.5, 177.5}, {128.5, 78.5}, {149.7, 68.2}, {118.4, 149.9}, {168.5, 98.5}, {88.5, 178.5},
               {182.25, 149}, {73.0625, 109.75}, {158.5, 148.5}, {118.5, 108.5}, {109.2, 158.6}, {139.9, 97.1},
               {95.5, 73.5}, {119.5, 183.5}, {127.1, 127.3}, {130.6, 128.4}, {178.5, 119}, {77.5, 130.75}});
  return scene;
}

}  // namespace

void addLineWide(Entries& entries) {
  Family family(entries, "line-wide");
  using enum LineRasterizationMode;
  for (const float width : {0.5f, 1.5f, 2.0f, 3.25f, 8.0f, 20.0f}) {
    family.add(fmt::format("rect-{}-4x", width), "a rectangle of this width at four samples", {"R17", "R27", "R51"},
               [width] { return wide(RECTANGULAR, width, 4); });
  }
  for (const float width : {1.5f, 2.0f, 2.5f, 2.75f, 3.0f, 8.0f}) {
    family.add(fmt::format("bresenham-{}", width), "columns and rows of the rounded width, moved by half of it",
               {"R29", "R30"}, [width] { return wide(BRESENHAM, width, 1); });
  }
  family.add("bresenham-5-4x", "every pixel of a wide Bresenham line has all samples", {"R29", "R30", "R31"},
             [] { return wide(BRESENHAM, 5, 4); });
  struct Mode {
    const char* name;
    LineRasterizationMode mode;
    bool everySampleCount;  ///< of every width
    std::vector<std::string> rules;
  };
  for (const Mode& kind : {Mode{"rect", RECTANGULAR, true, {"R27", "R50", "R51"}},
                           Mode{"default", DEFAULT, false, {"R28", "R50", "R51"}},
                           Mode{"bresenham", BRESENHAM, true, {"R29", "R30", "R31"}},
                           Mode{"smooth", RECTANGULAR_SMOOTH, false, {"R33"}}}) {
    for (const float width : {32.0f, 64.5f, 128.0f, 255.0f}) {
      for (const uint32_t samples : {1u, 4u}) {
        const uint32_t wanted = width == 32 || width == 128 ? 1 : 4;
        if (!kind.everySampleCount && samples != wanted) continue;
        family.add(fmt::format("octants-{}-{}-{}x", kind.name, width, samples), "lines wider than long, in all octants",
                   kind.rules, [mode = kind.mode, width, samples] { return octants(mode, width, samples); });
      }
    }
  }
  family.add("rect-crossing", "wide lines in perspective cross one another: the last one wins", {"R27", "R50"}, [] {
    Scene scene = square(64);
    useLines(scene, RECTANGULAR, 7);
    draw(scene, {{8, 8, 0.5, 1}, {56, 56, 0.5, 3}, {56, 8, 0.5, 0.5}, {8, 56, 0.5, 2}});
    return scene;
  });
  for (const bool bresenham : {false, true}) {
    family.add(bresenham ? "bresenham-beyond-range" : "rect-beyond-range", "widths beyond those that devices advertise",
               {bresenham ? "R30" : "R27", "R51"}, [bresenham] {
                 Scene scene = target(8, 384);
                 useLines(scene, bresenham ? BRESENHAM : RECTANGULAR, 300);
                 draw(scene, {{2.5, 192.5}, {5.5, 192.5}});
                 return scene;
               });
    family.add(
        bresenham ? "values-bresenham" : "values-rect", "values across a wide line: by projection, or the same in a column",
        {bresenham ? "R30" : "R27", "R21"},
        [bresenham] {
          Scene scene = wide(bresenham ? BRESENHAM : RECTANGULAR, 6, 1);
          addVarying(scene, "smooth", Interpolation::smooth, 2);
          addVarying(scene, "screen", Interpolation::noperspective, 1);
          return scene;
        },
        issue("KhronosGroup/VK-GL-CTS", bresenham ? 309 : 273));
  }
  family.add("values-default", "mode DEFAULT: a parallelogram's or a rectangle's values", {"R28", "R21"}, [] {
    Scene scene = wide(DEFAULT, 5, 1);
    addVarying(scene, "smooth", Interpolation::smooth, 2);
    return scene;
  });
}

}  // namespace rasterdiff::families
