#include "scene/needs.hpp"

namespace rasterdiff {
namespace {

/// [vk:vertexpostproc-clipping] NaN is inside of nothing.
bool insideViewVolume(const ClipPosition& p, bool negativeOneToOne) {
  const float zMin = negativeOneToOne ? -p.w : 0.0f;
  return p.x >= -p.w && p.x <= p.w && p.y >= -p.w && p.y <= p.w && p.z >= zMin && p.z <= p.w;
}

}  // namespace

SceneNeeds needsOf(const Scene& scene) {
  SceneNeeds needs;
  needs.depth = scene.target.depthFormat.has_value();
  needs.varyings = scene.draws.empty() ? 0 : static_cast<uint32_t>(scene.draws.front().varyings.size());
  needs.samples = scene.target.samples;
  for (const Draw& draw : scene.draws) {
    for (const ClipPosition& p : draw.positions) {
      needs.perspective |= p.w != 1;
      needs.clipping |= !insideViewVolume(p, scene.state.negativeOneToOne);
    }
  }
  return needs;
}

}  // namespace rasterdiff
