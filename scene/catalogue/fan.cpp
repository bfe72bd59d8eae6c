// Triangle fans: every triangle has the first vertex. [vk:drawing-triangle-fans]
#include "scene/catalogue/build.hpp"

namespace rasterdiff::families {
namespace {

Scene octagon(uint32_t samples = 1) {
  Scene scene = square(64, samples);
  scene.state.topology = PrimitiveTopology::TRIANGLE_FAN;
  draw(scene, {{32.5, 32.5},
               {60.5, 32.5},
               {52.5, 52.5},
               {32.5, 60.5},
               {12.5, 52.5},
               {4.5, 32.5},
               {12.5, 12.5},
               {32.5, 4.5},
               {52.5, 12.5},
               {60.5, 32.5}});
  return scene;
}

}  // namespace

void addFan(Entries& entries) {
  Family family(entries, "fan");
  family.add("octagon-1x", "a closed fan around a pixel centre leaves no seam", {"R11", "R14", "R15"},
             [] { return octagon(); });
  family.add("octagon-4x", "a closed fan at four samples", {"R11", "R14", "R15"}, [] { return octagon(4); });
  family.add("culled", "all triangles of a fan have its winding", {"R11", "R12", "R13"}, [] {
    Scene scene = octagon();
    scene.state.cullMode = CullMode::FRONT;
    return scene;
  });
  family.add("folded", "a concave outline folds over: some triangles face away and overlap", {"R12", "R13", "R50"}, [] {
    Scene scene = square(64);
    scene.state.topology = PrimitiveTopology::TRIANGLE_FAN;
    scene.state.cullMode = CullMode::BACK;
    scene.state.frontFace = FrontFace::CLOCKWISE;
    draw(scene, {{4.5, 4.5}, {60.5, 8.5}, {20.5, 20.5}, {56.5, 30.5}, {24.5, 40.5}, {30.5, 60.5}, {6.5, 50.5}});
    return scene;
  });
  family.add("indexed", "the hub is an index like any other", {"R11", "R14"}, [] {
    Scene scene = square(64);
    scene.state.topology = PrimitiveTopology::TRIANGLE_FAN;
    draw(scene, {{60.5, 30.5}, {40.5, 60.5}, {4.5, 30.5}, {30.5, 4.5}, {32.5, 32.5}}).indices = {4, 0, 1, 2, 3, 0};
    return scene;
  });
}

}  // namespace rasterdiff::families
