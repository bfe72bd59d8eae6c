// Alpha to coverage: which samples of a fragment its alpha keeps, nominally and at all. [vk:fragops-covg]
#pragma once

#include "scene/frame.hpp"

namespace rasterdiff::rasterizer {

/// [choice:alpha-to-coverage] sample s of n is kept by an alpha above s / n.
[[nodiscard]] inline bool alphaCovers(float alpha, uint32_t sample, uint32_t samples) {
  return alpha > static_cast<float>(sample) / static_cast<float>(samples);
}

/// What every algorithm has to agree on: an alpha of 0 keeps nothing, one of 1 everything.
[[nodiscard]] inline Coverage alphaCoverage(const Bounds& alpha) {
  if (alpha.lo >= 1) return Coverage::In;
  return alpha.hi <= 0 ? Coverage::Out : Coverage::Either;
}

}  // namespace rasterdiff::rasterizer
