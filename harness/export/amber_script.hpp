// A scene as an Amber script: what a driver's developers can run without this program. Amber draws it, and every sample
// that the rules determine, and every value's legal interval, is an EXPECT line. [https://github.com/google/amber]
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "rasterizer/rules.hpp"
#include "scene/result.hpp"
#include "scene/scene.hpp"

namespace rasterdiff::harness {

struct AmberScript {
  std::string text;
  uint64_t expected = 0;  ///< samples whose primitive is demanded
  uint64_t free = 0;      ///< samples that the rules leave open: nothing is demanded there
  uint64_t values = 0;    ///< numbers whose interval is demanded
};

/// One sample a pixel: the last primitive of each pixel and its inputs, after the depth test. Several: the samples of each
/// primitive, without depth test and values.
/// `origin`: the command that makes the script, for its head. Error: BadInput for an invalid scene, for one that Amber
/// cannot express and for one that is too large to be written down (amber_limits.hpp).
[[nodiscard]] Result<AmberScript> amberScript(const Scene& scene, const rasterizer::Rules& rules, std::string_view origin);

}  // namespace rasterdiff::harness
