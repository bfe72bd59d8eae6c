// The planes of observed fragment shader built-ins: their names and numbers of components, the same on both sides.
#pragma once

#include <cstdint>
#include <string_view>

#include "scene/vulkan_enums.hpp"

namespace rasterdiff {

/// Vulkan's own name, which is the plane's too.
[[nodiscard]] constexpr std::string_view builtInName(BuiltIn builtIn) {
  switch (builtIn) {
    case BuiltIn::FragCoord: return "FragCoord";
    case BuiltIn::FrontFacing: return "FrontFacing";
    case BuiltIn::PointCoord: return "PointCoord";
    case BuiltIn::SampleMask: return "SampleMask";
    case BuiltIn::SampleId: return "SampleId";
    case BuiltIn::SamplePosition: return "SamplePosition";
  }
  return {};
}

/// Components as 32-bit floats: booleans are 0 or 1, masks and ids are whole numbers.
[[nodiscard]] constexpr uint32_t builtInComponents(BuiltIn builtIn) {
  switch (builtIn) {
    case BuiltIn::FragCoord: return 4;
    case BuiltIn::PointCoord:
    case BuiltIn::SamplePosition: return 2;
    case BuiltIn::FrontFacing:
    case BuiltIn::SampleMask:
    case BuiltIn::SampleId: return 1;
  }
  return 0;
}

}  // namespace rasterdiff
