// Large coordinates: the widest and highest targets, where products of edge functions are longest.
#include "scene/catalogue/build.hpp"

namespace rasterdiff::families {

void addFar(Entries& entries) {
  Family family(entries, "far");
  const std::vector<std::string> rules{"R2", "R14"};
  family.add("wide", "edges from one end of a 16384-pixel target to the other", {"R2", "R14", "R15"}, [] {
    Scene scene = target(16384, 8);
    draw(scene, {{0.5, 0.5}, {16383.5, 3.5}, {8191.5, 7.5}, {0.5, 0.5}, {16383.5, 3.5}, {16380.5, 0.5}});
    return scene;
  });
  family.add("high", "edges from top to bottom of a 16384-pixel target", {"R2", "R14", "R15"}, [] {
    Scene scene = target(8, 16384);
    draw(scene, {{0.5, 0.5}, {3.5, 16383.5}, {7.5, 8191.5}, {0.5, 0.5}, {3.5, 16383.5}, {0.5, 16380.5}});
    return scene;
  });
  family.add("corner-4x", "small triangles in the far corner of a wide target", rules, [] {
    Scene scene = target(16384, 8, 4);
    draw(scene, {{16370.0625, 0.125},
                 {16383.9375, 2.5},
                 {16372.25, 7.875},
                 {16383.875, 3},
                 {16383.9375, 7.75},
                 {16374, 7.9375}});
    return scene;
  });
  family.add("viewport-off-screen", "a viewport far outside of the target reaches in with one corner", rules, [] {
    Scene scene = square(64);
    scene.viewport = {-16320, -16320, 16384, 16384, 0, 1};
    draw(scene, {{-16000.5, 20.5}, {63.5, -16000.5}, {50.5, 60.5}});
    return scene;
  });
  family.add("values", "values and depth of large triangles far from the origin", {"R21", "R22"}, [] {
    Scene scene = target(16384, 4);
    useDepth(scene);
    draw(scene, {{100.25, 0, 0.125}, {16383, 1.5, 0.75, 2}, {9000.5, 4, 0.5, 0.5}});
    addVarying(scene, "value", Interpolation::smooth, 2);
    return scene;
  });
}

}  // namespace rasterdiff::families
