// Turns a VkResult into an Error that names the call.
#pragma once

#include <volk.h>

#include <string_view>

#include "scene/result.hpp"

namespace rasterdiff::vkref {

/// "VK_ERROR_DEVICE_LOST"; "VkResult(-42)" for one that is not known here.
[[nodiscard]] std::string resultName(VkResult result);

/// Error of a failed call: NotOffered when memory ran out, DeviceLost for all else. `call` may carry arguments.
[[nodiscard]] tl::unexpected<Error> callFailed(std::string_view call, VkResult result);

}  // namespace rasterdiff::vkref

/// Makes a Vulkan call; leaves the function with an Error that names it when it fails.
#define VKREF_TRY(call)                                                                   \
  do {                                                                                    \
    if (const VkResult vkrefResult = (call); vkrefResult < 0) {                           \
      return ::rasterdiff::vkref::callFailed(#call, vkrefResult);                         \
    }                                                                                     \
  } while (false)
