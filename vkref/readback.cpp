// Records copies or unpacking of every attachment, and moves the bytes into a Frame.
#include "vkref/readback.hpp"

#include <algorithm>

#include "scene/built_ins.hpp"
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

/// A plane of the plan's extents without any data yet, and room for all of it.
template <class T>
Plane<T> emptyPlane(const RenderPlan& plan, uint32_t samples, uint32_t components) {
  Plane<T> plane;
  plane.width = plan.width;
  plane.height = plan.height;
  plane.samples = samples;
  plane.components = components;
  plane.data.reserve(size_t{plan.width} * plan.height * samples * components);
  adviseHugePages(plane.data.data(), plane.data.capacity() * sizeof(T));
  return plane;
}

/// The values at `from` as a plane, `stride` of them a sample; a single copy where they lie tight.
template <class T>
Plane<T> copyPlane(const RenderPlan& plan, uint32_t samples, const std::byte* from, uint32_t components,
                   uint32_t stride) {
  Plane<T> plane = emptyPlane<T>(plan, samples, components);
  const size_t count = size_t{plan.width} * plan.height * samples;
  const T* values = reinterpret_cast<const T*>(from);
  if (stride == components) {
    plane.data.assign(values, values + count * components);
    return plane;
  }
  plane.data.resize(count * components);
  T* to = plane.data.data();
  for (size_t i = 0; i < count; ++i, to += components, values += stride) std::copy_n(values, components, to);
  return plane;
}

Plane<float> depthPlane(const RenderPlan& plan, uint32_t samples, const std::byte* from, uint32_t stride, DepthFetch fetch) {
  if (samples > 1) {
    Plane<float> plane = copyPlane<float>(plan, plan.samples, from, 1, stride);
    restoreFetchedDepths(plan.depth, fetch, plane.data);
    return plane;
  }
  Plane<float> plane = emptyPlane<float>(plan, 1, 1);
  plane.data.resize(size_t{plan.width} * plan.height);
  copyDepths(plan.depth, from, plane.data);
  return plane;
}

/// Counts that were summed as floats. Error: NotOffered where a sum has stopped being exact.
Result<Plane<uint32_t>> countPlane(const RenderPlan& plan, const std::byte* from, uint32_t stride) {
  Plane<uint32_t> plane = emptyPlane<uint32_t>(plan, plan.samples, 1);
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

/// Reserves a place for each image and counts its bytes.
VkDeviceSize placePlanes(const RenderPlan& plan, const Attachments& attachments, Readback& readback, RenderCost& cost) {
  VkDeviceSize bytes = 0;
  const auto place = [&](const Image& image, uint32_t components) {
    const Image::Key& key = image.key;
    const VkDeviceSize texels = VkDeviceSize{key.width} * key.height * key.samples;
    PlaneLocation location;
    location.offset = bytes;
    location.stride = key.samples == 1 ? static_cast<uint32_t>(std::max<VkDeviceSize>(texelBytes(key.format) / 4, 1))
                                       : unpackedComponents(key.samples, components);
    const VkDeviceSize size = texels * (key.samples == 1 ? copiedBytes(key.format) : location.stride * 4);
    cost.readbackBytes += size;
    bytes += (size + kPlaneAlignment - 1) / kPlaneAlignment * kPlaneAlignment;
    return location;
  };
  for (size_t i = 0; i < plan.color.size(); ++i) {
    readback.color.push_back(place(*attachments.color[i], plan.color[i].components));
  }
  for (size_t v = 0; v < attachments.resolved.size(); ++v) {
    readback.resolved.push_back(place(*attachments.resolved[v], plan.color[kFirstVarying + v].components));
  }
  if (attachments.depth) readback.depth = place(*attachments.depth, 1);
  if (attachments.resolvedDepth) readback.resolvedDepth = place(*attachments.resolvedDepth, 1);
  return bytes;
}

}  // namespace

