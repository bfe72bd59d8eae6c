// Lays planes out over attachments and passes.
#include "vkref/plan.hpp"

#include <algorithm>

#include "scene/built_ins.hpp"
#include "scene/needs.hpp"
#include "scene/primitive_class.hpp"

namespace rasterdiff::vkref {
namespace {

/// A pass without planes of its own yet.
PassPlan newPass(const RenderPlan& plan) {
  PassPlan pass;
  if (plan.alphaFirst) {
    pass.attachments.push_back(kFirstVarying);
    pass.varyings.push_back(0);
  }
  return pass;
}

bool observes(const Scene& scene, BuiltIn builtIn) {
  return std::find(scene.builtIns.begin(), scene.builtIns.end(), builtIn) != scene.builtIns.end();
}

}  // namespace

RenderPlan planOf(const Scene& scene, const Capabilities& caps) {
  const SceneNeeds needs = needsOf(scene);
  RenderPlan plan;
  plan.width = scene.target.width;
  plan.height = scene.target.height;
  plan.samples = scene.target.samples;
  plan.varyings = needs.varyings;
  if (needs.depth) plan.depth = static_cast<VkFormat>(*scene.target.depthFormat);
  plan.resolve = needs.resolve;
  if (scene.target.depthResolveMode) plan.depthResolve = static_cast<VkResolveModeFlagBits>(*scene.target.depthResolveMode);
  // [vk:fragops-covg] alpha to coverage takes the alpha of location 0, smooth lines change it.
  const bool smooth = drawsLines(scene.state) && scene.state.lineRasterizationMode == LineRasterizationMode::RECTANGULAR_SMOOTH;
  plan.alphaFirst = scene.state.alphaToCoverageEnable ||
                    (smooth && needs.varyings > 0 && scene.draws.front().varyings.front().components == 4);
  // [vk:primsrast-sampleshading] one shader that reads either built-in runs for every sample; so do all our passes.
  plan.sampleShading = observes(scene, BuiltIn::SampleId) || observes(scene, BuiltIn::SamplePosition);
  plan.viewportIndex = !scene.furtherViewports.empty() && caps.core().multiViewport &&
                       caps.features.vulkan12.shaderOutputViewportIndex &&
                       scene.furtherViewports.size() < caps.vk.maxViewports;
  plan.color = {{kPrimitiveFormat, 1}, {kCountFormat, 1}};
  for (uint32_t v = 0; v < needs.varyings; ++v) {
    const uint32_t components = scene.draws.front().varyings[v].components;
    plan.color.push_back({varyingFormat(components), components});
  }

  const uint32_t perPass = std::min(caps.vk.maxColorAttachments, caps.vk.maxFragmentOutputAttachments);
  PassPlan pass = newPass(plan);
  pass.primitives = true;
  pass.attachments.insert(pass.attachments.end(), {0, 1});
  for (uint32_t v = plan.alphaFirst ? 1 : 0; v < needs.varyings; ++v) {
    if (pass.attachments.size() == perPass || pass.varyings.size() == kMaxVaryingsPerPass) {
      plan.passes.push_back(std::move(pass));
      pass = newPass(plan);
    }
    pass.attachments.push_back(kFirstVarying + v);
    pass.varyings.push_back(v);
  }
  plan.passes.push_back(std::move(pass));
  for (const BuiltIn builtIn : scene.builtIns) {
    PassPlan own = newPass(plan);
    own.builtIn = builtIn;
    own.attachments.push_back(static_cast<uint32_t>(plan.color.size()));
    plan.color.push_back({varyingFormat(builtInComponents(builtIn)), builtInComponents(builtIn)});
    plan.passes.push_back(std::move(own));
  }
  return plan;
}

bool resolves(const RenderPlan& plan, const PassPlan& pass, size_t output) {
  const uint32_t attachment = pass.attachments[output];
  const bool varying = attachment >= kFirstVarying && attachment < kFirstVarying + plan.varyings;
  const bool again = plan.alphaFirst && output == 0 && !pass.primitives;
  return plan.resolve && varying && !again;
}

}  // namespace rasterdiff::vkref
