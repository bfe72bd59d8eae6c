// How often the fragment shader runs for a fragment: what a scene asks for, and what a device may do beyond it.
// [vk:primsrast-sampleshading]
#pragma once

#include "scene/scene.hpp"

namespace rasterdiff::rasterizer {

struct SampleShading {
  bool enabled = false;    ///< by state or by a built-in: FragCoord is at a sample
  bool perSample = false;  ///< nominally one invocation for each covered sample
  bool certain = true;     ///< the number of invocations is the least one: no device may group samples otherwise
};

[[nodiscard]] SampleShading sampleShading(const Scene& scene);

}  // namespace rasterdiff::rasterizer
