// Lays planes out over attachments and passes.
#include "vkref/plan.hpp"

#include <algorithm>

#include "scene/needs.hpp"

namespace rasterdiff::vkref {

RenderPlan planOf(const Scene& scene, const Capabilities& caps) {
  const SceneNeeds needs = needsOf(scene);
  RenderPlan plan;
  plan.width = scene.target.width;
  plan.height = scene.target.height;
  plan.samples = scene.target.samples;
  plan.depth = needs.depth;
  plan.color = {{kPrimitiveFormat, 1}, {kCountFormat, 1}};
  for (uint32_t v = 0; v < needs.varyings; ++v) {
    const uint32_t components = scene.draws.front().varyings[v].components;
    plan.color.push_back({varyingFormat(components), components});
  }

  const uint32_t perPass = std::min(caps.vk.maxColorAttachments, caps.vk.maxFragmentOutputAttachments);
  PassPlan pass{0, 2, 0, 0, true};
  for (;;) {
    const uint32_t room = std::min(perPass - pass.attachments, kMaxVaryingsPerPass);
    pass.varyings = std::min(room, needs.varyings - pass.firstVarying);
    pass.attachments += pass.varyings;
    plan.passes.push_back(pass);
    const uint32_t next = pass.firstVarying + pass.varyings;
    if (next == needs.varyings) return plan;
    pass = {2 + next, 0, next, 0, false};
  }
}

}  // namespace rasterdiff::vkref
