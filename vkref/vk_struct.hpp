// Vulkan structures, zeroed but for their type.
#pragma once

#include <volk.h>

namespace rasterdiff::vkref {

/// A T with `sType` set, `pNext` as given, and zero everywhere else.
template <class T>
[[nodiscard]] T vkStruct(VkStructureType type, void* next = nullptr) {
  T value{};
  value.sType = type;
  value.pNext = next;
  return value;
}

}  // namespace rasterdiff::vkref
