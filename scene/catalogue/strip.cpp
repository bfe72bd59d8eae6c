// Triangle strips: which vertices a triangle takes, and in which order. [vk:drawing-triangle-strips]
#include "scene/catalogue/build.hpp"

namespace rasterdiff::families {
namespace {

Scene zigzag(uint32_t vertices, uint32_t samples = 1) {
  Scene scene = square(64, samples);
  scene.state.topology = PrimitiveTopology::TRIANGLE_STRIP;
  std::vector<Px> v;
  for (uint32_t i = 0; i < vertices; ++i) {
    v.push_back({4.5 + 6 * (i / 2) + (i % 2 ? 2 : 0), i % 2 == 0 ? 8.5 + (i % 3) : 54.5 - (i % 5)});
  }
  draw(scene, v);
  return scene;
}

}  // namespace

void addStrip(Entries& entries) {
  Family family(entries, "strip");
  family.add("zigzag-1x", "a strip of sixteen triangles, each next to the last", {"R11", "R14", "R15"},
             [] { return zigzag(18); });
  family.add("zigzag-4x", "a strip of sixteen triangles at four samples", {"R11", "R14", "R15"},
             [] { return zigzag(18, 4); });
  family.add("culled", "odd triangles swap two vertices: none of a strip in one plane is culled", {"R11", "R12", "R13"},
             [] {
               Scene scene = zigzag(18);
               scene.state.cullMode = CullMode::BACK;
               return scene;
             });
  family.add("culled-away", "the same strip with the other front face is gone", {"R11", "R12", "R13"}, [] {
    Scene scene = zigzag(18);
    scene.state.cullMode = CullMode::BACK;
    scene.state.frontFace = FrontFace::CLOCKWISE;
    return scene;
  });
  family.add("stitched", "repeated indices join two strips with zero-area triangles", {"R11", "R12", "R14"}, [] {
    Scene scene = square(64);
    scene.state.topology = PrimitiveTopology::TRIANGLE_STRIP;
    scene.state.cullMode = CullMode::BACK;
    draw(scene,
         {{4.5, 4.5}, {4.5, 24.5}, {30.5, 4.5}, {30.5, 24.5}, {34.5, 34.5}, {34.5, 60.5}, {60.5, 34.5}, {60.5, 60.5}})
        .indices = {0, 1, 2, 3, 3, 4, 4, 5, 6, 7};
    return scene;
  });
  family.add("one-triangle", "three vertices make one triangle", {"R14"}, [] { return zigzag(3); });
  family.add("two-vertices", "two vertices make none", {"R14"}, [] { return zigzag(2); });
  family.add("two-draws", "a strip does not go on in the next draw", {"R11", "R14"}, [] {
    Scene scene = zigzag(7);
    draw(scene, {{50.5, 8.5}, {50.5, 30.5}, {60.5, 8.5}});
    return scene;
  });
}

}  // namespace rasterdiff::families
