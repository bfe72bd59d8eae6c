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
  for (const Draw& draw : scene.draws) {
    for (const ClipPosition& p : draw.positions) {
      needs.perspective |= p.w != 1;
      needs.clipping |= !insideViewVolume(p, scene.state);
    }
    needs.clipping |= !std::all_of(draw.clipDistances.begin(), draw.clipDistances.end(), [](float d) { return d >= 0; });
  }
  return needs;
}

}  // namespace rasterdiff
