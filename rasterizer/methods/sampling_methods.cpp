#include "rasterizer/methods/sampling_methods.hpp"

namespace rasterdiff::rasterizer {
namespace {

std::vector<SamplingMethod> makeMethods() {
  std::vector<SamplingMethod> methods;
  for (int32_t n = 1; n <= kMaxSupersample; n *= 2) {
    const std::string side = std::to_string(n);
    methods.push_back({"grid-" + side + "x" + side, "centres of " + side + " × " + side + " squares", regularSamples(n)});
  }
  for (uint32_t count = 2; count <= 16; count *= 2) {
    const std::string samples = std::to_string(count);
    methods.push_back({"standard-" + samples, "Vulkan's standard locations", standardSamples(count)});
  }
  return methods;
}

}  // namespace

std::span<const SamplingMethod> samplingMethods() {
  static const std::vector<SamplingMethod> kMethods = makeMethods();
  return kMethods;
}

}  // namespace rasterdiff::rasterizer
