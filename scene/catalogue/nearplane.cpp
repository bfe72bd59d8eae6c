// Triangles that reach behind the eye: w = 0, w < 0, and everything that is projected from there.
#include "scene/catalogue/build.hpp"

namespace rasterdiff::families {
namespace {

Scene clipped(std::vector<ClipPosition> vertices, uint32_t samples = 1) {
  Scene scene = square(64, samples);
  drawClip(scene, std::move(vertices));
  return scene;
}

/// A ground plane below an eye at the origin that looks along +w: w is the distance, near is w = 1/8.
Scene ground(uint32_t samples, int cells) {
  Scene scene = square(64, samples);
  std::vector<ClipPosition> v;
  for (int z = 0; z <= cells; ++z) {
    for (int x = 0; x <= cells; ++x) {
      const float w = -1.0f + 8.0f * static_cast<float>(z) / static_cast<float>(cells);
      v.push_back({8.0f * static_cast<float>(x) / static_cast<float>(cells) - 4.0f, 0.75f, w - 0.125f, w});
    }
  }
  Draw& plane = drawClip(scene, std::move(v));
  std::vector<uint32_t>& indices = plane.indices.emplace();
  const auto row = static_cast<uint32_t>(cells + 1);
  for (uint32_t z = 0; z + 1 < row; ++z) {
    for (uint32_t x = 0; x + 1 < row; ++x) {
      const uint32_t a = z * row + x;
      for (uint32_t i : {a, a + row, a + 1, a + 1, a + row, a + row + 1}) indices.push_back(i);
    }
  }
  return scene;
}

}  // namespace

void addNearPlane(Entries& entries) {
  Family family(entries, "nearplane");
  const std::vector<std::string> rules{"R1", "R3"};
  family.add("one-behind", "one vertex behind the eye leaves two pieces", rules, [] {
    return clipped({{-1, 0.5f, 0.5f, 2}, {1, 0.75f, 0.5f, 2}, {0.25f, -0.5f, -1, -1}});
  });
  family.add("two-behind", "two vertices behind the eye leave one piece", rules, [] {
    return clipped({{-0.25f, -1, 0.5f, 2}, {1, 0.75f, -1, -1}, {-1, 0.5f, -0.5f, -0.5f}});
  });
  family.add("three-behind", "a triangle wholly behind the eye is not mirrored into the picture", rules, [] {
    return clipped({{-0.5f, 0.5f, -0.5f, -1}, {0.5f, 0.5f, -0.5f, -1}, {0, -0.5f, -0.5f, -2}});
  });
  family.add("w-zero", "a vertex with w = 0 is a direction", rules, [] {
    return clipped({{-0.5f, 0.5f, 0.5f, 1}, {0.5f, 0.5f, 0.5f, 1}, {0.125f, -1, 0, 0}});
  });
  family.add("w-zero-origin", "a vertex (0, 0, 0, 0) is nowhere; nothing breaks", rules, [] {
    return clipped({{-0.5f, 0.5f, 0.5f, 1}, {0.5f, 0.5f, 0.5f, 1}, {0, 0, 0, 0}});
  });
  family.add("through-the-eye", "an edge through the eye, without depth clipping: where it is cut, nothing can be divided", {"R1", "R3", "R4"}, [] {
    Scene scene = square(32);
    drawClip(scene, {{-0.875f, 0.5625f, 0.5f, 1.25f}, {-1.5f, 1.5f, 0.5f, 1.5f}, {0.5f, -0.5f, 0.25f, -0.5f}});
    scene.state.depthClampEnable = true;
    return scene;
  });
  family.add("w-tiny", "w next to 0 with huge quotients", rules, [] {
    return clipped({{-0.5f, 0.5f, 0.5f, 1}, {0.5f, 0.5f, 0.5f, 1}, {0.001f, -1, 0, 1e-6f}});
  });
  family.add("on-plane", "vertices exactly on z = 0 are inside", rules, [] {
    return clipped({{-0.5f, 0.5f, 0, 1}, {0.5f, 0.5f, 0, 1}, {0, -0.5f, 0, 1}});
  });
  family.add("just-outside", "a depth one denormal below 0 is outside of the volume", rules, [] {
    return clipped({{-0.5f, 0.5f, 0.5f, 1}, {0.5f, 0.5f, 0.5f, 1}, {0, -0.5f, -1e-40f, 1}});
  });
  family.add("ground-1x", "a ground plane runs under the eye and behind it", {"R1", "R3", "R15"},
             [] { return ground(1, 1); });
  family.add("ground-4x", "a ground plane at four samples", {"R1", "R3", "R15"}, [] { return ground(4, 1); });
  family.add("ground-lattice", "a lattice crosses the near plane without seams", {"R1", "R3", "R15"},
             [] { return ground(4, 8); });
  family.add("ground-values", "values and depth on a ground plane that crosses the near plane",
             {"R3", "R9", "R21", "R22"}, [] {
               Scene scene = ground(1, 2);
               useDepth(scene);
               addVarying(scene, "smooth", Interpolation::smooth, 3);
               addVarying(scene, "screen", Interpolation::noperspective, 2);
               return scene;
             });
  family.add("behind-values", "depth of a triangle whose vertex behind the eye is mirrored to just beside the other two",
             {"R3", "R10", "R22"}, [] {
               Scene scene = clipped({{-0.21f, -0.63f, 0.5f, 1}, {0.23f, -0.66f, 0.75f, 1}, {0.02f, 0.73f, -0.5f, -1}});
               useDepth(scene);
               return scene;
             });
}

}  // namespace rasterdiff::families
