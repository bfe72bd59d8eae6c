// Records copies or unpacking of every attachment, and moves the bytes into a Frame.
#include "vkref/readback.hpp"

#include <algorithm>

#include "vkref/commands.hpp"
#include "vkref/huge_pages.hpp"
#include "vkref/vk_error.hpp"
#include "vkref/vk_struct.hpp"

namespace rasterdiff::vkref {
namespace {

/// A sum of ones in float32 stops growing here; below, every count is exact.
constexpr float kInexactCount = 16777216;

constexpr VkDeviceSize kPlaneAlignment = 256;  ///< no device asks for more of a storage buffer's offset

void recordCopy(const Context& context, VkCommandBuffer commands, const Image& image, VkBuffer buffer,
                VkDeviceSize offset) {
  VkBufferImageCopy region{};
  region.bufferOffset = offset;
  region.imageSubresource = {aspectOf(image.key.format), 0, 0, 1};
  region.imageExtent = {image.key.width, image.key.height, 1};
  context.vk.vkCmdCopyImageToBuffer(commands, image.image.get(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, buffer, 1,
                                    &region);
}

void recordHostBarrier(const Context& context, VkCommandBuffer commands) {
  auto barrier = vkStruct<VkMemoryBarrier2>(VK_STRUCTURE_TYPE_MEMORY_BARRIER_2);
  barrier.srcStageMask = VK_PIPELINE_STAGE_2_COPY_BIT | VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT;
  barrier.srcAccessMask = VK_ACCESS_2_TRANSFER_WRITE_BIT | VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT;
  barrier.dstStageMask = VK_PIPELINE_STAGE_2_HOST_BIT;
  barrier.dstAccessMask = VK_ACCESS_2_HOST_READ_BIT;
  auto info = vkStruct<VkDependencyInfo>(VK_STRUCTURE_TYPE_DEPENDENCY_INFO);
  info.memoryBarrierCount = 1;
  info.pMemoryBarriers = &barrier;
  context.vk.vkCmdPipelineBarrier2(commands, &info);
}

/// A plane of the plan's extents without any data yet, and room for all of it.
template <class T>
Plane<T> emptyPlane(const RenderPlan& plan, uint32_t components) {
  Plane<T> plane;
  plane.width = plan.width;
  plane.height = plan.height;
  plane.samples = plan.samples;
  plane.components = components;
  plane.data.reserve(size_t{plan.width} * plan.height * plan.samples * components);
  adviseHugePages(plane.data.data(), plane.data.capacity() * sizeof(T));
  return plane;
}

/// The values at `from` as a plane, `stride` of them a sample; a single copy where they lie tight.
template <class T>
Plane<T> copyPlane(const RenderPlan& plan, const std::byte* from, uint32_t components, uint32_t stride) {
  Plane<T> plane = emptyPlane<T>(plan, components);
  const size_t samples = size_t{plan.width} * plan.height * plan.samples;
  const T* values = reinterpret_cast<const T*>(from);
  if (stride == components) {
    plane.data.assign(values, values + samples * components);
    return plane;
  }
  plane.data.resize(samples * components);
  T* to = plane.data.data();
  for (size_t i = 0; i < samples; ++i, to += components, values += stride) std::copy_n(values, components, to);
  return plane;
}

/// Counts that were summed as floats. Error: NotOffered where a sum has stopped being exact.
Result<Plane<uint32_t>> countPlane(const RenderPlan& plan, const std::byte* from, uint32_t stride) {
  Plane<uint32_t> plane = emptyPlane<uint32_t>(plan, 1);
  plane.data.resize(size_t{plan.width} * plan.height * plan.samples);
  const float* counts = reinterpret_cast<const float*>(from);
  bool exact = true;
  for (size_t i = 0; i < plane.data.size(); ++i) {
    const float count = counts[i * stride];
    exact &= count < kInexactCount;
    plane.data[i] = static_cast<uint32_t>(count < kInexactCount ? count : 0);
  }
  if (!exact) {
    return fail(ErrorCode::NotOffered, "draws", "a sample was written 2^24 times or more: float counts end there");
  }
  return plane;
}

}  // namespace

Result<Readback> recordReadback(const Context& context, VkCommandBuffer commands, const RenderPlan& plan,
                                const Attachments& attachments, Pool<Buffer>& buffers, Unpack& unpack,
                                RenderCost& cost) {
  const bool copies = plan.samples == 1;
  Readback readback;
  VkDeviceSize bytes = 0;
  const auto place = [&](uint32_t components, VkFormat format) {
    PlaneLocation location;
    location.offset = bytes;
    location.stride = copies ? texelComponents(format) : unpackedComponents(plan.samples, components);
    const VkDeviceSize size = VkDeviceSize{plan.width} * plan.height * plan.samples * location.stride * 4;
    cost.readbackBytes += size;
    bytes += (size + kPlaneAlignment - 1) / kPlaneAlignment * kPlaneAlignment;
    return location;
  };
  for (const AttachmentPlan& color : plan.color) readback.color.push_back(place(color.components, color.format));
  if (plan.depth) readback.depth = place(1, kDepthFormat);

  Result<Pool<Buffer>::Lease> buffer =
      acquireBuffer(buffers, bytes, VK_BUFFER_USAGE_TRANSFER_DST_BIT | VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
  if (!buffer) return tl::unexpected(buffer.error());
  readback.buffer = std::move(*buffer);

  const VkPipelineStageFlags2 stage =
      copies ? VK_PIPELINE_STAGE_2_COPY_BIT : VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT;
  const VkAccessFlags2 access = copies ? VK_ACCESS_2_TRANSFER_READ_BIT : VK_ACCESS_2_SHADER_SAMPLED_READ_BIT;
  const VkImageLayout layout =
      copies ? VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL : VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL;
  std::vector<VkImageMemoryBarrier2> barriers;
  for (const Pool<Image>::Lease& image : attachments.color) {
    barriers.push_back(imageBarrier(*image, VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT,
                                    VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL,
                                    stage, access, layout));
  }
  if (attachments.depth) {
    barriers.push_back(imageBarrier(*attachments.depth, kDepthStages, VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT,
                                    VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL, stage, access, layout));
  }
  recordBarriers(context, commands, barriers);

  if (const Result<void> reset = unpack.reset(); !reset) return tl::unexpected(reset.error());
  const auto record = [&](const Image& image, const PlaneLocation& location) -> Result<void> {
    const VkBuffer to = readback.buffer->buffer.get();
    if (!copies) return unpack.record(commands, image, location.stride, to, location.offset);
    recordCopy(context, commands, image, to, location.offset);
    return {};
  };
  for (size_t i = 0; i < plan.color.size(); ++i) {
    const Result<void> recorded = record(*attachments.color[i], readback.color[i]);
    if (!recorded) return tl::unexpected(recorded.error());
  }
  if (attachments.depth) {
    const Result<void> recorded = record(*attachments.depth, readback.depth);
    if (!recorded) return tl::unexpected(recorded.error());
  }
  recordHostBarrier(context, commands);
  return readback;
}

Result<Frame> frameOf(const Scene& scene, const RenderPlan& plan, const Readback& readback) {
  const std::byte* mapped = readback.buffer->mapped;
  const auto plane = [&]<class T>(T, uint32_t components, const PlaneLocation& location) {
    return copyPlane<T>(plan, mapped + location.offset, components, location.stride);
  };
  Frame frame;
  frame.width = plan.width;
  frame.height = plan.height;
  frame.samples = plan.samples;
  frame.primitive = plane(uint32_t{}, 1, readback.color[0]);
  Result<Plane<uint32_t>> counts = countPlane(plan, mapped + readback.color[1].offset, readback.color[1].stride);
  if (!counts) return tl::unexpected(counts.error());
  frame.count = std::move(*counts);
  if (plan.depth) frame.depth = plane(float{}, 1, readback.depth);
  for (size_t i = 2; i < plan.color.size(); ++i) {
    const std::string& name = scene.draws.front().varyings[i - 2].name;
    frame.varyings.push_back({name, plane(float{}, plan.color[i].components, readback.color[i]), std::nullopt});
  }
  return frame;
}

}  // namespace rasterdiff::vkref
