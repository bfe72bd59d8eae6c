// Leases attachments from the pool and counts their bytes, so that a test can see what a scene made.
#include "vkref/attachments.hpp"

namespace rasterdiff::vkref {

Result<Attachments> acquireAttachments(const RenderPlan& plan, Pool<Image>& images, RenderCost& cost) {
  Attachments attachments;
  const auto lease = [&](VkFormat format, uint32_t samples) {
    const Image::Key key{format, plan.width, plan.height, samples};
    cost.attachmentBytes += Image::bytesOf(key);
    return images.acquire(key, Image::bytesOf(key));
  };
  for (const AttachmentPlan& color : plan.color) {
    Result<Pool<Image>::Lease> image = lease(color.format, plan.samples);
    if (!image) return tl::unexpected(image.error());
    attachments.color.push_back(std::move(*image));
    ++cost.colorAttachments;
  }
  for (uint32_t v = 0; v < plan.varyings && plan.resolve; ++v) {
    Result<Pool<Image>::Lease> image = lease(attachments.color[kFirstVarying + v]->key.format, 1);
    if (!image) return tl::unexpected(image.error());
    attachments.resolved.push_back(std::move(*image));
    ++cost.colorAttachments;
  }
  if (plan.depth != VK_FORMAT_UNDEFINED) {
    Result<Pool<Image>::Lease> image = lease(plan.depth, plan.samples);
    if (!image) return tl::unexpected(image.error());
    attachments.depth = std::move(*image);
    ++cost.depthAttachments;
  }
  if (plan.depthResolve != VK_RESOLVE_MODE_NONE) {
    Result<Pool<Image>::Lease> image = lease(plan.depth, 1);
    if (!image) return tl::unexpected(image.error());
    attachments.resolvedDepth = std::move(*image);
    ++cost.depthAttachments;
  }
  return attachments;
}

}  // namespace rasterdiff::vkref
