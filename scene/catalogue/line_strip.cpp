// Line strips: closed outlines, shared end points, corners that belong to one segment or to none.
#include <fmt/format.h>

#include "scene/catalogue/build.hpp"

namespace rasterdiff::families {
namespace {

using enum LineRasterizationMode;

/// A closed rectangle as a strip of five vertices.
Scene outline(LineRasterizationMode mode, double x0, double y0, double x1, double y1, bool clockwise, float width = 1) {
  Scene scene = square(32);
  useLines(scene, mode, width, PrimitiveTopology::LINE_STRIP);
  const Px a{x0, y0}, b{x1, y0}, c{x1, y1}, d{x0, y1};
  draw(scene, clockwise ? std::vector<Px>{a, b, c, d, a} : std::vector<Px>{a, d, c, b, a});
  return scene;
}

}  // namespace

void addLineStrip(Entries& entries) {
  Family family(entries, "line-strip");
  const std::vector<std::string> bresenham{"R29"}, rectangular{"R27"};
  family.add(
      "outline-centres", "a closed rectangle on centres: each corner once, none missing", bresenham,
      [] { return outline(BRESENHAM, 4.5, 5.5, 26.5, 21.5, true); }, issue("PCSX2/pcsx2", 8087));
  family.add(
      "outline-borders", "a closed rectangle on pixel borders keeps its corner", bresenham,
      [] { return outline(BRESENHAM, 4, 5, 26, 21, true); }, issue("godotengine/godot", 32657));
  family.add(
      "outline-other-way", "the same rectangle the other way round", bresenham,
      [] { return outline(BRESENHAM, 4, 5, 26, 21, false); }, issue("godotengine/godot", 32279));
  family.add(
      "last-pixel", "open strips end without their last pixel, in every direction", bresenham,
      [] {
        Scene scene = square(32);
        useLines(scene, BRESENHAM, 1, PrimitiveTopology::LINE_STRIP);
        draw(scene, {{3.5, 3.5}, {12.5, 3.5}, {12.5, 10.5}});
        draw(scene, {{28.5, 28.5}, {18.5, 28.5}, {18.5, 20.5}});
        draw(scene, {{4.5, 28.5}, {12.5, 20.5}, {4.5, 12.5}});
        return scene;
      },
      issue("libsdl-org/SDL", 5061));
  family.add("outline-rect", "rectangular segments leave a notch at each outer corner", rectangular,
             [] { return outline(RECTANGULAR, 4.5, 5.5, 26.5, 21.5, true); });
  family.add("outline-rect-wide", "wide segments overlap inside of the corner and leave its outer square", rectangular,
             [] { return outline(RECTANGULAR, 8, 8, 24, 22, true, 5); });
  family.add("shared-ends", "segments that meet in a point: no fragment twice, no gap", bresenham, [] {
    Scene scene = square(64);
    useLines(scene, BRESENHAM, 1, PrimitiveTopology::LINE_STRIP);
    std::vector<Px> v;
    for (int i = 0; i < 15; ++i) v.push_back({3.5 + 4 * i, 8.5 + (i * 29 % 47)});
    draw(scene, v);
    return scene;
  });
  for (const bool last : {false, true}) {
    family.add(last ? "provoking-last" : "provoking-first", "the flat value of segment i is vertex i's or i + 1's",
               {"R11", "R27"}, [last] {
                 Scene scene = outline(RECTANGULAR, 4.5, 5.5, 26.5, 21.5, true);
                 scene.state.provokingVertexMode =
                     last ? ProvokingVertexMode::LAST_VERTEX : ProvokingVertexMode::FIRST_VERTEX;
                 addVarying(scene, "flat", Interpolation::flat, 1);
                 return scene;
               });
  }
  family.add("values", "values are continuous along the strip", {"R21", "R27"}, [] {
    Scene scene = square(32);
    useLines(scene, RECTANGULAR, 1, PrimitiveTopology::LINE_STRIP);
    draw(scene, {{3.5, 3.5, 0.5, 1}, {28.5, 7.5, 0.5, 2}, {20.25, 28.5, 0.5, 0.5}, {4.5, 20.5, 0.5, 3}});
    addVarying(scene, "smooth", Interpolation::smooth, 2);
    return scene;
  });
}

}  // namespace rasterdiff::families
