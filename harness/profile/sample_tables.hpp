// Vulkan's standard sample locations as the tables of a profile.
#pragma once

#include "rasterizer/rules.hpp"

namespace rasterdiff::harness {

[[nodiscard]] rasterizer::SampleTables standardTables();

}  // namespace rasterdiff::harness
