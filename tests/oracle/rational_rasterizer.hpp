// The oracle: a rasterizer in exact rationals that shares nothing with the reference but the scene. Slow on purpose.
#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <vector>

#include "scene/scene.hpp"

namespace rasterdiff::oracle {

using Rational = boost::multiprecision::cpp_rational;

struct Counts {
  uint64_t samplesTested = 0, ties = 0;
};

/// Winner (1-based) and overdraw per sample for triangle lists inside the view volume: divide, viewport, round to the
/// nearest multiple of 2^-bits (ties to even), half-planes, top-left by moving the sample an infinitesimal (ε, ε²).
struct Masks {
  std::vector<uint32_t> winner, count;  // [(y * width + x) * samples + s]
};
Masks rasterize(const Scene& scene, int bits, Counts& counts);

}  // namespace rasterdiff::oracle
