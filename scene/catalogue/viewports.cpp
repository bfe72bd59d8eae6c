// Several viewports and scissors in one scene: each draw goes through its own. [vk:vertexpostproc-viewport]
#include "scene/catalogue/build.hpp"

namespace rasterdiff::families {
namespace {

/// The same clip-space triangle through every viewport.
Scene through(const Viewport& first, std::vector<ViewportAndScissor> further, uint32_t samples = 1) {
  Scene scene = square(64, samples);
  scene.viewport = first;
  scene.furtherViewports = std::move(further);
  for (uint32_t i = 0; i <= scene.furtherViewports.size(); ++i) {
    drawClip(scene, {{-0.875f, -0.75f, 0.25f, 1}, {0.75f, -0.5f, 0.5f, 1}, {-0.25f, 0.875f, 0.75f, 1}}).viewportIndex = i;
  }
  return scene;
}

}  // namespace

void addViewports(Entries& entries) {
  Family family(entries, "viewports");
  const std::vector<std::string> rules{"R2"};
  family.add("quarters", "a triangle in each quarter of the target", rules, [] {
    return through({0, 0, 32, 32, 0, 1}, {{{32, 0, 32, 32, 0, 1}, {}}, {{0, 32, 32, 32, 0, 1}, {}}, {{32, 32, 32, 32, 0, 1}, {}}}, 4);
  });
  family.add("scissors", "each viewport has its own scissor, or the whole target", {"R2", "R39"}, [] {
    return through({0, 0, 64, 64, 0, 1}, {{{8, 8, 48, 48, 0, 1}, Rect2D{10, 12, 16, 20}}, {{0, 0, 64, 64, 0, 1}, Rect2D{40, 4, 9, 50}}});
  });
  family.add("flipped", "one viewport is upside down", rules, [] {
    return through({0, 0, 32, 64, 0, 1}, {{{32, 64, 32, -64, 0, 1}, {}}});
  });
  family.add("depth-ranges", "each viewport has its own depth range, one reversed", {"R2", "R22", "R38"}, [] {
    Scene scene = through({0, 0, 40, 64, 0, 0.5f}, {{{12, 0, 40, 64, 1, 0}, {}}, {{24, 0, 40, 64, 0.25f, 0.25f}, {}}});
    useDepth(scene);
    return scene;
  });
  family.add("sixteen", "as many as a device with several has to offer", rules, [] {
    std::vector<ViewportAndScissor> further;
    for (int i = 1; i < 16; ++i) {
      further.push_back({{16.0f * static_cast<float>(i % 4), 16.0f * static_cast<float>(i / 4) + 0.25f, 16, 15.5f, 0, 1}, {}});
    }
    return through({0, 0, 16, 16, 0, 1}, std::move(further));
  });
  family.add("volume-ends", "what leaves viewport 1 is not drawn into viewport 0", {"R2", "R3"}, [] {
    Scene scene = square(64);
    scene.furtherViewports = {{{16, 16, 24, 24, 0, 1}, {}}};
    drawClip(scene, {{-3, -0.25f, 0.5f, 1}, {3, -0.25f, 0.5f, 1}, {0, 3, 0.5f, 1}}).viewportIndex = 1;
    return scene;
  });
}

}  // namespace rasterdiff::families
