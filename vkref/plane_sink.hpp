// Takes over the texels of attachments, piece by piece, into the planes of a frame.
#pragma once

#include <functional>
#include <vector>

#include "scene/frame.hpp"
#include "vkref/attachments.hpp"
#include "vkref/depth_values.hpp"

namespace rasterdiff::vkref {

/// One attachment on its way into a frame.
struct PlaneSink {
  const Image* image = nullptr;
  uint32_t stride = 1;        ///< 32-bit words a sample that lie at `from`; may exceed the plane's components
  VkDeviceSize rowBytes = 0;  ///< of the pixels of a row
  /// Takes rows [first, first + rows). Error: NotOffered if a count is too large to be exact.
  std::function<Result<void>(const std::byte* from, uint32_t first, uint32_t rows)> take;
};

/// Makes the planes of `frame`, which must stay where it is, and says how to fill them; `fetch` is how depths of several
/// samples come.
[[nodiscard]] std::vector<PlaneSink> planeSinks(const Scene& scene, const RenderPlan& plan, const Attachments& attachments,
                                                DepthFetch fetch, Frame& frame);

}  // namespace rasterdiff::vkref
