// Inputs evaluated at an offset from the pixel's centre. [vk:limits-subPixelInterpolationOffsetBits]
#include <fmt/format.h>

#include "scene/catalogue/build.hpp"

namespace rasterdiff::families {
namespace {

struct Place {
  const char* name;
  float x, y;
};

Scene at(const std::vector<Place>& places, uint32_t samples, bool perspective) {
  Scene scene = square(32, samples);
  draw(scene, {{3.25, 2.5, 0.5, perspective ? 0.5 : 1}, {28.75, 9, 0.5, 1}, {11, 29.125, 0.5, perspective ? 3.0 : 1}});
  for (const Place& place : places) {
    addVarying(scene, place.name, Interpolation::offset, 2);
    scene.draws[0].varyings.back().offsetX = place.x;
    scene.draws[0].varyings.back().offsetY = place.y;
  }
  return scene;
}

}  // namespace

void addOffset(Entries& entries) {
  Family family(entries, "offset");
  const std::vector<std::string> rules{"R21", "R48"};
  family.add("none", "an offset of zero is the centre", rules, [] { return at({{"zero", 0, 0}}, 1, false); });
  for (const uint32_t samples : {1u, 4u}) {
    family.add(fmt::format("sixteenths-{}x", samples), "offsets on the grid that every device has", rules, [samples] {
      return at({{"right", 0.25f, 0}, {"down", 0, 0.25f}, {"both", -0.1875f, 0.4375f}}, samples, false);
    });
  }
  family.add("corners", "the ends of the range: left, top, and a step before right, bottom", rules, [] {
    return at({{"first", -0.5f, -0.5f}, {"last", 0.4375f, 0.4375f}, {"mixed", -0.5f, 0.4375f}}, 4, false);
  });
  family.add("off-grid", "offsets between the steps may be rounded", rules,
             [] { return at({{"a", 0.3f, -0.2f}, {"b", 0.01f, 0.4f}}, 1, false); });
  family.add("perspective", "offsets are on the screen, values in perspective", rules,
             [] { return at({{"a", 0.25f, -0.125f}, {"b", -0.375f, 0.3125f}}, 1, true); });
  family.add("perspective-one-pixel", "the smallest scene that shows which w an offset input is divided by", rules, [] {
    Scene scene = square(1);
    drawClip(scene, {{-1, -1, 0.5f, 1}, {1, -1, 0.5f, 1}, {2, 2, 1, 2}});
    scene.draws.front().varyings = {{.name = "offset", .interpolation = Interpolation::offset, .components = 1, .values = {0, 0, -1}, .offsetX = -0.0625f, .offsetY = -0.3125f}};
    return scene;
  });
}

}  // namespace rasterdiff::families
