// Which planes a scene needs as attachments, and in how many passes: decided before anything is allocated.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "scene/scene.hpp"
#include "vkref/capabilities.hpp"

namespace rasterdiff::vkref {

/// Varyings that one pass can hold beside primitive index and count; later passes take no more, though they could.
inline constexpr uint32_t kMaxVaryingsPerPass = 6;

inline constexpr uint32_t kFirstVarying = 2;  ///< in RenderPlan::color, after primitive index and count

struct AttachmentPlan {
  VkFormat format = VK_FORMAT_UNDEFINED;
  uint32_t components = 1;  ///< that are read back; a texel may hold more
};

/// One render pass over all draws.
struct PassPlan {
  std::vector<uint32_t> attachments;  ///< of RenderPlan::color, in the order of the fragment shader's outputs
  std::vector<uint32_t> varyings;     ///< of the scene, in the order of the fragment shader's inputs
  bool primitives = false;            ///< primitive index and count are written
  std::optional<BuiltIn> builtIn;     ///< written by the last output
};

struct RenderPlan {
  uint32_t width = 0, height = 0, samples = 1;
  std::vector<AttachmentPlan> color;  ///< primitive index, count, then each varying, then each built-in
  uint32_t varyings = 0;
  VkFormat depth = VK_FORMAT_UNDEFINED;
  bool resolve = false;               ///< each varying also has a resolved image of one sample
  VkResolveModeFlagBits depthResolve = VK_RESOLVE_MODE_NONE;  ///< by the first pass, into an image of one sample
  bool alphaFirst = false;            ///< output 0 of every pass is the first varying, where Vulkan looks for alpha
  bool sampleShading = false;         ///< of every sample: SampleId or SamplePosition is observed
  bool viewportIndex = false;         ///< the vertex shader chooses; else a draw with its own viewport sets it
  std::vector<PassPlan> passes;
};

[[nodiscard]] RenderPlan planOf(const Scene& scene, const Capabilities& caps);

/// Does pass `pass` write and resolve the varying of output `output`? Each varying is resolved once.
[[nodiscard]] bool resolves(const RenderPlan& plan, const PassPlan& pass, size_t output);

/// Can the device draw it? Error: NotOffered with the limit, feature or extension that is missing.
[[nodiscard]] Result<void> checkOffered(const Scene& scene, const RenderPlan& plan, const Capabilities& caps);

}  // namespace rasterdiff::vkref
