// Which side of a triangle is seen, and what culling does with it. [vk:primsrast-polygons-basic]
#include "scene/catalogue/build.hpp"

namespace rasterdiff::families {
namespace {

constexpr const char* kFacingSign = "https://github.com/KhronosGroup/Vulkan-Docs/issues/320";

/// One triangle of each winding (clockwise on the screen left), and two of zero area.
Scene windings(CullMode cull, FrontFace front) {
  Scene scene = square(32);
  scene.state.cullMode = cull;
  scene.state.frontFace = front;
  draw(scene, {{4.5, 4.5},
               {14.5, 4.5},
               {4.5, 20.5},
               {18.5, 4.5},
               {18.5, 20.5},
               {28.5, 4.5},
               {4.5, 24.5},
               {28.5, 24.5},
               {16.5, 24.5},
               {4.5, 28.5},
               {4.5, 28.5},
               {16.5, 30.5}});
  return scene;
}

/// One vertex behind the eye: seen from the screen the visible part is what is left after clipping.
Scene behindEye(CullMode cull) {
  Scene scene = square(64);
  scene.state.cullMode = cull;
  drawClip(scene, {{-0.5f, 0.5f, 0.5f, 1}, {0.5f, 0.5f, 0.5f, 1}, {0.25f, -0.5f, -0.5f, -0.5f}});
  drawClip(scene, {{-0.5f, -0.5f, 0.5f, 1}, {0.5f, -0.5f, 0.5f, 1}, {0.25f, 0.5f, -0.5f, -0.5f}});
  return scene;
}

}  // namespace

void addFacing(Entries& entries) {
  Family family(entries, "facing");
  const std::vector<std::string> rules{"R12", "R13"};
  family.add("cull-none", "without culling both windings are drawn", rules,
             [] { return windings(CullMode::NONE, FrontFace::COUNTER_CLOCKWISE); });
  family.add(
      "cull-back-ccw", "only counter-clockwise triangles are left", rules,
      [] { return windings(CullMode::BACK, FrontFace::COUNTER_CLOCKWISE); }, kFacingSign);
  family.add(
      "cull-back-cw", "only clockwise triangles are left", rules,
      [] { return windings(CullMode::BACK, FrontFace::CLOCKWISE); }, kFacingSign);
  family.add("cull-front-ccw", "only clockwise triangles are left", rules,
             [] { return windings(CullMode::FRONT, FrontFace::COUNTER_CLOCKWISE); });
  family.add("cull-front-cw", "only counter-clockwise triangles are left", rules,
             [] { return windings(CullMode::FRONT, FrontFace::CLOCKWISE); });
  family.add("cull-both", "nothing is left", rules,
             [] { return windings(CullMode::FRONT_AND_BACK, FrontFace::COUNTER_CLOCKWISE); });
  family.add("negative-height", "a viewport of negative height turns every winding round", {"R2", "R12", "R13"}, [] {
    Scene scene = square(32);
    scene.state.cullMode = CullMode::BACK;
    drawClip(scene, {{-0.75f, -0.75f, 0.5f, 1},
                     {-0.125f, -0.75f, 0.5f, 1},
                     {-0.75f, 0.5f, 0.5f, 1},
                     {0.125f, -0.75f, 0.5f, 1},
                     {0.125f, 0.5f, 0.5f, 1},
                     {0.75f, -0.75f, 0.5f, 1}});
    scene.viewport = {0, 32, 32, -32, 0, 1};
    return scene;
  });
  family.add(
      "behind-eye-back", "a vertex with w < 0: facing is that of the visible part", {"R3", "R12", "R13"},
      [] { return behindEye(CullMode::BACK); }, kFacingSign);
  family.add(
      "behind-eye-front", "a vertex with w < 0: facing is that of the visible part", {"R3", "R12", "R13"},
      [] { return behindEye(CullMode::FRONT); }, kFacingSign);
  family.add("clipped-pieces", "all pieces of a clipped triangle face the way it does", {"R3", "R12", "R13"}, [] {
    Scene scene = square(64);
    scene.state.cullMode = CullMode::BACK;
    scene.state.frontFace = FrontFace::CLOCKWISE;
    drawClip(scene, {{-1.5f, -0.5f, 0.5f, 1}, {1.5f, -1.25f, 0.5f, 1}, {0.25f, 1.75f, 0.5f, 1}});
    return scene;
  });
  family.add("mixed-grid", "thirty-two triangles of alternating winding on one grid", rules, [] {
    Scene scene = square(64);
    scene.state.cullMode = CullMode::BACK;
    std::vector<Px> v;
    for (int i = 0; i < 32; ++i) {
      const double x = 2.5 + 8 * (i % 8), y = 2.5 + 16 * (i / 8);
      Px a{x + 5, y + (i % 3)}, b{x + (i % 5), y + 12};
      if (i % 2 == 1) std::swap(a, b);
      v.insert(v.end(), {{x, y}, a, b});
    }
    draw(scene, v);
    return scene;
  });
}

}  // namespace rasterdiff::families
