// What a scene's rules determine, as Amber's EXPECT commands; what they leave open is not mentioned.
#pragma once

#include <cstdint>
#include <string>

#include "rasterizer/rules.hpp"
#include "scene/result.hpp"
#include "scene/scene.hpp"

namespace rasterdiff::harness {

struct AmberExpectations {
  std::string commands;
  uint64_t expected = 0, free = 0, values = 0;  ///< as in AmberScript
};

/// One sample a pixel. Buffer "drawn" holds primitives, 0 where there is none; "drawnV" the four components of varying V.
[[nodiscard]] Result<AmberExpectations> expectedPixels(const Scene& scene, const rasterizer::Rules& rules);

/// Several samples. Buffer "masks" holds the samples of each primitive at each pixel (amberMaskShader).
[[nodiscard]] Result<AmberExpectations> expectedMasks(const Scene& scene, const rasterizer::Rules& rules);

}  // namespace rasterdiff::harness
