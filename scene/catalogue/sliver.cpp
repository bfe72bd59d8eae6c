// Long thin triangles: little area for much edge, the worst case of every plane equation.
#include "scene/catalogue/build.hpp"

namespace rasterdiff::families {

void addSliver(Entries& entries) {
  Family family(entries, "sliver");
  const std::vector<std::string> rules{"R14"};
  family.add("horizontal", "a needle along a row of centres, 1/256 pixel high", {"R14", "R15"}, [] {
    Scene scene = target(256, 16);
    draw(scene, {{1.5, 8.5}, {254.5, 8.5}, {254.5, 8.5 + 0x1p-8}, {1.5, 4.5}, {254.5, 4.5}, {1.5, 4.5 - 0x1p-8}});
    return scene;
  });
  family.add("vertical", "a needle along a column of centres, 1/256 pixel wide", {"R14", "R15"}, [] {
    Scene scene = target(16, 256);
    draw(scene, {{8.5, 1.5}, {8.5, 254.5}, {8.5 + 0x1p-8, 254.5}, {4.5, 1.5}, {4.5, 254.5}, {4.5 - 0x1p-8, 1.5}});
    return scene;
  });
  family.add("diagonal", "a needle along a diagonal of centres", {"R14", "R15"}, [] {
    Scene scene = square(256);
    draw(scene,
         {{1.5, 1.5}, {254.5, 254.5}, {254.5, 254.5 - 0x1p-8}, {1.5, 254.5}, {254.5, 1.5}, {254.5, 1.5 + 0x1p-8}});
    return scene;
  });
  family.add("smallest-area", "twice the area is one unit of the grid squared", rules, [] {
    Scene scene = square(256, 4);
    // 255·256 - 256·255 + 1: the determinant of nearly parallel directions.
    draw(scene, {{0, 0}, {255, 254.00390625}, {254.99609375, 254}, {0, 128}, {200, 228}, {199.99609375, 227.99609375}});
    return scene;
  });
  family.add("fan-of-needles", "a hundred needles from one centre, neighbours share their long edges", {"R14", "R15"},
             [] {
               Scene scene = square(256, 4);
               scene.state.topology = PrimitiveTopology::TRIANGLE_FAN;
               std::vector<Px> v{{2.5, 2.5}};
               for (int i = 0; i <= 100; ++i) v.push_back({250 - i * 0.25, 20 + i * 0.375});
               draw(scene, v);
               return scene;
             });
  family.add("off-grid", "needles that snapping widens, narrows or turns round", {"R12", "R14"}, [] {
    Scene scene = square(256);
    std::vector<Px> v;
    for (int i = 0; i < 40; ++i) {
      const double y = 3.1 + 6.1 * i, thin = 0.001 * (i - 20);
      v.insert(v.end(), {{2.2, y}, {252.7, y + 0.37 * i}, {127.3, y + 0.185 * i + thin}});
    }
    draw(scene, v);
    return scene;
  });
}

}  // namespace rasterdiff::families
