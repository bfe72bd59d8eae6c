// How a device turns a stored 24-bit depth into the float that a shader fetches: asked once, by a depth that tells.
#pragma once

#include <map>
#include <memory>

#include "vkref/depth_values.hpp"
#include "vkref/pool.hpp"
#include "vkref/submission.hpp"
#include "vkref/unpack.hpp"

namespace rasterdiff::vkref {

/// Answers are kept for the life of a device.
class DepthFetches {
 public:
  explicit DepthFetches(const Context& context) : context_(context) {}

  /// For images of `format` with `samples` > 1. Costs a submit on first use, and only for 24-bit formats.
  /// Error: NotOffered if the device fits no known arithmetic; DeviceLost, TimedOut.
  [[nodiscard]] Result<DepthFetch> of(VkFormat format, uint32_t samples, Pool<Image>& images, Pool<Buffer>& buffers,
                                      Submission& submission, Unpack& unpack);

 private:
  [[nodiscard]] Result<float> fetchOf(float depth, const Image& image, const Buffer& buffer, Submission& submission,
                                      Unpack& unpack) const;

  const Context& context_;
  std::map<std::pair<VkFormat, uint32_t>, DepthFetch> known_;
};

}  // namespace rasterdiff::vkref
