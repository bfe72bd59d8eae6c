// Leases attachments from the pool and counts their bytes, so that a test can see what a scene made.
#include "vkref/attachments.hpp"

namespace rasterdiff::vkref {

Result<Attachments> acquireAttachments(const RenderPlan& plan, Pool<Image>& images, RenderCost& cost) {
  Attachments attachments;
  const auto lease = [&](VkFormat format) {
    const Image::Key key{format, plan.width, plan.height, plan.samples};
    cost.attachmentBytes += Image::texelBytes(key);
    return images.acquire(key, Image::texelBytes(key));
  };
  for (const AttachmentPlan& color : plan.color) {
    Result<Pool<Image>::Lease> image = lease(color.format);
    if (!image) return tl::unexpected(image.error());
    attachments.color.push_back(std::move(*image));
    ++cost.colorAttachments;
  }
  if (plan.depth) {
    Result<Pool<Image>::Lease> image = lease(kDepthFormat);
    if (!image) return tl::unexpected(image.error());
    attachments.depth = std::move(*image);
    ++cost.depthAttachments;
  }
  return attachments;
}

}  // namespace rasterdiff::vkref
