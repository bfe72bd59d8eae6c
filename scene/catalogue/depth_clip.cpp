// Depth clipping and depth clamping, alone and together. [vk:vertexpostproc-clipping] [vk:fragops-depth]
#include "scene/catalogue/build.hpp"

namespace rasterdiff::families {
namespace {

/// A slope from far before the near plane to far behind the far plane.
Scene beyond(bool clamp, std::optional<bool> clip, const Viewport& range = {0, 0, 64, 64, 0, 1}) {
  Scene scene = square(64);
  scene.viewport = range;
  useDepth(scene, CompareOp::ALWAYS, true, 0.5f);
  scene.state.depthClampEnable = clamp;
  scene.state.depthClipEnable = clip;
  drawClip(scene, {{-0.875f, -0.75f, -1.5f, 1}, {0.875f, -0.5f, 2.5f, 1}, {0, 0.875f, 0.5f, 1}});
  return scene;
}

}  // namespace

void addDepthClip(Entries& entries) {
  Family family(entries, "depth-clip");
  const std::vector<std::string> rules{"R4", "R38"};
  family.add("neither-asked", "by default what lies beyond near and far is cut", rules,
             [] { return beyond(false, std::nullopt); });
  family.add("clamp", "clamping keeps what lies beyond, at the range's ends", rules,
             [] { return beyond(true, std::nullopt); });
  family.add("clip-and-clamp", "cut at the planes although clamped", rules, [] { return beyond(true, true); });
  family.add("clip-only", "asked for by name: the same as the default", rules, [] { return beyond(false, true); });
  family.add("no-clip-no-clamp", "neither cut nor clamped: depths beyond the range are undefined, coverage is not", rules,
             [] { return beyond(false, false); });
  family.add(
      "clamp-reversed", "clamped to a reversed range", {"R2", "R4", "R38"},
      [] { return beyond(true, std::nullopt, {0, 0, 64, 64, 0.75f, 0.25f}); }, issue("KhronosGroup/MoltenVK", 955));
  family.add("clamp-narrow", "clamped to a range inside of 0..1", {"R2", "R4", "R38"},
             [] { return beyond(true, std::nullopt, {0, 0, 64, 64, 0.25f, 0.5f}); });
  family.add("clamp-collapsed", "clamped to one depth", {"R2", "R4", "R38"},
             [] { return beyond(true, std::nullopt, {0, 0, 64, 64, 0.375f, 0.375f}); });
  family.add("clamp-behind-eye", "without the near plane a triangle reaches behind the eye, up to w = 0", {"R3", "R4"}, [] {
    Scene scene = square(64);
    scene.state.depthClampEnable = true;
    drawClip(scene, {{-0.5f, 0.5f, 0.5f, 1}, {0.5f, 0.5f, 0.5f, 1}, {0, -1, -1, -1}});
    return scene;
  });
  family.add("clamp-guard-band", "depths up to 1e30", rules, [] {
    Scene scene = square(64);
    useDepth(scene, CompareOp::ALWAYS, true, 0.5f);
    scene.state.depthClampEnable = true;
    drawClip(scene, {{-0.875f, -0.75f, -1e30f, 1}, {0.875f, -0.5f, 1e30f, 1}, {0, 0.875f, 1e20f, 1}});
    return scene;
  });
  family.add("clamp-negative-one-to-one", "clamped with the view volume -w <= z <= w", {"R2", "R4", "R38"}, [] {
    Scene scene = beyond(true, std::nullopt);
    scene.state.negativeOneToOne = true;
    return scene;
  });
  family.add("clamp-points-lines", "points beyond the planes are kept too", {"R4", "R7", "R25"}, [] {
    Scene scene = square(32);
    useDepth(scene, CompareOp::ALWAYS, true, 0.5f);
    scene.state.depthClampEnable = true;
    usePoints(scene, 5);
    drawClip(scene, {{-0.5f, 0, -0.5f, 1}, {0, 0, 0.25f, 1}, {0.5f, 0, 1.5f, 1}});
    return scene;
  });
}

}  // namespace rasterdiff::families
