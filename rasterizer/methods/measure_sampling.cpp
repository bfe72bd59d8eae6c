// Sampled coverage against exact area, pixel by pixel and as the place of an edge (jaggies).
#include <algorithm>
#include <cmath>

#include "rasterizer/methods/exact_area.hpp"
#include "rasterizer/methods/measure_row.hpp"
#include "rasterizer/methods/method_inputs.hpp"
#include "rasterizer/methods/sampling_methods.hpp"

namespace rasterdiff::rasterizer {
namespace {

double fraction(const SnappedTriangle& triangle, const SamplePoints& points, PixelIndex pixel) {
  return static_cast<double>(coveredSamples(triangle, points, pixel)) / static_cast<double>(points.offsets.size());
}

/// Pixels that the triangle touches, and whose coverage is neither nothing nor all.
void measureBorder(const SnappedTriangle& triangle, const SamplePoints& points, ErrorSum& errors, uint64_t& wrong) {
  const auto& [a, b, c] = triangle.v;
  const auto [left, right] = std::minmax({a.x, b.x, c.x});
  const auto [top, bottom] = std::minmax({a.y, b.y, c.y});
  for (int32_t y = top >> kSubpixelBits; y <= bottom >> kSubpixelBits; ++y) {
    for (int32_t x = left >> kSubpixelBits; x <= right >> kSubpixelBits; ++x) {
      const double exact = coveredArea(triangle, {x, y}).pixels();
      if (exact <= 0 || exact >= 1) continue;
      const double sampled = fraction(triangle, points, {x, y});
      errors.add(sampled - exact);
      wrong += std::lround(sampled * 255) != std::lround(exact * 255) ? 1u : 0u;
    }
  }
}

/// The area below an edge that falls by `fall` pixels over 256 columns: a column's covered height says where the edge
/// seems to be.
void measureEdge(int32_t fall, const SamplePoints& points, ErrorSum& errors, uint64_t& wrong) {
  constexpr int32_t kColumns = 256, kMargin = 4;
  constexpr int32_t kStart = 37;  // 1/256 pixel: the edge starts on no sample
  const int32_t end = kColumns * kSubpixelOne, low = kStart + fall * kSubpixelOne;
  const SnappedTriangle triangle{{{{0, kStart}, {end, low}, {0, low}}}};
  constexpr double kVisible = 1.0 / 16;  // of a pixel
  for (int32_t x = kMargin; x < kColumns - kMargin; ++x) {
    double error = 0;
    for (int32_t y = 0; y <= low >> kSubpixelBits; ++y) {
      error += fraction(triangle, points, {x, y}) - coveredArea(triangle, {x, y}).pixels();
    }
    errors.add(error);
    wrong += std::fabs(error) > kVisible ? 1u : 0u;
  }
}

}  // namespace

void measureSampling(const MethodTableOptions& options, std::vector<MethodRow>& rows) {
  struct Inputs {
    bool hard;
    const char* what;
    SnappedTriangle (*make)(Prng&);
  };
  static constexpr Inputs kInputs[] = {{false, "borders of triangles of 8 to 40 pixels", mediumTriangle},
                                       {true, "slivers", sliverTriangle},
                                       {true, "triangles of a pixel or two", tinyTriangle}};
  for (const SamplingMethod& method : samplingMethods()) {
    for (const Inputs& inputs : kInputs) {
      Prng prng(options.seed);
      ErrorSum errors;
      uint64_t wrong = 0;
      for (uint32_t i = 0; i < options.cases; ++i) measureBorder(inputs.make(prng), method.points, errors, wrong);
      rows.push_back(measuredRow("sampling", method.name, inputs.hard, inputs.what, errors, wrong));
    }
  }
  struct Edge {
    bool hard;
    const char* what;
    int32_t fall;
  };
  static constexpr Edge kEdges[] = {{false, "edge at 45°", 256}, {true, "edge falling 1 in 16", 16}};
  for (const SamplingMethod& method : samplingMethods()) {
    for (const Edge& edge : kEdges) {
      ErrorSum errors;
      uint64_t wrong = 0;
      measureEdge(edge.fall, method.points, errors, wrong);
      rows.push_back(measuredRow("jaggies", method.name, edge.hard, edge.what, errors, wrong));
    }
  }
}

}  // namespace rasterdiff::rasterizer
