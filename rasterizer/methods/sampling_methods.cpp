#include "rasterizer/methods/sampling_methods.hpp"

#include <fmt/format.h>

namespace rasterdiff::rasterizer {
namespace {

std::vector<SamplingMethod> makeMethods() {
  std::vector<SamplingMethod> methods;
  for (int32_t n = 1; n <= kMaxSupersample; n *= 2) {
    methods.push_back(
        {fmt::format("grid-{}x{}", n, n), fmt::format("centres of {} × {} squares", n, n), regularSamples(n)});
  }
  for (uint32_t count = 2; count <= 16; count *= 2) {
    methods.push_back({fmt::format("standard-{}", count), "Vulkan's standard locations", standardSamples(count)});
  }
  return methods;
}

}  // namespace

std::span<const SamplingMethod> samplingMethods() {
  static const std::vector<SamplingMethod> kMethods = makeMethods();
  return kMethods;
}

}  // namespace rasterdiff::rasterizer
