#include "rasterizer/fragment/sample_shading.hpp"

#include <algorithm>
#include <cmath>

namespace rasterdiff::rasterizer {

SampleShading sampleShading(const Scene& scene) {
  SampleShading shading;
  const double samples = scene.target.samples;
  if (samples == 1) return shading;
  const bool byBuiltIn = std::any_of(scene.builtIns.begin(), scene.builtIns.end(), [](BuiltIn builtIn) {
    return builtIn == BuiltIn::SampleId || builtIn == BuiltIn::SamplePosition;
  });
  bool bySampleInput = false;
  if (!scene.draws.empty()) {
    const std::vector<Varying>& varyings = scene.draws[0].varyings;
    bySampleInput = std::any_of(varyings.begin(), varyings.end(),
                                [](const Varying& v) { return v.interpolation == Interpolation::sample; });
  }
  shading.enabled = byBuiltIn || scene.state.sampleShadingEnable;
  const double rate = byBuiltIn ? 1 : double{scene.state.minSampleShading};
  const double invocations = shading.enabled ? std::max(1.0, std::ceil(rate * samples)) : 1;
  // A device asked for more than one invocation, or for values at samples, shades every sample on its own.
  shading.perSample = invocations > 1 || bySampleInput;
  shading.certain = shading.enabled ? invocations >= samples : !bySampleInput;
  return shading;
}

}  // namespace rasterdiff::rasterizer
