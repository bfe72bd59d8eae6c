// Reads attachments through small buffers, a batch of rows a submit: while the host takes one batch over, the device
// brings the next ones. What goes through it stays in the cache, and no second copy of a large frame needs memory.
#include "vkref/readback.hpp"

#include <algorithm>
#include <iterator>

#include "vkref/commands.hpp"
#include "vkref/geometry.hpp"
#include "vkref/plane_sink.hpp"
#include "vkref/vk_error.hpp"
#include "vkref/vk_struct.hpp"

namespace rasterdiff::vkref {
namespace {

constexpr VkDeviceSize kPieceAlignment = 256;  ///< no device asks for more of a storage buffer's offset
/// How much is on its way.
struct Flow {
  VkDeviceSize bytes = 0;  ///< a batch
  size_t batches = 0;
};
/// Copies cost little to begin, and go through the cache: of many, the device has always one that it need not wait for. A
/// dispatch of the unpack shader costs lavapipe 0.3 ms.
constexpr Flow kCopied{VkDeviceSize{512} << 10, Submission::kSlots}, kUnpacked{VkDeviceSize{16} << 20, 2};

VkDeviceSize aligned(VkDeviceSize bytes) { return (bytes + kPieceAlignment - 1) / kPieceAlignment * kPieceAlignment; }

/// Some rows of one attachment in the buffer.
struct Piece {
  const PlaneSink* sink = nullptr;
  uint32_t first = 0, rows = 0;
  VkDeviceSize offset = 0;
};
using Batch = std::vector<Piece>;

/// All rows of all attachments, in batches that fit `capacity` bytes each, which has room for any one row.
std::vector<Batch> batchesOf(std::span<const PlaneSink> sinks, VkDeviceSize capacity) {
  std::vector<Batch> batches(1);
  VkDeviceSize used = 0;
  for (const PlaneSink& sink : sinks) {
    const uint32_t height = sink.image->key.height;
    for (uint32_t first = 0; first < height;) {
      const auto fitting = static_cast<uint32_t>(std::min<VkDeviceSize>((capacity - used) / sink.rowBytes, height - first));
      if (fitting == 0) {
        batches.emplace_back();
        used = 0;
        continue;
      }
      batches.back().push_back({&sink, first, fitting, used});
      used = std::min(capacity, aligned(used + fitting * sink.rowBytes));
      first += fitting;
    }
  }
  return batches;
}

void recordCopy(const Context& context, VkCommandBuffer commands, const Piece& piece, VkBuffer buffer) {
  const Image& image = *piece.sink->image;
  VkBufferImageCopy region{};
  region.bufferOffset = piece.offset;
  region.imageSubresource = {aspectOf(image.key.format), 0, 0, 1};
  region.imageOffset = {0, static_cast<int32_t>(piece.first), 0};
  region.imageExtent = {image.key.width, piece.rows, 1};
  context.vk.vkCmdCopyImageToBuffer(commands, image.image.get(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, buffer, 1,
                                    &region);
}

Result<void> recordBatch(const Batch& batch, VkCommandBuffer commands, VkBuffer buffer, ReadbackTools& tools) {
  for (const Piece& piece : batch) {
    if (piece.sink->image->key.samples == 1) {
      recordCopy(tools.context, commands, piece, buffer);
      continue;
    }
    const Result<void> recorded =
        tools.unpack.record(commands, *piece.sink->image, {piece.first, piece.rows, piece.sink->stride}, buffer, piece.offset);
    if (!recorded) return recorded;
  }
  recordHostBarrier(tools.context, commands);
  return {};
}

Result<void> take(const Batch& batch, const std::byte* mapped) {
  for (const Piece& piece : batch) {
    if (Result<void> taken = piece.sink->take(mapped + piece.offset, piece.first, piece.rows); !taken) return taken;
  }
  return {};
}

/// Error as of readFrame, after which a submit may be pending.
Result<void> runBatches(std::span<const PlaneSink> sinks, const std::vector<Batch>& batches, ReadbackTools& tools) {
  const size_t slots = tools.buffers.size();
  const auto slotOf = [slots](size_t batch) { return batch % slots; };
  const auto finish = [&](size_t batch) -> Result<void> {
    if (Result<void> waited = tools.submission.wait(slotOf(batch)); !waited) return waited;
    return take(batches[batch], tools.buffers[slotOf(batch)]->mapped);
  };
  size_t finished = 0;
  for (size_t k = 0; k < batches.size(); ++k) {
    if (k == finished + slots) {
      if (Result<void> taken = finish(finished++); !taken) return taken;
    }
    const Result<VkCommandBuffer> commands = tools.submission.begin(slotOf(k));
    if (!commands) return tl::unexpected(commands.error());
    if (k == 0) {
      std::vector<VkImageMemoryBarrier2> barriers;
      for (const PlaneSink& sink : sinks) barriers.push_back(transferBarrier(*sink.image));
      recordBarriers(tools.context, *commands, barriers);
    }
    if (Result<void> recorded = recordBatch(batches[k], *commands, tools.buffers[slotOf(k)]->buffer.get(), tools); !recorded) return recorded;
    if (Result<void> submitted = tools.submission.submit(slotOf(k)); !submitted) return submitted;
  }
  for (; finished < batches.size(); ++finished) {
    if (Result<void> taken = finish(finished); !taken) return taken;
  }
  return {};
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

Result<std::vector<Frame>> readFrames(std::span<const DrawnScene> drawn, ReadbackTools& tools, RenderCost& cost) {
  std::vector<Frame> frames(drawn.size());
  std::vector<PlaneSink> sinks;
  bool unpacked = false;
  for (size_t i = 0; i < drawn.size(); ++i) {
    std::vector<PlaneSink> own = planeSinks(*drawn[i].scene, *drawn[i].plan, *drawn[i].attachments, drawn[i].fetch, frames[i]);
    std::move(own.begin(), own.end(), std::back_inserter(sinks));
    unpacked |= drawn[i].plan->samples > 1;
  }
  VkDeviceSize bytes = 0, longestRow = 0;
  for (const PlaneSink& sink : sinks) {
    cost.readbackBytes += sink.rowBytes * sink.image->key.height;
    bytes += aligned(sink.rowBytes * sink.image->key.height);
    longestRow = std::max(longestRow, sink.rowBytes);
  }
  const Flow& flow = unpacked ? kUnpacked : kCopied;
  const VkDeviceSize capacity = std::min(bytes, std::max(flow.bytes, longestRow));
  const std::vector<Batch> batches = batchesOf(sinks, capacity);
  for (size_t slot = 0; slot < std::min(batches.size(), flow.batches); ++slot) {
    Result<Pool<Buffer>::Lease> buffer =
        acquireBuffer(tools.pool, capacity, VK_BUFFER_USAGE_TRANSFER_DST_BIT | VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
    if (!buffer) return tl::unexpected(buffer.error());
    tools.buffers.push_back(std::move(*buffer));
  }
  if (const Result<void> reset = tools.unpack.reset(); !reset) return tl::unexpected(reset.error());
  if (const Result<void> run = runBatches(sinks, batches, tools); !run) {
    if (run.error().code == ErrorCode::TimedOut) return tl::unexpected(run.error());
    const Result<void> drained = tools.submission.drain();
    return tl::unexpected(drained ? run.error() : drained.error());
  }
  return frames;
}

}  // namespace rasterdiff::vkref
