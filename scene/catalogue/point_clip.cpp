// Points whose vertex leaves the view volume: discarded, or kept where only user planes clip them, never cut.
// [vk:vertexpostproc-clipping]
#include <cmath>
#include <limits>

#include "scene/catalogue/build.hpp"

namespace rasterdiff::families {
namespace {

Scene points(float size, std::vector<ClipPosition> vertices) {
  Scene scene = square(64);
  usePoints(scene, size);
  drawClip(scene, std::move(vertices));
  return scene;
}

/// At a plane, one ulp before it and one behind, for each of the four sides.
std::vector<ClipPosition> aroundSides() {
  const float above = std::nextafter(1.0f, 2.0f), below = std::nextafter(1.0f, 0.0f);
  std::vector<ClipPosition> v;
  float along = -0.75f;
  for (float at : {below, 1.0f, above}) {
    v.insert(v.end(), {{at, along, 0.5f, 1}, {-at, along, 0.5f, 1}, {along, at, 0.5f, 1}, {along, -at, 0.5f, 1}});
    along += 0.5f;
  }
  return v;
}

}  // namespace

void addPointClip(Entries& entries) {
  Family family(entries, "point-clip");
  const std::vector<std::string> rules{"R7", "R25"};
  family.add(
      "sides-one-ulp", "large points at each side, one ulp before and behind it", rules,
      [] { return points(8, aroundSides()); }, issue("KhronosGroup/OpenGL-Registry", 627));
  family.add(
      "far-outside", "a large point whose square reaches in, its vertex 4 pixels outside", rules,
      [] {
        return points(16, {{1.125f, 0, 0.5f, 1}, {-1.125f, 0.5f, 0.5f, 1}, {0.25f, 1.125f, 0.5f, 1}, {0, -1.125f, 0.5f, 1}});
      },
      issue("gpuweb/gpuweb", 263));
  family.add(
      "near-far", "depth before, on and behind the near and the far plane", rules,
      [] {
        const float above = std::nextafter(1.0f, 2.0f), below = -std::numeric_limits<float>::min();  // denormals may be flushed
        return points(5, {{-0.75f, -0.5f, 0, 1},
                          {-0.25f, -0.5f, below, 1},
                          {0.25f, -0.5f, -0.25f, 1},
                          {-0.75f, 0.5f, 1, 1},
                          {-0.25f, 0.5f, above, 1},
                          {0.25f, 0.5f, 1.25f, 1}});
      },
      issue("KhronosGroup/Vulkan-Docs", 113));
  family.add("behind-eye", "vertices with w of 0 and below", rules, [] {
    return points(5, {{0.25f, 0.25f, -0.5f, -1}, {0.5f, 0, 0.5f, 0}, {0, 0, 0.5f, 1}});
  });
  family.add("inside-reaching-out", "the vertex is inside: the square is drawn as far as the target goes", rules, [] {
    return points(12, {{0.96875f, 0.96875f, 0.5f, 1}, {-0.96875f, 0, 0.5f, 1}, {0, -1, 0.5f, 1}});
  });
  family.add("user-plane", "a negative clip distance discards the whole point, zero keeps it", {"R5", "R7", "R25"}, [] {
    Scene scene = points(7, {{-0.5f, 0, 0.5f, 1}, {0, 0, 0.5f, 1}, {0.5f, 0, 0.5f, 1}});
    scene.draws[0].clipDistanceCount = 1;
    scene.draws[0].clipDistances = {-0.001f, 0, 0.001f};
    return scene;
  });
}

}  // namespace rasterdiff::families
