// Smooth lines, whose pixels and coverage a device chooses: nothing far away, something along the line, and alpha that
// tells the covered area. [vk:primsrast-lines-smooth]
#include "scene/catalogue/build.hpp"

namespace rasterdiff::families {
namespace {

/// Constant colours along each line, so that only alpha tells where the line is.
void colour(Scene& scene, float alpha, const char* name = "colour") {
  uint32_t line = 0;
  for (Draw& draw : scene.draws) {
    Varying& varying = draw.varyings.emplace_back(Varying{.name = name, .components = 4});
    for (size_t i = 0; i < draw.positions.size(); ++i) {
      const float shade = static_cast<float>(line / 2 % 4 + 1) / 4;
      varying.values.insert(varying.values.end(), {shade, 1 - shade, 0.5F, alpha});
      ++line;
    }
  }
}

Scene lines(float width, const std::vector<Px>& ends, uint32_t samples = 1, float alpha = 1) {
  Scene scene = square(64, samples);
  useLines(scene, LineRasterizationMode::RECTANGULAR_SMOOTH, width);
  draw(scene, ends);
  colour(scene, alpha);
  return scene;
}

/// One line in each octant, apart from each other.
const std::vector<Px> kOctants{{36.3, 34.2}, {60.1, 41.7}, {34.6, 37.1}, {43.2, 60.8}, {29.4, 37.6}, {21.3, 60.2},
                               {27.2, 34.9}, {3.7, 43.1},  {27.6, 29.3}, {4.2, 21.8},  {29.9, 26.4}, {20.6, 3.9},
                               {34.1, 26.8}, {42.9, 4.1},  {36.7, 29.6}, {59.8, 20.4}};
const std::vector<Px> kFew{{6.3, 8.2}, {44.7, 16.9}, {55.5, 6.5}, {55.5, 58.5}, {8.5, 55.5}, {40.5, 55.5}, {9.1, 44.6}, {37.8, 27.2}};

}  // namespace

void addLineSmooth(Entries& entries) {
  Family family(entries, "line-smooth");
  const std::vector<std::string> rules{"R33"};
  family.add("octants", "one pixel wide, in all directions", rules, [] { return lines(1, kOctants); });
  family.add("octants-4x", "the same with four samples", rules, [] { return lines(1, kOctants, 4); });
  for (const float width : {2.0F, 3.5F, 7.0F}) {
    family.add("width-" + std::to_string(static_cast<int>(width)), "wide ones, level, upright and slanted", rules,
               [width] { return lines(width, kFew); });
  }
  family.add("translucent", "a coverage that is multiplied into an alpha of a half", rules,
             [] { return lines(4, kFew, 1, 0.5F); });
  family.add("short", "lines as long as a pixel, or shorter", rules, [] {
    return lines(3, {{10.5, 10.5}, {11.5, 10.5}, {30.2, 12.7}, {30.7, 13.4}, {12.3, 40.1}, {12.3, 40.3}, {44.5, 44.5}, {45, 45}});
  });
  family.add("two-colours", "only the alpha of the first output is multiplied", rules, [] {
    Scene scene = lines(4, kFew);
    colour(scene, 1, "second");
    return scene;
  });
  family.add("edges", "edges of a triangle in polygon mode LINE", {"R33", "R34"}, [] {
    Scene scene = square(64);
    scene.state.polygonMode = PolygonMode::LINE;
    scene.state.lineRasterizationMode = LineRasterizationMode::RECTANGULAR_SMOOTH;
    scene.state.lineWidth = 2;
    draw(scene, {{6.2, 9.4}, {57.3, 22.8}, {21.7, 58.1}});
    return scene;
  });
}

}  // namespace rasterdiff::families
