// Ways to sample a pixel, by name: n × n grids and Vulkan's standard patterns.
#pragma once

#include <span>
#include <string>

#include "rasterizer/methods/supersample.hpp"

namespace rasterdiff::rasterizer {

struct SamplingMethod {
  std::string name, what;
  SamplePoints points;
};

/// "grid-1x1" ... "grid-32x32" (1, 2, 4, 8, 16, 32 a side), "standard-2" ... "standard-16".
[[nodiscard]] std::span<const SamplingMethod> samplingMethods();

}  // namespace rasterdiff::rasterizer
