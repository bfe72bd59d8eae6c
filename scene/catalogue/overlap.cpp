// Many primitives on one sample: each is counted. Who is seen is the business of the family order.
#include "scene/catalogue/build.hpp"

namespace rasterdiff::families {

void addOverlap(Entries& entries) {
  Family family(entries, "overlap");
  const std::vector<std::string> rules{"R14", "R50"};
  family.add("stack", "a hundred identical triangles", rules, [] {
    Scene scene = square(16);
    std::vector<Px> v;
    for (int i = 0; i < 100; ++i) v.insert(v.end(), {{1.5, 1.5}, {14.5, 2.5}, {4.5, 14.5}});
    draw(scene, v);
    return scene;
  });
  family.add("scales", "each triangle covers half of the one before", rules, [] {
    Scene scene = square(64, 4);
    std::vector<Px> v;
    for (int i = 0; i < 24; ++i) {
      const double s = 1.25 * (24 - i), x = 2.0 + i, y = 3.0 + i * 0.75;
      v.insert(v.end(), {{x, y}, {x + s, y + s / 4}, {x + s / 3, y + s}});
    }
    draw(scene, v);
    return scene;
  });
  family.add("crossing", "three triangles cross", rules, [] {
    Scene scene = square(32);
    draw(scene, {{2, 4}, {30, 10}, {4, 16}, {28, 2}, {20, 30}, {12, 4}, {4, 28}, {30, 26}, {16, 6}});
    return scene;
  });
}

}  // namespace rasterdiff::families
