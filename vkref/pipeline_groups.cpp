#include "vkref/pipeline_groups.hpp"

#include <vector>

#include "vkref/pipeline_key.hpp"

namespace rasterdiff::vkref {
namespace {

/// What most devices offer.
Capabilities usualCapabilities() {
  Capabilities caps;
  caps.vk.maxColorAttachments = caps.vk.maxFragmentOutputAttachments = 8;
  caps.vk.maxViewports = 16;
  caps.features.core.features.geometryShader = caps.features.core.features.multiViewport = VK_TRUE;
  caps.features.vulkan12.shaderOutputViewportIndex = VK_TRUE;
  return caps;
}

}  // namespace

struct PipelineGroups::Known {
  Capabilities caps = usualCapabilities();
  std::map<std::vector<PipelineKey>, size_t> groups;
};

PipelineGroups::PipelineGroups() : known_(std::make_unique<Known>()) {}
PipelineGroups::~PipelineGroups() = default;

size_t PipelineGroups::of(const Scene& scene) {
  std::vector<PipelineKey> keys;
  const RenderPlan plan = planOf(scene, known_->caps);
  for (const PassPlan& pass : plan.passes) keys.push_back(pipelineKey(scene, plan, pass, PrimitiveSource::Builtin));
  return known_->groups.try_emplace(std::move(keys), known_->groups.size()).first->second;
}

}  // namespace rasterdiff::vkref
