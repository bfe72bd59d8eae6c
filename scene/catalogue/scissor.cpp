// The scissor test: half-open in both directions, per pixel. [vk:fragops-scissor]
#include "scene/catalogue/build.hpp"

namespace rasterdiff::families {
namespace {

Scene through(const Rect2D& scissor, uint32_t samples = 1) {
  Scene scene = square(32, samples);
  scene.scissor = scissor;
  draw(scene, {{1.25f, 2.5f}, {30.75f, 6}, {12, 31.125f}});
  return scene;
}

}  // namespace

void addScissor(Entries& entries) {
  Family family(entries, "scissor");
  const std::vector<std::string> rules{"R39"};
  family.add("inside-1x", "a rectangle in the middle", rules, [] { return through({9, 7, 11, 13}); });
  family.add("inside-4x", "a rectangle cuts pixels, never samples of a pixel", rules, [] {
    return through({9, 7, 11, 13}, 4);
  });
  family.add("one-pixel", "only one pixel is let through", rules, [] { return through({14, 11, 1, 1}, 4); });
  family.add("beyond-target", "a rectangle that goes on outside of the target", rules, [] {
    return through({20, 5, 1000, 1000});
  });
  family.add("outside", "a rectangle outside of the target lets nothing through", rules, [] {
    return through({40, 40, 8, 8});
  });
  family.add("whole", "a rectangle of the target's size changes nothing", {"R39", "R49"}, [] {
    return through({0, 0, 32, 32});
  });
  family.add("depth-untouched", "outside of the scissor depth is not written either", {"R38", "R39"}, [] {
    Scene scene = through({8, 8, 12, 12});
    useDepth(scene);
    return scene;
  });
}

}  // namespace rasterdiff::families
