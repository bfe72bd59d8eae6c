#include "harness/compare/whole_pixels.hpp"

#include <bit>

namespace rasterdiff::harness {

bool coversWholePixels(const Scene& scene) {
  const State& state = scene.state;
  const bool edges = state.topology >= PrimitiveTopology::TRIANGLE_LIST && state.polygonMode == PolygonMode::LINE;
  const bool lines = state.topology == PrimitiveTopology::LINE_LIST || state.topology == PrimitiveTopology::LINE_STRIP;
  return (lines || edges) && state.lineRasterizationMode == LineRasterizationMode::BRESENHAM && scene.target.samples > 1 &&
         !state.depthTestEnable && !state.alphaToCoverageEnable && state.shaderSampleMask == ShaderSampleMask::NONE;
}

bool pixelIsWhole(const Scene& scene, const Frame& frame, uint32_t x, uint32_t y) {
  const uint32_t kept = scene.state.sampleMask & ((1U << frame.samples) - 1);
  if (kept == 0) return true;
  const auto first = static_cast<uint32_t>(std::countr_zero(kept));
  for (uint32_t s = first; s < frame.samples; ++s) {
    if ((kept >> s & 1U) == 0) continue;
    if (frame.primitive.at(x, y, s) != frame.primitive.at(x, y, first)) return false;
    if (frame.count.at(x, y, s) != frame.count.at(x, y, first)) return false;
  }
  return true;
}

}  // namespace rasterdiff::harness
