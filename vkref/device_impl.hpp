// What a Device owns, in the order in which it has to be destroyed (last first).
#pragma once

#include <optional>

#include "vkref/attachments.hpp"
#include "vkref/depth_fetch.hpp"
#include "vkref/instance.hpp"
#include "vkref/pipeline.hpp"
#include "vkref/submission.hpp"
#include "vkref/unpack.hpp"

namespace rasterdiff::vkref {

/// Idle images and buffers that are kept for the next scenes: 1920 × 1080 pixels of four samples with depth and one
/// varying of four components take 222 MiB of each.
inline constexpr VkDeviceSize kIdleImageBytes = VkDeviceSize{512} << 20;
inline constexpr VkDeviceSize kIdleBufferBytes = VkDeviceSize{512} << 20;

struct Device::Impl {
  std::unique_ptr<Instance> instance;
  std::unique_ptr<Context> context;
  std::unique_ptr<PipelineCache> pipelines;
  size_t mostPipelines = 0;
  std::unique_ptr<Unpack> unpack;
  std::unique_ptr<DepthFetches> depthFetches;
  std::unique_ptr<Submission> submission;
  std::unique_ptr<Pool<Image>> images;
  std::unique_ptr<Pool<Buffer>> buffers;
  /// Of scenes whose submit timed out: the device may still use them.
  std::vector<Attachments> abandonedAttachments;
  std::vector<Pool<Buffer>::Lease> abandonedBuffers;
  std::optional<Error> broken;  ///< set by DeviceLost and TimedOut: no further scene is drawn
  RenderCost cost;
  bool pointsBegun = false;  ///< a point outside of the view volume was drawn before the first scene that draws points
};

}  // namespace rasterdiff::vkref
