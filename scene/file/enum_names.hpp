// Vulkan's enumerant names as they stand in scene files.
#pragma once

#include <span>
#include <string_view>

#include "scene/vulkan_enums.hpp"

namespace rasterdiff {

template <class E>
struct EnumName {
  std::string_view name;
  E value;
};

/// All names of an enumeration of scene/vulkan_enums.hpp.
template <class E>
[[nodiscard]] std::span<const EnumName<E>> enumNames();

/// The name of an enumerant; empty for a value that has none.
template <class E>
[[nodiscard]] std::string_view enumName(E value) {
  for (const EnumName<E>& entry : enumNames<E>()) {
    if (entry.value == value) return entry.name;
  }
  return {};
}

}  // namespace rasterdiff
