// Seeded random primitives under random viewports, and with depth in each format, tested, biased and clamped.
#include "scene/catalogue/random_primitives.hpp"
#include "scene/generators/random_state.hpp"

namespace rasterdiff::families {
namespace {

constexpr uint32_t kPrimitives = 100;
using LineMode = LineRasterizationMode;

void addViewportFamilies(Entries& entries, uint64_t& seed) {
  Family family(entries, "random-viewport");
  const auto add = [&](const char* name, std::vector<std::string> rules, std::function<Scene(uint64_t, uint32_t)> make) {
    family.addRandom(name, "a viewport of any place, size and direction", std::move(rules), ++seed, kPrimitives,
                     [make = std::move(make)](uint64_t s, uint32_t n) {
                       Scene scene = make(s, n);
                       giveViewport(scene, s);
                       return scene;
                     });
  };
  add("triangles-1x", {"R2", "R14"}, [](uint64_t s, uint32_t n) { return someTriangles(s, n, 1); });
  add("triangles-4x", {"R2", "R14"}, [](uint64_t s, uint32_t n) { return someTriangles(s, n, 4, true); });
  add("lines-1x", {"R2", "R27"}, [](uint64_t s, uint32_t n) { return someLines(s, n, 1); });
  add("bresenham-1x", {"R2", "R29"}, [](uint64_t s, uint32_t n) { return someLines(s, n, 1, LineMode::BRESENHAM); });
  add("points-4x", {"R2", "R25"}, [](uint64_t s, uint32_t n) { return somePoints(s, n, 4); });
  add("facing-1x", {"R2", "R12", "R13"}, [](uint64_t s, uint32_t n) {
    Scene scene = someTriangles(s, n, 1);
    giveCulling(scene, s);
    return scene;
  });
}

void addFormats(Entries& entries, uint64_t& seed) {
  Family family(entries, "random-depth");
  struct Kind {
    const char* name;
    DepthFormat format;
    uint32_t samples;
    bool biased;
  };
  using enum DepthFormat;
  for (const Kind& kind :
       {Kind{"d16-1x", D16_UNORM, 1, false}, Kind{"d16-4x", D16_UNORM, 4, false}, Kind{"d24-1x", X8_D24_UNORM_PACK32, 1, false},
        Kind{"d24s8-4x", D24_UNORM_S8_UINT, 4, false}, Kind{"d32-1x", D32_SFLOAT, 1, false},
        Kind{"d32-4x", D32_SFLOAT, 4, false}, Kind{"bias-d16-1x", D16_UNORM, 1, true},
        Kind{"bias-d24-1x", X8_D24_UNORM_PACK32, 1, true}, Kind{"bias-d32-1x", D32_SFLOAT, 1, true}}) {
    std::vector<std::string> rules{"R22", "R38", "R50"};
    if (kind.biased) rules.insert(rules.end(), {"R35", "R36", "R37"});
    family.addRandom(kind.name, "triangles that pass through each other, tested and written", std::move(rules), ++seed,
                     kPrimitives, [kind](uint64_t s, uint32_t n) {
                       Scene scene = someTriangles(s, n, kind.samples, kind.samples == 4);
                       giveDepth(scene, s, kind.format);
                       if (kind.biased) giveDepthBias(scene, s);
                       return scene;
                     });
  }
  family.addRandom("clamped-1x", "depth outside of its range is clamped", {"R4", "R22", "R38"}, ++seed, kPrimitives,
                   [](uint64_t s, uint32_t n) {
                     Scene scene = someTriangles(s, n, 1);
                     giveDepth(scene, s, D32_SFLOAT);
                     leaveDepthRange(scene, s);
                     scene.state.depthClampEnable = true;
                     return scene;
                   });
  family.addRandom("lines-1x", "depth along lines", {"R22", "R27", "R38"}, ++seed, kPrimitives, [](uint64_t s, uint32_t n) {
    Scene scene = someLines(s, n, 1);
    giveDepth(scene, s, D32_SFLOAT);
    return scene;
  });
}

}  // namespace

void addRandomDepth(Entries& entries) {
  uint64_t seed = 7000;
  addViewportFamilies(entries, seed);
  addFormats(entries, seed);
}

}  // namespace rasterdiff::families
