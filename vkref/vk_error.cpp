// Names of VkResult values, and which kind of Error each becomes.
#include "vkref/vk_error.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rasterdiff::vkref {

std::string resultName(VkResult result) {
  switch (result) {
#define VKREF_NAME(name) \
  case name:             \
    return #name
    VKREF_NAME(VK_SUCCESS);
    VKREF_NAME(VK_NOT_READY);
    VKREF_NAME(VK_TIMEOUT);
    VKREF_NAME(VK_INCOMPLETE);
    VKREF_NAME(VK_ERROR_OUT_OF_HOST_MEMORY);
    VKREF_NAME(VK_ERROR_OUT_OF_DEVICE_MEMORY);
    VKREF_NAME(VK_ERROR_INITIALIZATION_FAILED);
    VKREF_NAME(VK_ERROR_DEVICE_LOST);
    VKREF_NAME(VK_ERROR_MEMORY_MAP_FAILED);
    VKREF_NAME(VK_ERROR_LAYER_NOT_PRESENT);
    VKREF_NAME(VK_ERROR_EXTENSION_NOT_PRESENT);
    VKREF_NAME(VK_ERROR_FEATURE_NOT_PRESENT);
    VKREF_NAME(VK_ERROR_INCOMPATIBLE_DRIVER);
    VKREF_NAME(VK_ERROR_TOO_MANY_OBJECTS);
    VKREF_NAME(VK_ERROR_FORMAT_NOT_SUPPORTED);
    VKREF_NAME(VK_ERROR_FRAGMENTED_POOL);
    VKREF_NAME(VK_ERROR_OUT_OF_POOL_MEMORY);
    VKREF_NAME(VK_ERROR_UNKNOWN);
#undef VKREF_NAME
    default:
      return fmt::format("VkResult({})", static_cast<int>(result));
  }
}

tl::unexpected<Error> callFailed(std::string_view call, VkResult result) {
  std::string_view name = call.substr(0, call.find('('));
  name.remove_prefix(std::min(name.find_last_of(".>") + 1, name.size()));
  const std::string what = fmt::format("{} returned {}", name, resultName(result));
  if (result == VK_ERROR_OUT_OF_DEVICE_MEMORY || result == VK_ERROR_OUT_OF_HOST_MEMORY) {
    return fail(ErrorCode::NotOffered, std::string(name), what + ": the scene needs more memory than there is",
                "make the target smaller, or take fewer samples or varyings");
  }
  return fail(ErrorCode::DeviceLost, std::string(name), what, "run `rasterdiff devices`, and again with --validate");
}

}  // namespace rasterdiff::vkref
