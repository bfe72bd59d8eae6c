// Stippled lines: bit floor(s / factor) mod 16 of the pattern. [vk:primsrast-lines-stipple]
#include <fmt/format.h>

#include "scene/catalogue/build.hpp"

namespace rasterdiff::families {
namespace {

Scene stippled(LineRasterizationMode mode, uint32_t factor, uint16_t pattern,
               PrimitiveTopology topology = PrimitiveTopology::LINE_LIST, float width = 1) {
  Scene scene = square(64);
  useLines(scene, mode, width, topology);
  scene.state.stippledLineEnable = true;
  scene.state.lineStippleFactor = factor;
  scene.state.lineStipplePattern = pattern;
  return scene;
}

const std::vector<Px> kLines{{2.5, 4.5}, {61.5, 4.5}, {61.5, 10.5}, {2.5, 20.5}, {6.5, 26.5}, {6.5, 61.5},
                             {12.5, 61.5}, {40.5, 28.5}, {44.25, 30.75}, {60.5, 59.25}};

/// A zigzag of segments 10.5 pixels long.
std::vector<Px> segments() {
  std::vector<Px> v{{3.5, 6.5}};
  for (int i = 0; i < 5; ++i) v.push_back({v.back().x + 10.5, 6.5});
  for (int i = 0; i < 4; ++i) v.push_back({v.back().x, v.back().y + 10.5});
  return v;
}

}  // namespace

void addLineStipple(Entries& entries) {
  Family family(entries, "line-stipple");
  const std::vector<std::string> rules{"R32"};
  using enum LineRasterizationMode;
  struct Mode {
    LineRasterizationMode mode;
    const char* name;
  };
  for (const Mode& m : {Mode{RECTANGULAR, "rect"}, Mode{BRESENHAM, "bresenham"}}) {
    const LineRasterizationMode mode = m.mode;
    family.add(fmt::format("{}-0f0f", m.name), "four on, four off, from the first fragment of each line", rules, [mode] {
      Scene scene = stippled(mode, 1, 0x0F0F);
      draw(scene, kLines);
      return scene;
    });
    family.add(fmt::format("{}-asymmetric", m.name), "a pattern without symmetry: bit 0 comes first", rules, [mode] {
      Scene scene = stippled(mode, 1, 0x3A27);
      draw(scene, kLines);
      return scene;
    });
    family.add(fmt::format("{}-factor-3", m.name), "each bit three times", rules, [mode] {
      Scene scene = stippled(mode, 3, 0x5555);
      draw(scene, kLines);
      return scene;
    });
    family.add(
        fmt::format("{}-strip", m.name), "the pattern goes on along a strip of segments 10.5 pixels long", rules,
        [mode] {
          Scene scene = stippled(mode, 1, 0x0F0F, PrimitiveTopology::LINE_STRIP);
          draw(scene, segments());
          return scene;
        },
        issue("KhronosGroup/VK-GL-CTS", mode == RECTANGULAR ? 279 : 280));
    family.add(fmt::format("{}-wide", m.name), "the pattern's bits of a line five pixels wide", rules, [mode] {
      Scene scene = stippled(mode, 2, 0x00FF, PrimitiveTopology::LINE_LIST, 5);
      draw(scene, kLines);
      return scene;
    });
  }
  for (const Mode& m : {Mode{RECTANGULAR, "rect"}, Mode{BRESENHAM, "bresenham"}}) {
    family.add(fmt::format("{}-edges", m.name), "edges of triangles in polygon mode LINE are stippled too", {"R32", "R34"},
               [mode = m.mode] {
                 Scene scene = stippled(mode, 1, 0x3A27, PrimitiveTopology::TRIANGLE_LIST);
                 scene.state.polygonMode = PolygonMode::LINE;
                 draw(scene, {{6.5, 5.5}, {56.5, 12.5}, {20.5, 57.5}, {60.5, 20.5}, {57.5, 60.5}, {30.5, 58.5}});
                 return scene;
               });
  }
  family.add("no-bit", "a pattern without bits draws nothing", rules, [] {
    Scene scene = stippled(BRESENHAM, 1, 0);
    draw(scene, kLines);
    return scene;
  });
  family.add("factor-256", "the largest factor: a line ends before the first bit does", rules, [] {
    Scene scene = stippled(BRESENHAM, 256, 0x0001);
    draw(scene, kLines);
    return scene;
  });
}

}  // namespace rasterdiff::families
