// Interpolation methods in units of the last place against integer weights in extended precision.
#include "rasterizer/methods/interpolation_methods.hpp"
#include "rasterizer/methods/measure_row.hpp"
#include "rasterizer/methods/method_inputs.hpp"

namespace rasterdiff::rasterizer {
namespace {

struct Inputs {
  bool hard;
  const char* what;
  SnappedTriangle (*make)(Prng&);
  double ratio;  ///< of the largest w to the smallest, for perspective methods
};

constexpr Inputs kInputs[] = {
    {false, "8 to 40 pixels, near the origin", mediumTriangle, 2},
    {true, "slivers", sliverTriangle, 2},
    {true, "16,000 pixels from the origin", farTriangle, 2},
    {true, "w from 1 to 10,000", mediumTriangle, 10'000},
};

}  // namespace

void measureInterpolation(const MethodTableOptions& options, std::vector<MethodRow>& rows) {
  constexpr int kPointsATriangle = 16;
  constexpr double kCorrectlyRounded = 0.5;
  for (const InterpolationMethod& method : interpolationMethods()) {
    for (const Inputs& inputs : kInputs) {
      if (!method.perspective && inputs.ratio > 2) continue;
      Prng prng(options.seed);
      ErrorSum errors;
      uint64_t wrong = 0;
      for (uint32_t i = 0; i < options.cases; ++i) {
        const SnappedTriangle shape = inputs.make(prng);
        const InterpolatedTriangle triangle = withValues(shape, method.perspective ? inputs.ratio : 1, prng);
        for (int k = 0; k < kPointsATriangle; ++k) {
          const SubpixelPosition p = pointInside(shape, prng);
          const double error = ulpsFrom(interpolateExactly(triangle, p, method.perspective), method.at(triangle, p));
          wrong += error > kCorrectlyRounded ? 1u : 0u;
          errors.add(error);
        }
      }
      rows.push_back(measuredRow("interpolation", std::string(method.name), inputs.hard, inputs.what, errors, wrong));
    }
  }
}

}  // namespace rasterdiff::rasterizer
