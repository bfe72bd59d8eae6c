// Ways to find a triangle's coverage (kernels/coverage_methods.hpp) against integer edge functions at every sample.
#include "rasterizer/kernels/coverage_methods.hpp"
#include "rasterizer/kernels/coverage_oracle.hpp"
#include "rasterizer/methods/measure_row.hpp"
#include "rasterizer/methods/method_inputs.hpp"

namespace rasterdiff::rasterizer {
namespace {

constexpr uint32_t kExtent = 48, kFarPixels = 16000;  // medium triangles reach to 40 pixels

SnappedTriangle tieTriangle(Prng& prng) {
  SnappedTriangle t;
  for (SubpixelPosition& v : t.v) v = {prng.between(0, 80) * (kSubpixelOne / 2), prng.between(0, 80) * (kSubpixelOne / 2)};
  return t;
}

SnappedTriangle farToTheRight(Prng& prng) {
  SnappedTriangle t = mediumTriangle(prng);
  for (SubpixelPosition& v : t.v) v.x += static_cast<int32_t>(kFarPixels) * kSubpixelOne;
  return t;
}

struct Inputs {
  bool hard;
  const char* what;
  SnappedTriangle (*make)(Prng&);
  uint32_t width, samples;
};

constexpr Inputs kInputs[] = {
    {false, "8 to 40 pixels, 1/256 grid", mediumTriangle, kExtent, 1},
    {false, "8 to 40 pixels, 1/256 grid, 4 samples", mediumTriangle, kExtent, 4},
    {true, "½ grid: edges through samples", tieTriangle, kExtent, 1},
    {true, "slivers", sliverTriangle, kExtent, 4},
    {true, "one to two pixels", tinyTriangle, kExtent, 4},
    {true, "16,000 pixels from the origin", farToTheRight, kFarPixels + kExtent, 1},
};

}  // namespace

void measureCoverage(const MethodTableOptions& options, std::vector<MethodRow>& rows) {
  for (const CoverageMethod& method : coverageMethods()) {
    for (const Inputs& inputs : kInputs) {
      Prng prng(options.seed);
      ErrorSum errors;
      uint64_t wrong = 0;
      const Result<CoverageMask> empty = CoverageMask::create(inputs.width, kExtent, inputs.samples);
      if (!empty) continue;
      for (uint32_t i = 0; i < options.cases; ++i) {
        const SnappedTriangle triangle = inputs.make(prng);
        CoverageMask mask = *empty, exact = *empty;
        method.draw({&triangle, 1}, mask);
        drawCoverageOracle({&triangle, 1}, exact);
        const uint64_t differing = mask.differing(exact);
        wrong += differing;
        errors.add(static_cast<double>(differing));
      }
      rows.push_back(measuredRow("coverage", method.name, inputs.hard, inputs.what, errors, wrong));
    }
  }
}

}  // namespace rasterdiff::rasterizer
