// Which planes a scene needs as attachments, and in how many passes: decided before anything is allocated.
#pragma once

#include <cstdint>
#include <vector>

#include "scene/scene.hpp"
#include "vkref/capabilities.hpp"

namespace rasterdiff::vkref {

/// Varyings that one pass can hold beside primitive index and count; later passes take no more, though they could.
inline constexpr uint32_t kMaxVaryingsPerPass = 6;

struct AttachmentPlan {
  VkFormat format = VK_FORMAT_UNDEFINED;
  uint32_t components = 1;  ///< that are read back; a texel may hold more
};

/// Color attachments first .. first + count - 1 of the plan, in one render pass over all draws.
struct PassPlan {
  uint32_t firstAttachment = 0, attachments = 0;
  uint32_t firstVarying = 0, varyings = 0;
  bool primitives = false;  ///< attachments 0 and 1 of the pass are primitive index and count
};

struct RenderPlan {
  uint32_t width = 0, height = 0, samples = 1;
  std::vector<AttachmentPlan> color;  ///< primitive index, count, then each varying
  bool depth = false;
  std::vector<PassPlan> passes;
};

[[nodiscard]] RenderPlan planOf(const Scene& scene, const Capabilities& caps);

/// Can the device draw it? Error: NotOffered with the limit that is exceeded.
[[nodiscard]] Result<void> checkOffered(const Scene& scene, const RenderPlan& plan, const Capabilities& caps);

}  // namespace rasterdiff::vkref
