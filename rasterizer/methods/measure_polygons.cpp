// Polygon methods against the winding number of every pixel centre.
#include "rasterizer/methods/measure_row.hpp"
#include "rasterizer/methods/method_inputs.hpp"
#include "rasterizer/methods/polygon_methods.hpp"

namespace rasterdiff::rasterizer {
namespace {

struct Inputs {
  bool hard;
  const char* what;
  FillRule rule;
  Polygon (*make)(Prng&);
};

constexpr Inputs kInputs[] = {
    {false, "convex, 1/256 grid", FillRule::NonZero, convexPolygon},
    {true, "concave, ½ grid", FillRule::NonZero, concavePolygon},
    {true, "self-crossing, ½ grid, even-odd", FillRule::EvenOdd, crossingPolygon},
    {true, "self-crossing, ½ grid, non-zero", FillRule::NonZero, crossingPolygon},
};

}  // namespace

void measurePolygons(const MethodTableOptions& options, std::vector<MethodRow>& rows) {
  for (const PolygonMethod& method : polygonMethods()) {
    for (const Inputs& inputs : kInputs) {
      Prng prng(options.seed);
      ErrorSum errors;
      uint64_t wrong = 0;
      for (uint32_t i = 0; i < options.cases; ++i) {
        const Polygon polygon = inputs.make(prng);
        const PixelMask exact = drawPolygonByWinding(polygon, inputs.rule, kInputExtent, kInputExtent);
        const Result<PixelMask> mask = method.draw(polygon, inputs.rule, kInputExtent, kInputExtent);
        // A method that refuses a polygon draws nothing.
        const uint64_t differing = exact.differing(mask ? *mask : PixelMask(kInputExtent, kInputExtent));
        wrong += differing;
        errors.add(static_cast<double>(differing));
      }
      rows.push_back(measuredRow("polygon", std::string(method.name), inputs.hard, inputs.what, errors, wrong));
    }
  }
}

}  // namespace rasterdiff::rasterizer
