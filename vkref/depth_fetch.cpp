// Clears a small image to one depth and fetches it the way that readback does.
#include "vkref/depth_fetch.hpp"

#include <cstring>

#include "vkref/commands.hpp"
#include "vkref/readback.hpp"
#include "vkref/vk_struct.hpp"

namespace rasterdiff::vkref {
namespace {

constexpr uint32_t kExtent = 4;
/// As a 24-bit integer 14680063, of which a multiplication by the rounded reciprocal makes a float one step larger than
/// the quotient is.
constexpr float kProbe = 0.875F;
constexpr uint32_t kProbeInteger = 14680063;

void recordClear(const Context& context, VkCommandBuffer commands, const Image& image, float depth) {
  const VkImageLayout layout = attachmentLayout(image.key.format);
  recordBarriers(context, commands,
                 {imageBarrier(image, kDepthStages, VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT,
                               VK_IMAGE_LAYOUT_UNDEFINED, kDepthStages, kDepthAccess, layout)});
  auto attachment = vkStruct<VkRenderingAttachmentInfo>(VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO);
  attachment.imageView = image.view.get();
  attachment.imageLayout = layout;
  attachment.loadOp = VK_ATTACHMENT_LOAD_OP_CLEAR;
  attachment.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
  attachment.clearValue.depthStencil.depth = depth;
  auto info = vkStruct<VkRenderingInfo>(VK_STRUCTURE_TYPE_RENDERING_INFO);
  info.renderArea = {{0, 0}, {image.key.width, image.key.height}};
  info.layerCount = 1;
  info.pDepthAttachment = &attachment;
  context.vk.vkCmdBeginRendering(commands, &info);
  context.vk.vkCmdEndRendering(commands);
}

}  // namespace

Result<float> DepthFetches::fetchOf(float depth, const Image& image, const Buffer& buffer, Submission& submission,
                                    Unpack& unpack) const {
  const Result<VkCommandBuffer> commands = submission.begin();
  if (!commands) return tl::unexpected(commands.error());
  recordClear(context_, *commands, image, depth);
  recordBarriers(context_, *commands, {transferBarrier(image)});
  if (const Result<void> reset = unpack.reset(); !reset) return tl::unexpected(reset.error());
  const uint32_t components = unpackedComponents(image.key.samples, 1);
  const Result<void> recorded = unpack.record(*commands, image, {0, image.key.height, components}, buffer.buffer.get(), 0);
  if (!recorded) return tl::unexpected(recorded.error());
  recordHostBarrier(context_, *commands);
  if (const Result<void> run = submission.run(); !run) return tl::unexpected(run.error());
  float fetched = 0;
  std::memcpy(&fetched, buffer.mapped, sizeof(fetched));
  return fetched;
}

Result<DepthFetch> DepthFetches::of(VkFormat format, uint32_t samples, Pool<Image>& images, Pool<Buffer>& buffers,
                                    Submission& submission, Unpack& unpack) {
  if (unormDepthBits(format) != 24) return DepthFetch::Quotient;  // fewer bits survive either arithmetic
  if (const auto found = known_.find({format, samples}); found != known_.end()) return found->second;
  const Image::Key key{format, kExtent, kExtent, samples};
  const Result<Pool<Image>::Lease> image = images.acquire(key, Image::bytesOf(key));
  if (!image) return tl::unexpected(image.error());
  const Result<Pool<Buffer>::Lease> buffer =
      acquireBuffer(buffers, kExtent * kExtent * samples * 8,
                    VK_BUFFER_USAGE_TRANSFER_DST_BIT | VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
  if (!buffer) return tl::unexpected(buffer.error());
  const Result<float> fetched = fetchOf(kProbe, **image, **buffer, submission, unpack);
  if (!fetched) return tl::unexpected(fetched.error());
  for (const DepthFetch fetch : {DepthFetch::Quotient, DepthFetch::Reciprocal}) {
    if (fetchedDepth(fetch, kProbeInteger, 24) != *fetched) continue;
    known_[{format, samples}] = fetch;
    return fetch;
  }
  return fail(ErrorCode::NotOffered, "target.depthFormat",
              "a 24-bit depth of several samples is fetched by an arithmetic that does not tell what is stored",
              "use one sample, or another depth format");
}

}  // namespace rasterdiff::vkref
