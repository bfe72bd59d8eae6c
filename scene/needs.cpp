#include "scene/needs.hpp"

#include <algorithm>

namespace rasterdiff {
namespace {

/// [vk:vertexpostproc-clipping] NaN is inside of nothing.
bool insideViewVolume(const ClipPosition& p, const State& state) {
  const float zMin = state.negativeOneToOne ? -p.w : 0.0f;
  const bool depthClip = state.depthClipEnable.value_or(!state.depthClampEnable);
  return p.x >= -p.w && p.x <= p.w && p.y >= -p.w && p.y <= p.w && (!depthClip || (p.z >= zMin && p.z <= p.w));
}

}  // namespace

SceneNeeds needsOf(const Scene& scene) {
  SceneNeeds needs;
  needs.depth = scene.target.depthFormat.has_value();
  needs.varyings = scene.draws.empty() ? 0 : static_cast<uint32_t>(scene.draws.front().varyings.size());
  needs.builtIns = static_cast<uint32_t>(scene.builtIns.size());
  needs.resolve = scene.target.resolve;
  needs.samples = scene.target.samples;
  return needs;
}

bool needsPerspective(const Scene& scene) {
  return std::ranges::any_of(scene.draws, [](const Draw& draw) {
    return std::ranges::any_of(draw.positions, [](const ClipPosition& p) { return p.w != 1; });
  });
}

bool needsClipping(const Scene& scene) {
  return std::ranges::any_of(scene.draws, [&](const Draw& draw) {
    return !std::ranges::all_of(draw.positions, [&](const ClipPosition& p) { return insideViewVolume(p, scene.state); }) ||
           !std::ranges::all_of(draw.clipDistances, [](float d) { return d >= 0; });
  });
}

}  // namespace rasterdiff
