// Rasterization order: of all that covers a sample the last one stays. [vk:primsrast-order]
#include "scene/catalogue/build.hpp"

namespace rasterdiff::families {

void addOrder(Entries& entries) {
  Family family(entries, "order");
  const std::vector<std::string> rules{"R50"};
  family.add("in-a-draw", "later triangles of a draw replace earlier ones", rules, [] {
    Scene scene = square(32);
    draw(scene, {{2, 2}, {26, 4}, {6, 28}, {30, 3}, {5, 5}, {27, 29}, {16, 1}, {31, 31}, {1, 25}});
    return scene;
  });
  family.add("across-draws", "later draws replace earlier ones", rules, [] {
    Scene scene = square(32, 4);
    draw(scene, {{2, 2}, {26, 4}, {6, 28}});
    draw(scene, {{30, 3}, {5, 5}, {27, 29}});
    draw(scene, {{16, 1}, {31, 31}, {1, 25}});
    return scene;
  });
  family.add("flat-colour", "the value that stays is that of the last primitive", {"R11", "R50"}, [] {
    Scene scene = square(32);
    std::vector<Px> v;
    for (int i = 0; i < 12; ++i)
      v.insert(v.end(), {{1.0 + i, 2.0 + i}, {20.0 + i, 4.0 + i / 2.0}, {4.0 + i, 18.0 + i}});
    draw(scene, v);
    addVarying(scene, "flat", Interpolation::flat, 1);
    return scene;
  });
  family.add("strip-folded", "a strip lies on itself", rules, [] {
    Scene scene = square(32);
    scene.state.topology = PrimitiveTopology::TRIANGLE_STRIP;
    draw(scene, {{4, 4}, {28, 4}, {6, 28}, {28, 26}, {5, 6}, {27, 7}, {8, 30}});
    return scene;
  });
}

}  // namespace rasterdiff::families
