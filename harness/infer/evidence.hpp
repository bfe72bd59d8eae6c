// One experiment: a scene and what the driver made of it, against what candidate rules make of it.
#pragma once

#include "rasterizer/render.hpp"

namespace rasterdiff::harness {

struct Observation {
  Scene scene;
  Frame actual;
};

/// Samples (and resolved pixels) at which rules contradict the driver: another primitive, another count, or a value
/// outside of its interval; with `tolerance` > 0, a value farther than that from the nominal one instead.
/// Error: what rendering the scene says.
[[nodiscard]] Result<uint64_t> contradictions(const Observation& observation, const rasterizer::Rules& rules,
                                              double tolerance = 0);

/// Do two frames of the reference differ in a sample's primitive or count, or in a value?
[[nodiscard]] bool differ(const Frame& a, const Frame& b);

}  // namespace rasterdiff::harness
