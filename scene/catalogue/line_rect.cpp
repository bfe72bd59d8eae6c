// Rectangular lines, one pixel wide: a rectangle around the segment, its ends square. [vk:primsrast-lines-basic]
#include "scene/catalogue/build.hpp"

namespace rasterdiff::families {
namespace {

constexpr auto kRect = LineRasterizationMode::RECTANGULAR;

/// Sixteen lines from near a centre to a rim, in all octants.
Scene star(uint32_t samples, double fraction) {
  Scene scene = square(64, samples);
  useLines(scene, kRect);
  constexpr int kRim[16][2] = {{28, 0},  {28, 11},  {28, 28},   {11, 28},   {0, 28},  {-11, 28}, {-28, 28}, {-28, 11},
                               {-28, 0}, {-28, -11}, {-28, -28}, {-11, -28}, {0, -28}, {11, -28}, {28, -28}, {28, -11}};
  std::vector<Px> v;
  for (const auto& rim : kRim) {
    v.push_back({32 + fraction + rim[0] / 7.0, 32 + fraction + rim[1] / 7.0});
    v.push_back({32 + fraction + rim[0], 32 + fraction + rim[1]});
  }
  draw(scene, v);
  return scene;
}

Scene lines(uint32_t extent, const std::vector<Px>& vertices, uint32_t samples = 1) {
  Scene scene = square(extent, samples);
  useLines(scene, kRect);
  draw(scene, vertices);
  return scene;
}

}  // namespace

void addLineRect(Entries& entries) {
  Family family(entries, "line-rect");
  const std::vector<std::string> rules{"R27"};
  family.add("star-1x", "all octants, ends on pixel centres", rules, [] { return star(1, 0.5); });
  family.add("star-4x", "all octants at four samples", {"R17", "R27"}, [] { return star(4, 0.5); });
  family.add(
      "star-off-centre", "all octants, ends at fractions of a pixel: the ends are perpendicular, not along an axis", rules,
      [] { return star(1, 0.1875); }, issue("KhronosGroup/VK-GL-CTS", 274));
  family.add(
      "slanted-ends-4x", "a line's end is perpendicular to it, which four samples see", {"R17", "R27"},
      [] { return lines(32, {{4, 5}, {28, 12}, {6, 28}, {14, 9}, {20.5, 29.5}, {29.5, 20.5}}, 4); },
      issue("KhronosGroup/VK-GL-CTS", 275));
  family.add("axis-parallel", "horizontal and vertical lines on centres and between them", {"R15", "R27"}, [] {
    return lines(32, {{2.5, 4.5}, {13.5, 4.5}, {16.5, 5}, {29.5, 5}, {2, 9.25}, {13, 9.25}, {29, 9.75}, {16, 9.75},
                      {4.5, 14.5}, {4.5, 29.5}, {9, 14.5}, {9, 29.5}, {14.25, 14}, {14.25, 29}, {19.75, 29}, {19.75, 14}});
  });
  family.add("zero-length", "a line of no length has no direction, and covers nothing that the rectangle would", rules,
             [] { return lines(16, {{4.5, 4.5}, {4.5, 4.5}, {8, 8}, {8, 8}, {11.3, 4.7}, {11.3, 4.7}}); });
  family.add("short", "shorter than a pixel, across a centre and beside it", rules, [] {
    return lines(32, {{4.4, 4.5}, {4.6, 4.5}, {8.6, 4.5}, {8.9, 4.5}, {12.5, 4.25}, {12.5, 4.75}, {16.2, 4.2},
                      {16.8, 4.8}, {20.0, 4.0}, {20.4, 4.4}, {24.5, 4.5}, {25.5, 4.5}});
  });
  family.add(
      "end-at-099", "ends at (0.99, 0.5) and (0.99, 0.49)", rules,
      [] { return lines(16, {{2.5, 2.5}, {5.99, 2.5}, {2.5, 6.5}, {5.99, 6.49}, {2.01, 10.5}, {5.5, 10.5}}); },
      issue("KhronosGroup/MoltenVK", 1123));
  family.add(
      "inside-a-pixel", "from (0.5, 0.2) to (0.7, 0.2): inside of a pixel, above its centre", rules,
      [] { return lines(16, {{2.5, 2.2}, {2.7, 2.2}, {6.2, 2.5}, {6.2, 2.7}, {10.5, 2.5}, {10.7, 2.5}}); },
      issue("KhronosGroup/MoltenVK", 2518));
  family.add("values", "values run along the line, in perspective and on the screen", {"R21", "R27"}, [] {
    Scene scene = lines(32, {{3.5, 3.5, 0.25, 1}, {28.5, 11.5, 0.75, 4}, {5.25, 28.5, 0.5, 2}, {9.5, 6.25, 0.5, 0.5}});
    addVarying(scene, "smooth", Interpolation::smooth, 2);
    addVarying(scene, "screen", Interpolation::noperspective, 1);
    addVarying(scene, "flat", Interpolation::flat, 1);
    return scene;
  });
  family.add("depth", "depth runs along the line", {"R22", "R27", "R38"}, [] {
    Scene scene = lines(32, {{3.5, 16.5, 0}, {28.5, 16.5, 1}, {16.5, 3.5, 1}, {16.5, 28.5, 0.125}});
    useDepth(scene);
    return scene;
  });
  family.add("clipped", "lines that leave the view volume through each side, and between the planes", {"R8", "R27"}, [] {
    Scene scene = square(64);
    useLines(scene, kRect);
    drawClip(scene, {{-2, -0.5f, 0.5f, 1}, {2, 0.25f, 0.5f, 1}, {0.25f, -3, 0.5f, 1}, {-0.5f, 2, 0.5f, 1},
                     {-0.75f, 0.5f, -1, 1}, {0.75f, 0.75f, 0.5f, 1}, {-0.75f, -0.75f, 2, 1}, {0.75f, -0.625f, 0.5f, 1},
                     {-1.5f, 0.5f, 0.5f, 1}, {-1.25f, -0.5f, 0.5f, 1}, {0.5f, 0.5f, 0.5f, 1}, {-0.25f, 0.5f, 0.5f, -1}});
    return scene;
  });
  family.add("guard-band", "lines whose ends are up to 1e30 outside", {"R8", "R27"}, [] {
    Scene scene = square(64);
    useLines(scene, kRect);
    std::vector<ClipPosition> v;
    float y = -0.875f;
    for (const float far : {1e3f, 1e6f, 1e12f, 1e30f}) {
      v.insert(v.end(), {{-far, y, 0.5f, 1}, {far, y, 0.5f, 1}, {y, 0.25f, 0.5f, 1}, {y + 0.0625f, far, 0.5f, 1}, {0.25f, y, 0.5f, 1}, {far, far, 0.5f, 1}});
      y += 0.3125f;
    }
    drawClip(scene, std::move(v));
    return scene;
  });
  family.add("clipped-values", "what is left of a clipped line has the values it would have had unclipped", {"R8", "R9", "R27"}, [] {
    Scene scene = square(64);
    useLines(scene, kRect);
    drawClip(scene, {{-3, -0.5f, 0.5f, 1}, {0.5f, 0.25f, 0.5f, 1}, {-0.5f, -0.75f, -1, 1}, {3, 0.75f, 2, 4}, {0.75f, 2, 0.5f, 1}, {0.25f, -4, 1, 2}});
    addVarying(scene, "smooth", Interpolation::smooth, 2);
    addVarying(scene, "screen", Interpolation::noperspective, 1);
    addVarying(scene, "flat", Interpolation::flat, 1);
    return scene;
  });
  family.add("values-4x", "depth and an input at the samples: evaluated where the sample is, not half a pixel beside it", {"R20", "R22", "R27"}, [] {
    Scene scene = lines(16, {{2.5, 2.5, 0.25}, {12.5, 2.5, 0.75}, {2.5, 5.5, 0.25}, {2.5, 13.5, 0.75}, {5.5, 5.5, 0.25}, {13.5, 11.5, 0.75}}, 4);
    useDepth(scene);
    addVarying(scene, "sample", Interpolation::sample, 1);
    return scene;
  });
  family.add("default-mode", "mode DEFAULT: rectangular where lines are strict", {"R27", "R28"}, [] {
    Scene scene = lines(32, {{3.5, 3.25}, {28.5, 11.5}, {5.25, 28.5}, {9.5, 6.25}, {28, 14}, {14, 28}});
    scene.state.lineRasterizationMode = LineRasterizationMode::DEFAULT;
    return scene;
  });
}

}  // namespace rasterdiff::families
