// Pipelines and descriptors of the unpack shader.
#include "vkref/unpack.hpp"

#include <array>

#include "scene/stopwatch.hpp"
#include "vkref/vk_error.hpp"
#include "vkref/vk_struct.hpp"

namespace rasterdiff::vkref {
namespace {

constexpr uint32_t kSetsPerPool = 16;
constexpr uint32_t kGroupWidth = 16, kGroupHeight = 4;  ///< local size of the shader

struct Band {
  int32_t firstRow = 0, rows = 0, width = 0;
};

}  // namespace

uint32_t unpackedComponents(uint32_t samples, uint32_t components) {
  return samples == 2 && components % 2 == 1 ? components + 1 : components;
}

Result<std::unique_ptr<Unpack>> Unpack::create(const Context& context, VkPipelineCache driverCache) {
  std::unique_ptr<Unpack> self(new Unpack(context));
  self->driverCache_ = driverCache;
  const std::array<VkDescriptorSetLayoutBinding, 2> bindings = {{
      {0, VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE, 1, VK_SHADER_STAGE_COMPUTE_BIT, nullptr},
      {1, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 1, VK_SHADER_STAGE_COMPUTE_BIT, nullptr},
  }};
  auto setInfo = vkStruct<VkDescriptorSetLayoutCreateInfo>(VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO);
  setInfo.bindingCount = bindings.size();
  setInfo.pBindings = bindings.data();
  VkDescriptorSetLayout setLayout = VK_NULL_HANDLE;
  VKREF_TRY(context.vk.vkCreateDescriptorSetLayout(context.device, &setInfo, nullptr, &setLayout));
  self->setLayout_ = OwnedDescriptorSetLayout(context, setLayout);

  const VkPushConstantRange range{VK_SHADER_STAGE_COMPUTE_BIT, 0, sizeof(Band)};
  auto layoutInfo = vkStruct<VkPipelineLayoutCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO);
  layoutInfo.setLayoutCount = 1;
  layoutInfo.pSetLayouts = &setLayout;
  layoutInfo.pushConstantRangeCount = 1;
  layoutInfo.pPushConstantRanges = &range;
  VkPipelineLayout layout = VK_NULL_HANDLE;
  VKREF_TRY(context.vk.vkCreatePipelineLayout(context.device, &layoutInfo, nullptr, &layout));
  self->layout_ = OwnedPipelineLayout(context, layout);
  return self;
}

Result<void> Unpack::reset() {
  for (const OwnedDescriptorPool& pool : pools_) {
    VKREF_TRY(context_.vk.vkResetDescriptorPool(context_.device, pool.get(), 0));
  }
  setsUsed_ = 0;
  return {};
}

Result<VkPipeline> Unpack::pipeline(const Kind& kind) {
  if (const auto found = pipelines_.find(kind); found != pipelines_.end()) return found->second.get();
  Stopwatch watch;
  const Result<OwnedShaderModule> module = makeShaderModule(context_, unpackCode(kind.unsignedIntegers));
  if (!module) return tl::unexpected(module.error());
  const std::array<uint32_t, 2> constants = {kind.samples, kind.components};
  const std::array<VkSpecializationMapEntry, 2> entries = {{{0, 0, 4}, {1, 4, 4}}};
  const VkSpecializationInfo specialization{entries.size(), entries.data(), sizeof(constants), constants.data()};
  auto info = vkStruct<VkComputePipelineCreateInfo>(VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO);
  info.stage = {VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO, nullptr, 0, VK_SHADER_STAGE_COMPUTE_BIT,
                module->get(), "main", &specialization};
  info.layout = layout_.get();
  VkPipeline pipeline = VK_NULL_HANDLE;
  VKREF_TRY(context_.vk.vkCreateComputePipelines(context_.device, driverCache_, 1, &info, nullptr, &pipeline));
  ++created_;
  seconds_ += watch.lap();
  return pipelines_.emplace(kind, OwnedPipeline(context_, pipeline)).first->second.get();
}

Result<VkDescriptorSet> Unpack::descriptors(const Image& image, VkBuffer buffer, VkDeviceSize offset,
                                            VkDeviceSize bytes) {
  if (setsUsed_ == pools_.size() * kSetsPerPool) {
    const std::array<VkDescriptorPoolSize, 2> sizes = {{{VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE, kSetsPerPool},
                                                        {VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, kSetsPerPool}}};
    auto info = vkStruct<VkDescriptorPoolCreateInfo>(VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO);
    info.maxSets = kSetsPerPool;
    info.poolSizeCount = sizes.size();
    info.pPoolSizes = sizes.data();
    VkDescriptorPool pool = VK_NULL_HANDLE;
    VKREF_TRY(context_.vk.vkCreateDescriptorPool(context_.device, &info, nullptr, &pool));
    pools_.emplace_back(context_, pool);
  }
  const VkDescriptorSetLayout setLayout = setLayout_.get();
  auto allocateInfo = vkStruct<VkDescriptorSetAllocateInfo>(VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO);
  allocateInfo.descriptorPool = pools_[setsUsed_ / kSetsPerPool].get();
  allocateInfo.descriptorSetCount = 1;
  allocateInfo.pSetLayouts = &setLayout;
  VkDescriptorSet set = VK_NULL_HANDLE;
  VKREF_TRY(context_.vk.vkAllocateDescriptorSets(context_.device, &allocateInfo, &set));
  ++setsUsed_;

  const VkDescriptorImageInfo imageInfo{VK_NULL_HANDLE, image.view.get(), VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
  const VkDescriptorBufferInfo bufferInfo{buffer, offset, bytes};
  std::array<VkWriteDescriptorSet, 2> writes{};
  for (uint32_t i = 0; i < writes.size(); ++i) {
    writes[i].sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
    writes[i].dstSet = set;
    writes[i].dstBinding = i;
    writes[i].descriptorCount = 1;
  }
  writes[0].descriptorType = VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE;
  writes[0].pImageInfo = &imageInfo;
  writes[1].descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
  writes[1].pBufferInfo = &bufferInfo;
  context_.vk.vkUpdateDescriptorSets(context_.device, writes.size(), writes.data(), 0, nullptr);
  return set;
}

Result<void> Unpack::record(VkCommandBuffer commands, const Image& image, const Rows& rows, VkBuffer buffer, VkDeviceSize offset) {
  const Image::Key& key = image.key;
  const Result<VkPipeline> pipe = pipeline({key.format == kPrimitiveFormat, key.samples, rows.components});
  if (!pipe) return tl::unexpected(pipe.error());
  const VkDeviceSize bytes = VkDeviceSize{rows.rows} * key.width * key.samples * rows.components * 4;
  const Result<VkDescriptorSet> set = descriptors(image, buffer, offset, bytes);
  if (!set) return tl::unexpected(set.error());
  const Band band{static_cast<int32_t>(rows.first), static_cast<int32_t>(rows.rows), static_cast<int32_t>(key.width)};
  context_.vk.vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, *pipe);
  context_.vk.vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_COMPUTE, layout_.get(), 0, 1, &*set, 0, nullptr);
  context_.vk.vkCmdPushConstants(commands, layout_.get(), VK_SHADER_STAGE_COMPUTE_BIT, 0, sizeof(band), &band);
  context_.vk.vkCmdDispatch(commands, (key.width + kGroupWidth - 1) / kGroupWidth, (rows.rows + kGroupHeight - 1) / kGroupHeight, 1);
  return {};
}

}  // namespace rasterdiff::vkref