VkImageMemoryBarrier2 transferBarrier(const Image& image) {
  const bool depth = isDepthFormat(image.key.format), copied = image.key.samples == 1;
  // [vk:renderpass-resolve-operations] what depth is resolved to is written as a colour attachment is.
  const VkPipelineStageFlags2 color = VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT;
  const VkAccessFlags2 colorWrite = VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT;
  return imageBarrier(image, depth ? kDepthStages | color : color,
                      depth ? VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT | colorWrite : colorWrite,
                      attachmentLayout(image.key.format),
                      copied ? VK_PIPELINE_STAGE_2_COPY_BIT : VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT,
                      copied ? VK_ACCESS_2_TRANSFER_READ_BIT : VK_ACCESS_2_SHADER_SAMPLED_READ_BIT,
                      copied ? VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL : VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
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

Result<Readback> recordReadback(const Context& context, VkCommandBuffer commands, const RenderPlan& plan,
                                const Attachments& attachments, Pool<Buffer>& buffers, Unpack& unpack,
                                RenderCost& cost) {
  Readback readback;
  const VkDeviceSize bytes = placePlanes(plan, attachments, readback, cost);
  Result<Pool<Buffer>::Lease> buffer =
      acquireBuffer(buffers, bytes, VK_BUFFER_USAGE_TRANSFER_DST_BIT | VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
  if (!buffer) return tl::unexpected(buffer.error());
  readback.buffer = std::move(*buffer);

  std::vector<std::pair<const Image*, const PlaneLocation*>> planes;
  for (size_t i = 0; i < plan.color.size(); ++i) planes.emplace_back(attachments.color[i].get(), &readback.color[i]);
  for (size_t v = 0; v < attachments.resolved.size(); ++v) {
    planes.emplace_back(attachments.resolved[v].get(), &readback.resolved[v]);
  }
  if (attachments.depth) planes.emplace_back(attachments.depth.get(), &readback.depth);
  if (attachments.resolvedDepth) planes.emplace_back(attachments.resolvedDepth.get(), &readback.resolvedDepth);
  std::vector<VkImageMemoryBarrier2> barriers;
  for (const auto& [image, location] : planes) barriers.push_back(transferBarrier(*image));
  recordBarriers(context, commands, barriers);

  if (const Result<void> reset = unpack.reset(); !reset) return tl::unexpected(reset.error());
  const VkBuffer to = readback.buffer->buffer.get();
  for (const auto& [image, location] : planes) {
    if (image->key.samples == 1) {
      recordCopy(context, commands, *image, to, location->offset);
      continue;
    }
    const Result<void> recorded = unpack.record(commands, *image, location->stride, to, location->offset);
    if (!recorded) return tl::unexpected(recorded.error());
  }
  recordHostBarrier(context, commands);
  return readback;
}

Result<Frame> frameOf(const Scene& scene, const RenderPlan& plan, const Readback& readback, DepthFetch fetch) {
  const std::byte* mapped = readback.buffer->mapped;
  const auto plane = [&]<class T>(T, uint32_t samples, uint32_t components, const PlaneLocation& location) {
    return copyPlane<T>(plan, samples, mapped + location.offset, components, location.stride);
  };
  Frame frame;
  frame.width = plan.width;
  frame.height = plan.height;
  frame.samples = plan.samples;
  frame.primitive = plane(uint32_t{}, plan.samples, 1, readback.color[0]);
  Result<Plane<uint32_t>> counts = countPlane(plan, mapped + readback.color[1].offset, readback.color[1].stride);
  if (!counts) return tl::unexpected(counts.error());
  frame.count = std::move(*counts);
  if (plan.depth != VK_FORMAT_UNDEFINED) {
    frame.depth = depthPlane(plan, plan.samples, mapped + readback.depth.offset, readback.depth.stride, fetch);
  }
  for (size_t i = kFirstVarying; i < plan.color.size(); ++i) {
    const size_t v = i - kFirstVarying;
    const uint32_t components = plan.color[i].components;
    std::string name(v < plan.varyings ? std::string_view(scene.draws.front().varyings[v].name)
                                       : builtInName(scene.builtIns[v - plan.varyings]));
    frame.varyings.push_back(
        {std::move(name), plane(float{}, plan.samples, components, readback.color[i]), std::nullopt});
    if (v >= readback.resolved.size()) continue;
    frame.resolved.push_back(
        {frame.varyings.back().name, plane(float{}, 1, components, readback.resolved[v]), std::nullopt});
  }
  if (plan.depthResolve != VK_RESOLVE_MODE_NONE) {
    frame.resolved.push_back(
        {"depth", depthPlane(plan, 1, mapped + readback.resolvedDepth.offset, readback.resolvedDepth.stride, fetch), std::nullopt});
  }
  return frame;
}

}  // namespace rasterdiff::vkref
