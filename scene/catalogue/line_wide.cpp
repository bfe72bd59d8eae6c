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
