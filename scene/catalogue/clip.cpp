// The sides of the view volume: rejection, cutting into smaller triangles, vertices exactly on a plane.
#include <fmt/format.h>

#include "scene/catalogue/build.hpp"

namespace rasterdiff::families {
namespace {

using Triangle = std::vector<ClipPosition>;

Scene clipped(const Triangle& vertices, uint32_t samples = 1) {
  Scene scene = square(64, samples);
  drawClip(scene, vertices);
  return scene;
}

/// A lattice of 6 × 6 cells from -1.5 to 1.5: every side and corner of the volume cuts shared edges.
Scene straddlingLattice(uint32_t samples) {
  Scene scene = square(64, samples);
  Triangle vertices;
  for (int y = 0; y <= 6; ++y) {
    for (int x = 0; x <= 6; ++x) {
      vertices.push_back({static_cast<float>(x) * 0.5f - 1.53125f, static_cast<float>(y) * 0.5f - 1.46875f,
                          static_cast<float>(x + y) * 0.15f - 0.4f, 1});
    }
  }
  Draw& lattice = drawClip(scene, vertices);
  std::vector<uint32_t>& indices = lattice.indices.emplace();
  for (uint32_t y = 0; y < 6; ++y) {
    for (uint32_t x = 0; x < 6; ++x) {
      const uint32_t a = y * 7 + x;
      for (uint32_t i : {a, a + 1, a + 8, a, a + 8, a + 7}) indices.push_back(i);
    }
  }
  return scene;
}

}  // namespace

void addClip(Entries& entries) {
  Family family(entries, "clip");
  const std::vector<std::string> rules{"R3"};
  family.add("left", "a vertex beyond x = -w", rules, [] {
    return clipped({{-1.75f, -0.25f, 0.5f, 1}, {0.75f, -0.75f, 0.5f, 1}, {0.5f, 0.875f, 0.5f, 1}});
  });
  family.add("right", "a vertex beyond x = w", rules, [] {
    return clipped({{1.75f, -0.25f, 0.5f, 1}, {-0.75f, -0.75f, 0.5f, 1}, {-0.5f, 0.875f, 0.5f, 1}});
  });
  family.add("top", "a vertex beyond y = -w", rules, [] {
    return clipped({{-0.25f, -1.75f, 0.5f, 1}, {-0.75f, 0.75f, 0.5f, 1}, {0.875f, 0.5f, 0.5f, 1}});
  });
  family.add("bottom", "a vertex beyond y = w", rules, [] {
    return clipped({{-0.25f, 1.75f, 0.5f, 1}, {-0.75f, -0.75f, 0.5f, 1}, {0.875f, -0.5f, 0.5f, 1}});
  });
  family.add("near", "a vertex beyond z = 0", rules, [] {
    return clipped({{-0.25f, 0.75f, -0.75f, 1}, {-0.75f, -0.75f, 0.5f, 1}, {0.875f, -0.5f, 0.25f, 1}});
  });
  family.add("far", "a vertex beyond z = w", rules, [] {
    return clipped({{-0.25f, 0.75f, 1.75f, 1}, {-0.75f, -0.75f, 0.5f, 1}, {0.875f, -0.5f, 0.25f, 1}});
  });
  family.add("two-vertices-out", "two vertices beyond the same side leave a triangle", rules, [] {
    return clipped({{-1.75f, -0.25f, 0.5f, 1}, {-1.25f, 0.75f, 0.5f, 1}, {0.5f, 0.875f, 0.5f, 1}});
  });
  family.add("corner", "a corner of the volume is inside the triangle", rules, [] {
    return clipped({{-1.5f, -0.5f, 0.5f, 1}, {0.25f, -2.5f, 0.5f, 1}, {0.75f, 0.75f, 0.5f, 1}}, 4);
  });
  family.add("all-six", "a triangle is cut by every plane", rules, [] {
    return clipped({{-3, -2, -1.5f, 1}, {3, -1.75f, 0.5f, 1}, {0.25f, 3, 2.5f, 1}}, 4);
  });
  family.add("all-out-yet-visible", "all vertices are outside but the triangle covers the target", rules, [] {
    return clipped({{-4, -4, 0.5f, 1}, {8, -4, 0.5f, 1}, {-4, 8, 0.5f, 1}});
  });
  family.add("rejected", "triangles wholly beyond each of the six planes draw nothing", rules, [] {
    return clipped({{-1.5f, -0.5f, 0.5f, 1},
                    {-1.25f, 0.5f, 0.5f, 1},
                    {-3, 0, 0.5f, 1},
                    {1.5f, -0.5f, 0.5f, 1},
                    {1.25f, 0.5f, 0.5f, 1},
                    {3, 0, 0.5f, 1},
                    {-0.5f, -1.5f, 0.5f, 1},
                    {0.5f, -1.25f, 0.5f, 1},
                    {0, -3, 0.5f, 1},
                    {-0.5f, 1.5f, 0.5f, 1},
                    {0.5f, 1.25f, 0.5f, 1},
                    {0, 3, 0.5f, 1},
                    {-0.5f, -0.5f, -0.5f, 1},
                    {0.5f, -0.5f, -0.25f, 1},
                    {0, 0.5f, -1, 1},
                    {-0.5f, -0.5f, 1.5f, 1},
                    {0.5f, -0.5f, 1.25f, 1},
                    {0, 0.5f, 2, 1}});
  });
  family.add("rejected-by-two", "outside of two planes together, of none alone: nothing is visible", rules, [] {
    return clipped({{-2.5f, 0.5f, 0.5f, 1}, {-0.5f, 2.5f, 0.5f, 1}, {-2, 2, 0.5f, 1}});
  });
  family.add("on-planes", "vertices and edges exactly on the planes are inside", rules, [] {
    return clipped({{-1, -1, 0, 1}, {1, -1, 1, 1}, {-1, 1, 0, 1}, {1, 1, 1, 1}, {-1, 1, 0, 1}, {1, -1, 1, 1}});
  });
  family.add("touching-from-outside", "an edge lies on a plane, the rest is outside: nothing is covered", rules, [] {
    return clipped({{-1, -0.5f, 0.5f, 1}, {-1, 0.5f, 0.5f, 1}, {-2, 0, 0.5f, 1}});
  });
  family.add("one-ulp-outside", "a vertex one ulp beyond the plane: cut or not, the picture is the same", rules, [] {
    return clipped({{-1.0000001f, -0.75f, 0.5f, 1}, {0.75f, -1.0000001f, 0.5f, 1}, {0.5f, 0.875f, 0.5f, 1}});
  });
  for (const float far : {1e3f, 1e6f, 1e12f, 1e30f}) {
    family.add(fmt::format("guard-band-{:.0e}", far), "vertices this far outside, in every direction: within a guard band or beyond any", rules, [far] {
      return clipped({{-0.75f, -0.5f, 0.5f, 1},     {far, -0.75f, 0.5f, 1},        {-0.5f, -0.625f, 0.5f, 1},
                      {0.75f, 0.5f, 0.5f, 1},       {-far, 0.625f, 0.5f, 1},       {0.5f, 0.4375f, 0.5f, 1},
                      {0.125f, 0.8125f, 0.5f, 1},   {0.25f, far, 0.5f, 1},         {-0.125f, 0.75f, 0.5f, 1},
                      {-0.25f, -0.25f, 0.5f, 1},    {-far, -far, 0.5f, 1},         {-0.375f, -0.25f, 0.5f, 1},
                      {0.25f, 0.125f, 0.5f, 1},     {far, -far * 0.5f, 0.5f, 1},   {far, -far * 0.4375f, 0.5f, 1},
                      {-far, far * 0.75f, 0.5f, 1}, {far, -far * 0.5f, 0.5f, 1},   {0.0625f, 0, 0.5f, 1},
                      {-far, -far, 0.5f, 1},        {far * 0.5f, -far, 0.5f, far}, {-far, far, 0.5f, far * 2}});
    });
  }
  family.add("guard-band-whole", "triangles that hold the whole target, however large", rules, [] {
    std::vector<ClipPosition> v;
    for (const float far : {4.0f, 1e3f, 1e6f, 1e12f, 1e30f}) v.insert(v.end(), {{-far, -far, 0.5f, 1}, {far * 3, -far, 0.5f, 1}, {-far, far * 3, 0.5f, 1}});
    return clipped(v);
  });
  family.add("shared-edges-1x", "clipping a lattice opens no seam and draws nothing twice", {"R3", "R15"},
             [] { return straddlingLattice(1); });
  family.add("shared-edges-4x", "clipping a lattice at four samples", {"R3", "R15"},
             [] { return straddlingLattice(4); });
  family.add("homogeneous", "different w on the clipped edge: the cut is in clip space, not on the screen", rules, [] {
    return clipped({{-3.5f, -1, 1, 2}, {2, -3, 2, 4}, {0.25f, 0.375f, 0.25f, 0.5f}});
  });
  family.add("negative-one-to-one", "with negativeOneToOne the near plane is z = -w", rules, [] {
    Scene scene = clipped({{-0.75f, -0.75f, -0.75f, 1}, {0.75f, -0.75f, -0.5f, 1}, {0.25f, 0.75f, -1.5f, 1}});
    scene.state.negativeOneToOne = true;
    return scene;
  });
  family.add("varying", "values of cut triangles continue those of the whole", {"R3", "R9", "R10"}, [] {
    Scene scene = clipped({{-2, -0.5f, 0.5f, 1}, {2.5f, -1.5f, 1, 2}, {0.25f, 1.75f, -0.5f, 1}});
    addVarying(scene, "smooth", Interpolation::smooth);
    addVarying(scene, "screen", Interpolation::noperspective, 2);
    addVarying(scene, "flat", Interpolation::flat, 1);
    return scene;
  });
  family.add("strip", "a strip goes out of the volume and back", {"R3", "R11"}, [] {
    Scene scene = square(64);
    scene.state.topology = PrimitiveTopology::TRIANGLE_STRIP;
    Triangle v;
    for (int i = 0; i < 12; ++i) {
      v.push_back({static_cast<float>(i) * 0.25f - 1.375f, i % 2 == 0 ? -0.5f - 0.125f * static_cast<float>(i) : 0.75f,
                   0.5f, 1});
    }
    drawClip(scene, v);
    return scene;
  });
}

}  // namespace rasterdiff::families
